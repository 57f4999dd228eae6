#include "app/documents/autosave.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <functional>
#include <random>
#include <system_error>
#include <utility>

#include <unistd.h>

#include <nlohmann/json.hpp>

#include "app/documents/stored_scene.h"
#include "app/documents/unsaved_work.h"
#include "app/files/files.h"
#include "app/files/state_folder.h"
#include "app/version.h"
#include "base/caught_error.h"
#include "scene/settings/scene_diff.h"
#include "scene/settings/settings.h"

namespace isolux::app {

namespace fs = std::filesystem;
using base::throwInput;
using nlohmann::json;
using std::chrono::system_clock;

namespace {

constexpr int autosaveVersion = 1;
constexpr std::size_t longestAutosave = std::size_t{1} << 30;  // bytes
constexpr auto autosaveSuffix = ".autosave";
constexpr auto damagedSuffix = ".damaged";

json changesOf(const scene::SceneDiff& diff) {
  json changes = json::object();
  for (const scene::SceneChange& change : diff.changes) changes[change.path] = change.value;
  return changes;
}

scene::SceneDiff diffOf(const std::string& name, const json& changes) {
  scene::SceneDiff diff{name, {}};
  for (const auto& [path, value] : changes.items()) diff.changes.push_back({path, value});
  return diff;
}

// The members of an object, each of the type that is asked for.
class Members {
 public:
  Members(const json& object, const std::string& file, std::string place)
      : object_(object), file_(file), place_(std::move(place)) {
    if (!object_.is_object()) throwInput(file_, place_, "a JSON object was expected");
  }
  const json& at(const char* key) const {
    const auto found = object_.find(key);
    if (found == object_.end()) throwInput(file_, placeOf(key), "is missing");
    return *found;
  }
  std::string text(const char* key) const {
    if (!at(key).is_string()) throwInput(file_, placeOf(key), "must be a text");
    return at(key).get<std::string>();
  }
  std::int64_t count(const char* key) const {
    const json& value = at(key);
    constexpr std::int64_t most = std::int64_t{1} << 40;
    if (!value.is_number_integer() || value < 0 || value > most)
      throwInput(file_, placeOf(key), "must be a whole number that is not negative");
    return value.get<std::int64_t>();
  }
  const json& object(const char* key) const {
    if (!at(key).is_object()) throwInput(file_, placeOf(key), "must be an object");
    return at(key);
  }
  std::string placeOf(const char* key) const { return place_.empty() ? key : place_ + ", " + key; }

 private:
  const json& object_;
  const std::string& file_;
  std::string place_;
};

scene::Scene sceneOf(const Members& members, const char* key, const std::string& file) {
  try {
    return scene::fromJson(members.object(key));
  } catch (const base::Error& error) {
    throwInput(file, members.placeOf(key) + "." + error.place(), error.reason());
  }
}

History historyOf(const Members& members, const std::string& file) {
  const json& stored = members.at("steps");
  const auto position = static_cast<std::size_t>(members.count("position"));
  if (!stored.is_array() || position > stored.size())
    throwInput(file, "steps", "must be a list of at least \"position\" steps");
  History::Steps steps;
  for (const json& entry : stored) {
    const Members step(entry, file, "steps " + std::to_string(steps.size() + 1));
    const std::string name = step.text("name");
    steps.push_back(std::make_shared<const History::Step>(
        History::Step{diffOf(name, step.object("back")), diffOf(name, step.object("forth"))}));
  }
  try {
    return {sceneOf(members, "scene", file), std::move(steps), position};
  } catch (const base::Error& error) {
    if (!error.file().empty()) throw;
    throwInput(file, "steps, " + error.place(), error.reason());
  }
}

// Not used by any other window, past or present: a lock's name must never come back with another owner.
std::string uniqueName() {
  std::random_device random;
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%ld-%08x%08x", static_cast<long>(::getpid()), random(), random());
  return text.data();
}

fs::path lockOf(fs::path autosave) {
  return autosave.replace_extension(".lock");
}

// What a process that was killed while it wrote this autosave has left.
void removeUnfinished(const fs::path& autosave) {
  const std::string prefix = "." + autosave.filename().string() + ".";
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(autosave.parent_path(), ignored)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(prefix) && name.ends_with(".part")) fs::remove(entry.path(), ignored);
  }
}

}  // namespace

bool worthKeeping(const OpenDocument& document) {
  const History& history = document.history;
  return !history.scene().source.path.starts_with("phantom:") || !document.sessionFile.empty() ||
         history.canUndo() || history.canRedo() ||
         unsavedWork(document.saved, history.scene()) != UnsavedWork::none;
}

// ---- Text

std::string autosaveText(const Autosave& autosave) {
  const OpenDocument& document = autosave.document;
  json text;
  text["isolux_autosave"] = autosaveVersion;
  text["program"] = version();
  text["time"] = std::chrono::duration_cast<std::chrono::seconds>(autosave.time.time_since_epoch()).count();
  text["name"] = document.name;
  text["session_file"] = document.sessionFile;
  text["recording"] = document.recordingFile;
  text["scene"] = scene::toJson(document.history.scene());
  text["saved"] = scene::toJson(document.saved);
  text["position"] = document.history.position();
  json& steps = text["steps"] = json::array();
  for (const auto& step : document.history.steps())
    steps.push_back(
        {{"name", step->forth.name}, {"back", changesOf(step->back)}, {"forth", changesOf(step->forth)}});
  return text.dump(-1, ' ', false, json::error_handler_t::replace) + '\n';
}

Autosave parseAutosave(const std::string& text, const std::string& file) {
  const json stored = parseJson(text, file, "");
  const Members members(stored, file, "");
  if (members.count("isolux_autosave") != autosaveVersion)
    throwInput(file, "isolux_autosave", "this Isolux reads autosaves of version 1 only");
  Autosave autosave;
  autosave.time = system_clock::time_point(std::chrono::seconds(members.count("time")));
  OpenDocument& document = autosave.document;
  document.name = members.text("name");
  document.sessionFile = members.text("session_file");
  document.recordingFile = members.text("recording");
  document.saved = sceneOf(members, "saved", file);
  document.history = historyOf(members, file);
  return autosave;
}

std::string agoText(system_clock::duration age) {
  const auto seconds =
      std::max<std::int64_t>(std::chrono::duration_cast<std::chrono::seconds>(age).count(), 0);
  constexpr std::int64_t minute = 60, hour = 3600, day = 86400;
  if (seconds < minute) return std::to_string(seconds) + " s ago";
  if (seconds < hour) return std::to_string(seconds / minute) + " min ago";
  if (seconds < 2 * day) return std::to_string(seconds / hour) + " h ago";
  return std::to_string(seconds / day) + " days ago";
}

// ---- One's own

AutosaveFile::AutosaveFile(fs::path folder)
    : folder_(std::move(folder)),
      file_(folder_ / (uniqueName() + autosaveSuffix)),
      lockFile_(lockOf(file_)) {}

void AutosaveFile::write(OpenDocument document) {
  request(std::move(document));
}

void AutosaveFile::remove() {
  if (worker_.joinable()) request(std::nullopt);
}

void AutosaveFile::request(std::optional<OpenDocument> document) {
  {
    const std::lock_guard lock(mutex_);
    wanted_ = std::move(document);
    requested_ = true;
  }
  changed_.notify_all();
  if (worker_.joinable()) return;
  try {
    worker_ = std::jthread([this](const std::stop_token& stop) { work(stop); });
  } catch (
      const std::system_error& error) {  // the system grants no thread: nothing is kept, and that is said
    const std::lock_guard lock(mutex_);
    requested_ = false;
    problem_.emplace(base::ErrorKind::memory, file_.string(), "", error.code().message());
  }
}

void AutosaveFile::finish() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return !requested_ && !working_; });
}

std::optional<base::Error> AutosaveFile::problem() {
  const std::lock_guard lock(mutex_);
  return problem_;
}

void AutosaveFile::work(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (changed_.wait(lock, stop, [this] { return requested_; })) {
    const std::optional<OpenDocument> wanted = std::exchange(wanted_, std::nullopt);
    requested_ = false;
    working_ = true;
    lock.unlock();
    std::optional<base::Error> problem =
        base::caughtError(file_.string(), "keep the document", [&] { fulfil(wanted); });
    lock.lock();
    working_ = false;
    problem_ = std::move(problem);
    changed_.notify_all();
  }
}

void AutosaveFile::fulfil(const std::optional<OpenDocument>& document) {
  if (!document) {
    std::error_code ignored;
    fs::remove(file_, ignored);
    if (lock_) fs::remove(lockFile_, ignored);
    lock_.reset();
    return;
  }
  makePrivateFolder(folder_);
  if (!lock_) lock_ = tryLock(lockFile_);
  if (!lock_) throwInput(lockFile_.string(), "", "cannot be locked");
  writeTextFile(file_, autosaveText({*document, system_clock::now()}));
}

// ---- Those of others

void LostAutosave::discard() {
  std::error_code ignored;
  fs::remove(file, ignored);
  removeUnfinished(file);
  fs::remove(lockOf(file), ignored);
}

LostAutosaves takeLostAutosaves(const fs::path& folder) {
  LostAutosaves lost;
  std::error_code ignored;
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
    if (entry.path().extension() == autosaveSuffix) files.push_back(entry.path());
  for (const fs::path& file : files) {
    FileLock lock = tryLock(lockOf(file));
    if (!lock) continue;               // its window lives
    if (!fs::exists(file, ignored)) {  // closed in this moment
      fs::remove(lockOf(file), ignored);
      continue;
    }
    try {
      lost.found.push_back(
          {parseAutosave(readTextFile(file, longestAutosave), file.string()), file, std::move(lock)});
    } catch (const std::exception&) {
      fs::path aside = file;
      aside += damagedSuffix;
      fs::rename(file, aside, ignored);
      fs::remove(lockOf(file), ignored);
      lost.damaged.push_back(std::move(aside));
    }
  }
  std::ranges::sort(lost.found, std::greater(), [](const LostAutosave& one) { return one.content.time; });
  return lost;
}

}  // namespace isolux::app
