#include "app/files/files.h"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <system_error>

#include "base/error.h"

namespace isolux::app {

namespace fs = std::filesystem;
using base::throwInput;

namespace {

std::string systemReason(int code) {
  return code ? std::generic_category().message(code) : "input/output error";
}

}  // namespace

MadeFolder::MadeFolder(fs::path folder) : path_(std::move(folder)) {
  std::error_code error;
  for (fs::path level = path_; !level.empty() && !fs::exists(level, error); level = level.parent_path())
    if (level.has_filename()) made_.push_back(level);
  fs::create_directories(path_, error);
  if (error || !fs::is_directory(path_, error)) {
    removeMade();
    throwInput(path_.string(), "", "is not a folder and cannot be made one");
  }
}

MadeFolder::~MadeFolder() {
  removeMade();
}

void MadeFolder::removeMade() const noexcept {
  std::error_code notEmpty;  // a folder with something in it stays
  for (const fs::path& level : made_) fs::remove(level, notEmpty);
}

void writeTextFile(const fs::path& file, std::string_view text) {
  base::OutputFile output(file);
  output.write(text);
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
