#include "app/documents/places.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <random>
#include <thread>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/documents/path_text.h"
#include "app/files/file_lock.h"
#include "app/files/files.h"
#include "app/files/state_folder.h"
#include "base/error.h"
#include "volume/read/step_files.h"

namespace isolux::app {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr std::size_t longestList = std::size_t{16} << 20;  // bytes
constexpr std::size_t mostPlaces = 2000;

using Places = std::vector<std::pair<std::string, std::string>>;  // token, path

fs::path listFile() {
  const fs::path folder = stateFolder();
  return folder.empty() ? fs::path() : folder / "places.json";
}

// A list that cannot be read is as good as none: it is written anew.
Places readPlaces(const fs::path& file) {
  try {
    return json::parse(readTextFile(file, longestList)).get<Places>();
  } catch (const base::Error&) {
    return {};
  } catch (const json::exception&) {
    return {};
  }
}

std::string newToken() {
  std::random_device random;
  std::array<char, 20> text{};
  std::snprintf(text.data(), text.size(), "%08x%08x", random(), random());
  return text.data();
}

// Held by other processes for milliseconds only.
FileLock lockList(const fs::path& file) {
  for (int attempt = 0; attempt < 50; ++attempt) {
    if (FileLock lock = tryLock(file)) return lock;
    std::this_thread::sleep_for(std::chrono::milliseconds(4));
  }
  return nullptr;
}

}  // namespace

std::string placeToken(const fs::path& file) {
  const fs::path list = listFile();
  if (list.empty()) return {};
  try {
    makePrivateFolder(list.parent_path());
    const auto lock = lockList(list.parent_path() / "places.lock");
    if (!lock) return {};
    Places places = readPlaces(list);
    const std::string path = pathText(file.string());
    const auto known = std::ranges::find_if(places, [&](const auto& place) { return place.second == path; });
    if (known != places.end() && known + 1 == places.end()) return known->first;
    std::string token = known == places.end() ? newToken() : known->first;
    if (known != places.end()) places.erase(known);
    places.emplace_back(token, path);
    if (places.size() > mostPlaces) places.erase(places.begin());
    writeTextFile(list, json(places).dump(0, ' ', false, json::error_handler_t::replace) + '\n');
    return token;
  } catch (const base::Error&) {
    return {};  // the picture can still be opened beside its volume
  }
}

fs::path placeOf(const std::string& token) {
  const fs::path list = listFile();
  if (token.empty() || list.empty()) return {};
  for (const auto& [known, text] : readPlaces(list)) {
    std::error_code ignored;
    const fs::path path = pathOfText(text);
    if (known == token && (fs::exists(path, ignored) || !volume::stepFiles(path.string()).empty()))
      return path;
  }
  return {};
}

}  // namespace isolux::app
