#include "volume/read/step_files.h"

#include <algorithm>
#include <filesystem>
#include <string_view>

#include "base/error.h"
#include "base/words.h"
#include "volume/read/file_format.h"
#include "volume/read/input/bytes.h"
#include "volume/read/input/text.h"
#include "volume/read/tiff/tiff_pages.h"

namespace isolux::volume {

namespace fs = std::filesystem;

namespace {

constexpr char kBetween = ';', kAny = '*';

// Whether the name is the pattern with characters for each '*'.
bool matches(std::string_view name, std::string_view pattern) {
  const std::size_t any = pattern.find(kAny);
  if (any == std::string_view::npos) return name == pattern;
  if (!name.starts_with(pattern.substr(0, any))) return false;
  const std::string_view rest = pattern.substr(any + 1);
  for (std::size_t from = any; from <= name.size(); ++from)
    if (matches(name.substr(from), rest)) return true;
  return false;
}

std::vector<std::string> namesLike(const fs::path& folder, const std::string& pattern) {
  std::vector<std::string> names;
  std::error_code error;
  constexpr auto options = fs::directory_options::skip_permission_denied;
  for (fs::directory_iterator entry(folder, options, error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (!name.starts_with('.') && matches(name, pattern)) names.push_back(name);
  }
  std::ranges::sort(names, naturalLess);
  return names;
}

fs::path folderOf(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

bool isSliceFile(const std::string& file) {
  try {
    const FileFormat format = formatOf(FileBytes(file), file);
    return format == FileFormat::dicom || format == FileFormat::tiff;
  } catch (const base::Error&) {
    return false;  // whoever reads it is told
  }
}

}  // namespace

std::vector<std::string> stepFiles(const std::string& path) {
  const fs::path whole(path), folder = folderOf(whole);
  const std::string names = whole.filename().string();
  std::error_code ignored;
  if (names.find_first_of({kBetween, kAny}) == std::string::npos || fs::exists(whole, ignored) ||
      !fs::is_directory(folder, ignored))
    return {};
  std::vector<std::string> files;
  bool found = false;
  for (const std::string_view part : splitAt(names, {&kBetween, 1})) {
    const std::string name(part);
    const bool isPattern = name.find(kAny) != std::string::npos;
    for (const std::string& file : isPattern ? namesLike(folder, name) : std::vector{name}) {
      files.push_back((whole.parent_path() / file).string());
      found = found || fs::exists(files.back(), ignored);
    }
  }
  return found ? files : std::vector<std::string>{};
}

std::string pathOfSteps(const std::vector<std::string>& files) {
  if (files.size() < 2 || isSliceFile(files.front())) return {};
  const fs::path folder = fs::path(files.front()).parent_path(), ending = fs::path(files.front()).extension();
  std::vector<std::string> names;
  for (const std::string& file : files) {
    if (fs::path(file).parent_path() != folder || fs::path(file).extension() != ending) return {};
    names.push_back(fs::path(file).filename().string());
  }
  std::ranges::sort(names, naturalLess);
  const std::string &first = names.front(), &last = names.back();
  const auto before = static_cast<std::size_t>(
      std::mismatch(first.begin(), first.end(), last.begin(), last.end()).first - first.begin());
  const std::size_t shorter = std::min(first.size(), last.size()) - before;
  std::size_t behind = 0;
  while (behind < shorter && first[first.size() - 1 - behind] == last[last.size() - 1 - behind]) ++behind;
  const std::string pattern = first.substr(0, before) + kAny + first.substr(first.size() - behind);
  if (namesLike(folderOf(files.front()), pattern) == names) return (folder / pattern).string();
  return (folder / base::joined(names, {&kBetween, 1})).string();
}

scene::Source sourceOfStep(scene::Source source, int step) {
  source.timeStep = step;
  const std::vector<std::string> files = stepFiles(source.path);
  if (step < 0 || static_cast<std::size_t>(step) >= files.size()) return source;
  source.path = files[static_cast<std::size_t>(step)];
  source.timeStep = 0;
  return source;
}

}  // namespace isolux::volume
