#include "app/documents/recording.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/documents/session.h"
#include "app/documents/stored_scene.h"
#include "app/files/files.h"
#include "app/version.h"
#include "base/clock.h"
#include "base/error.h"
#include "scene/settings/scene_diff.h"

namespace isolux::app {

namespace fs = std::filesystem;
using base::throwInput;
using nlohmann::json;

namespace {

constexpr int recordingVersion = 7;
// The version of sessions whose scenes a version of recordings has.
constexpr std::array<int, recordingVersion> kSessionVersions{3, 4, 6, 7, 8, 9, sessionVersion};
constexpr double longestSeconds = 1e6;
constexpr std::size_t longestFile = std::size_t{1} << 30;  // bytes

std::string line(const json& json) {
  return json.dump(-1, ' ', false, json::error_handler_t::replace) + '\n';
}

scene::Scene startOf(const json& header, const std::string& file, const StoredFolders& folders) {
  const std::string place = "line 1";
  checkKeys(header, {"isolux_recording", "program", "scene"}, file, place);
  const auto found = header.find("isolux_recording");
  if (found == header.end()) throwInput(file, place, "is not a recording: \"isolux_recording\" is missing");
  if (!found->is_number_integer() || *found < 1 || *found > recordingVersion)
    throwInput(file, place, "this Isolux reads recordings of versions 1 to 7 only");
  const int written = kSessionVersions.at(found->get<std::size_t>() - 1);
  const json scene = sceneOfVersion(written, header.value("scene", json::object()));
  return sceneFromStored(scene, file, place + ", scene", folders);
}

// `before`: the scene to which the step is applied, which becomes that after it.
Recording::Step stepOf(const json& entry, const std::string& file, const std::string& place,
                       const StoredFolders& folders, scene::Scene& before) {
  checkKeys(entry, {"time", "name", "set"}, file, place);
  Recording::Step step{};
  const auto time = entry.find("time");
  if (time == entry.end() || !time->is_number())
    throwInput(file, place, "\"time\" must be a number of seconds");
  step.seconds = time->get<double>();
  if (!(step.seconds >= 0.0) || step.seconds > longestSeconds)
    throwInput(file, place, "\"time\" must be from 0 to 1000000 seconds");
  if (const auto name = entry.find("name"); name != entry.end()) {
    if (!name->is_string()) throwInput(file, place, "\"name\" must be a text");
    step.diff.name = name->get<std::string>();
  }
  const auto set = entry.find("set");
  if (set == entry.end() || !set->is_object())
    throwInput(file, place, "\"set\" must be an object of settings");
  for (const auto& [path, value] : set->items()) step.diff.changes.push_back({path, value});
  try {
    before = scene::applied(std::move(before), step.diff);
    for (auto& [path, value] : step.diff.changes) value = scene::setting(path).get(before);
  } catch (const base::Error& error) {
    throwInput(file, place + ", " + error.place(), error.reason());
  }
  for (auto& [path, value] : step.diff.changes)
    if (isStoredPath(path)) value = pathFromStored(value.get<std::string>(), folders);
  return step;
}

}  // namespace

void checkMayRecordInto(const fs::path& file) {
  if (!readBeginning(file, 1).empty() && !isRecording(file))
    throwInput(file.string(), "", "is not a recording and is not overwritten");
}

Recorder::Recorder(const fs::path& file, const scene::Scene& start)
    : file_(file), begin_(std::chrono::steady_clock::now()) {
  checkMayRecordInto(file);
  stream_.open(file, std::ios::binary);
  json header;
  header["isolux_recording"] = recordingVersion;
  header["program"] = version();
  header["scene"] = storedScene(start, file_.parent_path());
  write(line(header));
}

void Recorder::add(const scene::SceneDiff& diff) {
  add(diff, base::secondsSince(begin_));
}

void Recorder::add(const scene::SceneDiff& diff, double seconds) {
  if (diff.changes.empty()) return;
  json entry;
  // To the millisecond: nobody acts faster, and the lines stay readable.
  entry["time"] = std::round(std::max(seconds, 0.0) * 1000.0) / 1000.0;
  entry["name"] = diff.name;
  json& set = entry["set"] = json::object();
  for (const scene::SceneChange& change : diff.changes) {
    const bool path = isStoredPath(change.path) && change.value.is_string();
    set[change.path] =
        path ? json(storedPath(change.value.get<std::string>(), file_.parent_path())) : change.value;
  }
  write(line(entry));
}

void Recorder::write(const std::string& text) {
  if (stream_.is_open()) errno = 0;  // else why it could not be opened
  stream_ << text << std::flush;
  if (!stream_) base::throwCannotWrite(file_, errno);
}

Playback::Playback(const Recording& recording)
    : recording_(recording), scene_(recording.start), clock_(recording.start) {}

const scene::Scene& Playback::at(double seconds) {
  constexpr double slack =
      1e-9;  // a change at exactly n/fps is in frame n for every rounding of the quotient
  const std::vector<Recording::Step>& steps = recording_.steps;
  const auto advanceTo = [this](double time) {
    clock_.advance(std::max(time - now_, 0.0));
    now_ = std::max(time, now_);
  };
  for (; next_ < steps.size() && steps[next_].seconds <= seconds + slack; ++next_) {
    advanceTo(steps[next_].seconds);
    scene_ = scene::applied(std::move(scene_), steps[next_].diff);
    clock_.setScene(scene_);
  }
  advanceTo(seconds);
  shown_ = scene_;
  shown_.flow.time = clock_.seconds();
  return shown_;
}

Recording loadRecording(const fs::path& file) {
  const std::string name = file.string();
  const std::string text = readTextFile(file, longestFile);
  const StoredFolders folders = foldersOf(file);
  Recording recording;
  scene::Scene shown;
  std::size_t number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string lineText = text.substr(begin, end - begin);
    begin = end + 1;
    const std::string place = "line " + std::to_string(++number);
    if (number > 1 && lineText.find_first_not_of(" \t\r") == std::string::npos) continue;
    const bool mayBeCut = number > 1 && end == text.size();  // no line's end behind it
    if (mayBeCut && !json::accept(lineText)) {
      recording.warnings.push_back(place + " is cut short and is left out");
      break;
    }
    const json entry = parseJson(lineText, name, place);
    if (number == 1) {
      shown = recording.start = startOf(entry, name, folders);
      continue;
    }
    recording.steps.push_back(stepOf(entry, name, place, folders, shown));
    const auto& steps = recording.steps;
    if (steps.size() > 1 && steps.back().seconds < steps[steps.size() - 2].seconds)
      throwInput(name, place, "\"time\" is before that of the line above");
  }
  if (number == 0) throwInput(name, "line 1", "the file is empty");
  return recording;
}

bool isRecording(const fs::path& file) {
  constexpr std::size_t searched = std::size_t{1} << 20;
  const std::string beginning = readBeginning(file, searched);
  const std::string first = beginning.substr(0, beginning.find('\n'));
  const auto brace = first.find_first_not_of(" \t\r");
  return brace != std::string::npos && first[brace] == '{' &&
         first.find("\"isolux_recording\"") != std::string::npos;
}

}  // namespace isolux::app
