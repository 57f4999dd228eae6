#include "app/series/picture_names.h"

#include <array>
#include <cstdio>
#include <filesystem>
#include <set>

#include "app/files/file_names.h"
#include "base/error.h"

namespace isolux::app {

namespace fs = std::filesystem;

namespace {

bool hasField(const std::string& pattern, const char* field) {
  return pattern.find(field) != std::string::npos;
}

}  // namespace

std::string completePattern(const std::string& pattern, std::size_t volumes, bool series) {
  if (pattern == "-") return pattern;
  std::error_code ignored;
  fs::path out(pattern);
  if (!out.has_extension() || fs::is_directory(out, ignored))
    return (out / (!series ? "{name}.png" : volumes > 1 ? "{name}_{i}.png" : "frame_{i}.png")).string();
  if (!series || hasField(pattern, "{i}") || hasField(pattern, "{value}")) return pattern;
  const std::string extension = out.extension().string();
  return pattern.substr(0, pattern.size() - extension.size()) + "_{i}" + extension;
}

std::string expandedName(const std::string& pattern, const PictureOfSeries& picture) {
  std::string name;
  for (std::size_t at = 0; at < pattern.size();) {
    const std::size_t end = pattern[at] == '{' ? pattern.find('}', at) : std::string::npos;
    if (end == std::string::npos) {
      name += pattern[at++];
      continue;
    }
    const std::string field = pattern.substr(at + 1, end - at - 1);
    std::array<char, 16> number{};
    std::snprintf(number.data(), number.size(), "%05d", picture.i);
    if (field == "name")
      name += plainName(picture.path);
    else if (field == "n")
      name += std::to_string(picture.n);
    else if (field == "i")
      name += number.data();
    else if (field == "value" && !picture.value.empty())
      name += picture.value;
    else
      name.append("{").append(field).append("}");  // no field: part of the name
    at = end + 1;
  }
  return name;
}

void checkNamesDiffer(const std::vector<std::string>& names, const std::string& option) {
  std::set<std::string> seen;
  for (const std::string& name : names)
    if (!seen.insert(fs::path(name).lexically_normal().string()).second)
      base::throwUsage(name, "",
                       "several images would be written to this file; {name}, {n}, {i} or {value} in " +
                           option + " distinguishes them");
}

}  // namespace isolux::app
