#include "app/files.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdint>
#include <fstream>
#include <mutex>
#include <system_error>
#include <vector>

#include <unistd.h>

#include "scene/error.h"

namespace isolux::app {

namespace fs = std::filesystem;
using scene::throwInput;

namespace {

struct Pending {
  std::mutex mutex;
  std::vector<fs::path> paths;
};

// Never destroyed: an interrupt may come while the program's statics go away.
Pending& pending() {
  static Pending* const list = new Pending;
  return *list;
}

std::string systemReason(int code) {
  return code ? std::generic_category().message(code) : "input/output error";
}

}  // namespace

PendingFile::PendingFile(fs::path target) : target_(std::move(target)) {
  std::error_code ignored;
  const fs::file_status status = fs::status(target_, ignored);
  if (fs::is_directory(status)) throwInput(target_.string(), "", "is a folder, not a file to write");
  if (fs::exists(status) && !fs::is_regular_file(status))
    throwInput(target_.string(), "", "is not a regular file");
  if (target_.filename().empty()) throwInput(target_.string(), "", "is not the name of a file");
  const fs::path folder = target_.has_parent_path() ? target_.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, ignored))
    throwInput(target_.string(), "", "cannot be written: its folder does not exist");
  if (::access(folder.c_str(), W_OK | X_OK) != 0)
    throwInput(target_.string(), "", "cannot be written: " + systemReason(errno));

  static std::atomic<unsigned> count{0};
  path_ = folder / ("." + target_.filename().string() + "." + std::to_string(::getpid()) + "-" +
                    std::to_string(count++) + ".part");
  const std::lock_guard lock(pending().mutex);
  pending().paths.push_back(path_);
}

PendingFile::~PendingFile() {
  const std::lock_guard lock(pending().mutex);
  const auto found = std::find(pending().paths.begin(), pending().paths.end(), path_);
  if (found == pending().paths.end()) return;  // committed
  pending().paths.erase(found);
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

void PendingFile::commit() {
  const std::lock_guard lock(pending().mutex);
  std::error_code error;
  fs::rename(path_, target_, error);
  if (error) throwInput(target_.string(), "", "cannot be written: " + error.message());
  std::erase(pending().paths, path_);
}

void removePendingFiles() noexcept {
  // Not waiting: the thread that holds the lock may be in a slow rename, and its file is then complete.
  const std::unique_lock lock(pending().mutex, std::try_to_lock);
  std::error_code ignored;
  if (lock.owns_lock())
    for (const fs::path& path : pending().paths) fs::remove_all(path, ignored);
}

void writeTextFile(const fs::path& file, std::string_view text) {
  PendingFile output(file);
  errno = 0;
  std::ofstream stream(output.path(), std::ios::binary);
  stream.write(text.data(), static_cast<std::streamsize>(text.size()));
  stream.close();
  if (!stream) throwInput(file.string(), "", "cannot be written: " + systemReason(errno));
  output.commit();
}

std::string readTextFile(const fs::path& file, std::size_t longest) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (!fs::exists(status)) throwInput(file.string(), "", "does not exist");
  if (!fs::is_regular_file(status)) throwInput(file.string(), "", "is not a regular file");
  const std::uintmax_t bytes = fs::file_size(file, error);
  if (error || bytes > longest)
    throwInput(file.string(), "",
               "is longer than the " + std::to_string(longest >> 20) + " MiB expected here at most");
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throwInput(file.string(), "", "cannot be read: " + systemReason(errno));
  std::string text(static_cast<std::size_t>(bytes), '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(std::max<std::streamsize>(stream.gcount(), 0)));
  if (stream.bad()) throwInput(file.string(), "", "cannot be read: " + systemReason(errno));
  return text;
}

std::string readBeginning(const fs::path& file, std::size_t longest) {
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) return {};
  std::ifstream stream(file, std::ios::binary);
  std::string text(longest, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(longest));
  text.resize(static_cast<std::size_t>(std::max<std::streamsize>(stream.gcount(), 0)));
  return text;
}

}  // namespace isolux::app
