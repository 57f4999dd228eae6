#include "volume/large/index_file.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <system_error>

#include <unistd.h>

#include "base/error.h"
#include "base/hash.h"
#include "base/pending_file.h"
#include "volume/read/input/bytes.h"
#include "volume/read/source_files.h"

namespace isolux::volume {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kIndexMagic = "ISOLUX INDEX 1\n";
constexpr std::chrono::seconds kBetweenSaves{20};

// What is read, and a hash of names, sizes and times of all files it is read from: a store has millions.
std::string identityOf(const std::string& path, const ReadOptions& options) {
  std::string text = options.raw + '\n' + options.series + '\n' + std::to_string(options.component) + '\n' +
                     std::to_string(options.timeStep) + '\n';
  std::vector<fs::path> files = filesOfVolume(path);
  if (std::error_code ignored; fs::is_directory(path, ignored)) files.emplace_back(path);
  std::ranges::sort(files);
  const fs::path folder = fs::path(path).parent_path();
  base::Hasher hash;
  for (const fs::path& file : files) {
    std::error_code failed;
    const std::string name = file.lexically_relative(folder).string();
    hash.addWords(name.data(), name.size()).add(fs::last_write_time(file, failed).time_since_epoch().count());
    if (fs::is_regular_file(file, failed)) hash.add(fs::file_size(file, failed));
  }
  return text + std::to_string(hash) + '\n';
}

fs::path cachePlace(const fs::path& path) {
  fs::path folder;
  if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache != nullptr && *cache == '/')
    folder = cache;
  else if (const char* home = std::getenv("HOME"); home != nullptr && *home == '/')
    folder = fs::path(home) / ".cache";
  else
    folder = fs::temp_directory_path();
  std::error_code ignored;
  const std::string whole = fs::weakly_canonical(path, ignored).string();
  const std::uint64_t key = base::Hasher().addWords(whole.data(), whole.size());
  return folder / "isolux" / "index" / (path.filename().string() + "-" + std::to_string(key) + ".index");
}

fs::path placeOf(const std::string& path) {
  fs::path file(path);
  if (!file.has_filename()) file = file.parent_path();  // "folder/"
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  fs::path beside = file;
  beside += ".index";
  return ::access(folder.c_str(), W_OK) == 0 ? beside : cachePlace(file);
}

}  // namespace

IndexFile::IndexFile(const std::string& path, const ReadOptions& options, fs::path place)
    : part_{options.timeStep, options.component},
      identity_(identityOf(path, options)),
      place_(place.empty() ? placeOf(path) : std::move(place)) {}

fs::path IndexFile::partPath(IndexPart part) const {
  fs::path path = place_;
  return path += ".part-" + std::to_string(part.i) + "-of-" + std::to_string(part.n);
}

std::vector<fs::path> IndexFile::partFiles() const {
  const fs::path folder = place_.has_parent_path() ? place_.parent_path() : fs::path(".");
  const std::string start = place_.filename().string() + ".part-";
  std::vector<fs::path> found;
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(folder, failed))
    if (entry.path().filename().string().starts_with(start)) found.push_back(entry.path());
  std::ranges::sort(found);
  return found;
}

void IndexFile::save(const VolumeIndex& index, const fs::path& to) const {
  if (to.has_parent_path()) {
    std::error_code failed;
    fs::create_directories(to.parent_path(), failed);
  }
  base::OutputFile out(to);
  base::Hasher sum;
  const auto put = [&](const void* bytes, std::size_t count) {
    out.write(bytes, count);
    sum.addWords(bytes, count);
  };
  put(kIndexMagic.data(), kIndexMagic.size());
  const std::uint64_t length = identity_.size();
  put(&length, sizeof length);
  put(identity_.data(), identity_.size());
  index.write(put);
  const std::uint64_t hash = sum;
  out.write(&hash, sizeof hash);
  out.commit();
}

std::optional<VolumeIndex> IndexFile::load(const fs::path& from, const ChunkedVolume& file) const {
  std::error_code failed;
  if (!fs::is_regular_file(from, failed)) return std::nullopt;
  try {
    const FileBytes bytes(from);
    const std::size_t least = kIndexMagic.size() + 2 * sizeof(std::uint64_t) + identity_.size();
    VolumeIndex index(file.facts(), part_);
    if (bytes.size() < least || bytes.size() > least + index.mostBytes()) return std::nullopt;
    std::vector<std::byte> all(static_cast<std::size_t>(bytes.size()));
    bytes.read(0, all);
    std::uint64_t length = 0, hash = 0;
    const std::byte* at = all.data();
    if (std::memcmp(at, kIndexMagic.data(), kIndexMagic.size()) != 0) return std::nullopt;
    at += kIndexMagic.size();
    std::memcpy(&length, at, sizeof length);
    at += sizeof length;
    if (length != identity_.size() || std::memcmp(at, identity_.data(), length) != 0) return std::nullopt;
    at += length;
    const std::size_t content = all.size() - static_cast<std::size_t>(at - all.data()) - sizeof hash;
    std::memcpy(&hash, at + content, sizeof hash);
    base::Hasher sum;
    sum.addWords(kIndexMagic.data(), kIndexMagic.size());
    sum.addWords(&length, sizeof length);
    sum.addWords(identity_.data(), identity_.size());
    if (!index.read({at, content}, sum) || hash != sum || isRepaired(file, part_, index.damaged()))
      return std::nullopt;
    return index;
  } catch (const base::Error& error) {
    if (error.kind() == base::ErrorKind::memory) throw;
    return std::nullopt;
  }
}

std::optional<VolumeIndex> IndexFile::find(const ChunkedVolume& file) const {
  std::optional<VolumeIndex> index = load(place_, file);
  if (index && !index->isComplete()) index.reset();
  return index;
}

fs::path IndexFile::make(const ChunkedVolume& file, IndexPart part, std::optional<VolumeIndex>& index,
                         base::Progress& progress) const {
  index.emplace(file.facts(), part_);
  const fs::path own = partPath(part);
  std::vector<fs::path> taken;
  for (const fs::path& from : part.n == 1 ? partFiles() : std::vector{own})
    if (const std::optional<VolumeIndex> kept = load(from, file)) {
      index->join(*kept);
      taken.push_back(from);
    }
  auto saved = std::chrono::steady_clock::now();
  const auto keep = [&] {
    if (std::chrono::steady_clock::now() - saved < kBetweenSaves) return;
    save(*index, own);
    saved = std::chrono::steady_clock::now();
  };
  try {
    index->scan(file, part, progress, keep);
  } catch (const base::Error&) {
    if (index->unitsDone() > 0) save(*index, own);
    throw;
  }
  if (part.n > 1) {
    save(*index, own);
    return own;
  }
  index->finish(file, progress);
  save(*index, place_);
  taken.push_back(own);
  std::error_code ignored;
  for (const fs::path& done : taken) fs::remove(done, ignored);
  return place_;
}

}  // namespace isolux::volume
