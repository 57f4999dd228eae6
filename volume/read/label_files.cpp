#include "volume/read/label_files.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.h"
#include "volume/labels/freesurfer_labels.h"
#include "volume/labels/label_table.h"
#include "volume/read/input/bytes.h"
#include "volume/read/input/text.h"
#include "volume/read/label_names.h"

namespace isolux::volume {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t kLongestNames = std::uint64_t{4} << 20;  // bytes

// "a/T1_dseg.nii.gz" -> "a/T1_dseg".
fs::path withoutEndings(fs::path path) {
  const std::string last = lowered(path.extension().string());
  if (last == ".gz" || last == ".zst" || last == ".bz2") path.replace_extension();
  return path.replace_extension();
}

bool isFreeSurfers(const fs::path& path) {
  const std::string name = lowered(path.filename().string());
  const bool isVolume =
      name.ends_with(".mgz") || name.ends_with(".mgh") || name.find(".nii") != std::string::npos;
  return isVolume && std::ranges::any_of(std::array{"aparc", "aseg", "wmparc"}, [&](const char* part) {
           return name.find(part) != std::string::npos;
         });
}

fs::path fileOfNames(const fs::path& path) {
  std::error_code ignored;
  const fs::path stem = withoutEndings(path);
  for (const char* ending : {".tsv", ".label", ".ctbl", ".txt"}) {
    fs::path candidate = stem;
    candidate += ending;
    if (candidate != path && fs::is_regular_file(candidate, ignored)) return candidate;
  }
  const fs::path folder = fs::absolute(path, ignored).parent_path();
  for (const fs::path& place : {folder, folder.parent_path()}) {
    const bool above = place != folder;
    if (above && !folder.filename().string().starts_with("labels")) break;
    if (fs::is_regular_file(place / "dataset.json", ignored)) return place / "dataset.json";
  }
  if (!isFreeSurfers(path)) return {};
  constexpr const char* table = "FreeSurferColorLUT.txt";
  const char* const home = std::getenv("FREESURFER_HOME");
  for (const fs::path& place : {folder, fs::path(home ? home : "")})
    if (!place.empty() && fs::is_regular_file(place / table, ignored)) return place / table;
  return {};
}

std::vector<Label> readLabels(const fs::path& file) {
  const std::string name = file.filename().string();
  const FileBytes bytes(file);
  if (bytes.size() > kLongestNames) base::throwInput(name, "", "is too long for names of labels");
  return labelNamesIn(bytes.head(kLongestNames), name);
}

// A .txt may be anything.
std::vector<Label> labelsInFile(const fs::path& file, std::vector<std::string>& warnings) {
  const std::string name = file.filename().string();
  try {
    return readLabels(file);
  } catch (const base::Error& error) {
    if (!name.ends_with(".txt"))
      warnings.push_back(std::string("names of labels are not read: ") + error.what());
    return {};
  }
}

// `why`: what makes values labels where the file's names fit.
void takeNames(LabelTable& table, const fs::path& file, const char* why, const Grid& grid) {
  table = labelsOfLayer(table, 0);
  if (table.labels.empty()) return;
  table.source = file.filename().string();
  const bool fits = grid.minimum() >= 0.0 && grid.maximum() <= static_cast<double>(table.labels.back().value);
  if (fits && table.reason.empty()) table.reason = table.source + why;
}

}  // namespace

std::string labelsByName(const fs::path& path) {
  const std::string name = lowered(path.filename().string());
  if (name.ends_with(".seg.nrrd")) return "its name ends in .seg.nrrd";
  const std::string stem = withoutEndings(path).filename().string();
  if (stem.ends_with("_dseg")) return "its name ends in _dseg";
  return isFreeSurfers(path) ? "its name is that of FreeSurfer's labels" : "";
}

void addLabelFiles(Volume& volume, const fs::path& path) {
  LabelTable table = volume.labelTable ? *volume.labelTable : LabelTable{};
  if (table.reason.empty()) table.reason = labelsByName(path);
  if (table.labels.empty())
    if (const fs::path file = fileOfNames(path); !file.empty()) {
      table.labels = labelsInFile(file, volume.warnings);
      takeNames(table, file, " beside it names labels", *volume.grid);
    }
  if (table.labels.empty() && isFreeSurfers(path)) {
    table.labels = freesurferLabels();
    table.source = "FreeSurfer";
  }
  if (table.reason.empty() && table.labels.empty()) return;
  volume.labelTable = std::make_shared<const LabelTable>(std::move(table));
}

void nameLabels(Volume& volume, const fs::path& file) {
  LabelTable table = volume.labelTable ? *volume.labelTable : LabelTable{};
  table.labels = readLabels(file);
  if (table.labels.empty()) base::throwInput(file.string(), "source.label_names", "names no labels");
  takeNames(table, file, " names labels", *volume.grid);
  volume.labelTable = std::make_shared<const LabelTable>(std::move(table));
}

}  // namespace isolux::volume
