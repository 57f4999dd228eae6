#include "volume/read/zarr/zarr.h"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "volume/read/input/image_header.h"
#include "volume/read/zarr/json_fields.h"
#include "volume/read/zarr/ome.h"
#include "volume/read/zarr/zarr_array.h"
#include "volume/read/zarr/zarr_statements.h"

namespace isolux::volume {

namespace fs = std::filesystem;
using base::throwInput;

namespace {

constexpr const char* kZarrFiles[] = {"zarr.json", ".zarray", ".zgroup", ".zattrs"};

// Attributes of a group or array and the file that they stand in; nothing where there are none.
struct ZarrAttributes {
  nlohmann::json json;
  std::string file;
  std::vector<std::string> warnings;
};
std::optional<ZarrAttributes> attributesOf(const ZarrStore& store, const std::string& key) {
  const std::string v3 = joinedKey(key, "zarr.json"), v2 = joinedKey(key, ".zattrs");
  ZarrAttributes found;
  if (const auto text = store.text(v3)) {
    found.file = store.nameOf(v3);
    const nlohmann::json json = parseJson(*text, found.file, &found.warnings);
    if (!json.contains("attributes") || !json["attributes"].is_object()) return std::nullopt;
    found.json = json["attributes"];
  } else if (const auto old = store.text(v2)) {
    found.file = store.nameOf(v2);
    found.json = parseJson(*old, found.file, &found.warnings);
  } else {
    return std::nullopt;
  }
  return found;
}

std::optional<OmeImage> omeOf(const ZarrStore& store, const std::string& key) {
  const auto attributes = attributesOf(store, key);
  if (!attributes) return std::nullopt;
  auto image = parseOme(attributes->json, attributes->file);
  if (image)
    image->warnings.insert(image->warnings.begin(), attributes->warnings.begin(), attributes->warnings.end());
  return image;
}

ChunkedFacts factsNamed(const std::string& name, std::string format) {
  ChunkedFacts facts;
  facts.name = name;
  facts.format = std::move(format);
  return facts;
}

// "a/b" lies in "a"; the root in nothing.
std::pair<std::string, std::string> parentAndName(const std::string& key) {
  const std::size_t slash = key.rfind('/');
  if (slash == std::string::npos) return {"", key};
  return {key.substr(0, slash), key.substr(slash + 1)};
}

// An array without any image round it.
std::unique_ptr<ArrayVolume> volumeOfArray(const std::shared_ptr<const ZarrStore>& store,
                                           const std::string& key, const std::string& name) {
  const auto array = std::make_shared<const ZarrArray>(store, key);
  const ArrayStatements statements = statementsOf(store, key, *array);
  const std::vector<std::uint64_t>& dims = array->metadata().dims;
  const ArrayAxes axes = axesNamed(namesOf(statements.axes), dims, name, "shape");
  ChunkedFacts facts = factsNamed(name, "Zarr " + std::to_string(array->metadata().version));
  facts.levels.resize(1);
  applyStatements(statements, axes, dims, facts);
  return std::make_unique<ArrayVolume>(
      std::move(facts), axes, std::vector<std::shared_ptr<const ChunkedArray>>{valuesOf(array, statements)});
}

// The outer faces of the outermost voxels.
Bounds<glm::dvec3> facesOf(const OmeLevel& level, glm::dvec3 dims) {
  const glm::dvec3 low = level.originMm - 0.5 * level.spacingMm;
  return {low, low + dims * level.spacingMm};
}

// Empty where a coarser level lies where the finest does, to a voxel of its own; else what is wrong.
std::string misplacedBy(const OmeLevel& finest, glm::dvec3 finestDims, const OmeLevel& level,
                        glm::dvec3 dims) {
  const Bounds<glm::dvec3> wanted = facesOf(finest, finestDims), got = facesOf(level, dims);
  for (int axis = 0; axis < 3; ++axis) {
    const double voxel = std::abs(level.spacingMm[axis]) * 1.01;
    if (dims[axis] > finestDims[axis]) return "it is finer than level 0";
    if (!(std::abs(wanted.low[axis] - got.low[axis]) <= voxel) ||
        !(std::abs(wanted.high[axis] - got.high[axis]) <= voxel))
      return "it is not at the position of level 0";
  }
  return {};
}

glm::dvec3 spatialDims(const ArrayAxes& axes, const std::vector<std::uint64_t>& dims) {
  const auto along = [&](const std::optional<std::size_t>& axis) {
    return axis ? static_cast<double>(dims[*axis]) : 1.0;
  };
  return {along(axes.x), along(axes.y), along(axes.z)};
}

// What of an image's levels can be used together.
struct UsableLevels {
  std::vector<std::shared_ptr<const ChunkedArray>> arrays;
  std::vector<OmeLevel> places;
};

void addLevel(const std::shared_ptr<const ZarrStore>& store, const std::string& key, const OmeImage& image,
              OmeLevel level, UsableLevels& usable) {
  auto array = std::make_shared<const ZarrArray>(store, joinedKey(key, level.path));
  const ArrayLayout& layout = array->layout();
  if (layout.dims.size() != image.axisCount)
    throwInput(
        store->nameOf(joinedKey(key, level.path)), "shape",
        "has " + std::to_string(layout.dims.size()) + " axes, its image " + std::to_string(image.axisCount));
  const glm::dvec3 dims = spatialDims(image.axes, layout.dims);
  if (!usable.arrays.empty()) {
    const ArrayLayout& finest = usable.arrays.front()->layout();
    OmeLevel& first = usable.places.front();
    // Without a translation a mean over 2x2x2 voxels would lie where the first of them lies.
    if (!level.placed && !first.placed)
      level.originMm = first.originMm + 0.5 * (level.spacingMm - first.spacingMm);
    std::string problem = misplacedBy(first, spatialDims(image.axes, finest.dims), level, dims);
    if (layout.type != finest.type) problem = "its type is another than that of level 0";
    if (!problem.empty()) throwInput(store->nameOf(joinedKey(key, level.path)), "", problem);
  }
  usable.arrays.push_back(std::move(array));
  usable.places.push_back(std::move(level));
}

std::unique_ptr<ArrayVolume> volumeOfImage(const std::shared_ptr<const ZarrStore>& store,
                                           const std::string& key, const OmeImage& image,
                                           const std::string& name) {
  ChunkedFacts facts = factsNamed(name, "OME-Zarr " + image.version);
  facts.warnings = image.warnings;
  facts.labels = image.labels;
  UsableLevels usable;
  for (std::size_t i = 0; i < image.levels.size(); ++i) {
    try {
      addLevel(store, key, image, image.levels[i], usable);
    } catch (const base::Error& error) {
      if (i == 0) throw;
      facts.warnings.push_back("level " + std::to_string(i) + " (" + image.levels[i].path +
                               ") is left out: " + error.reason());
    }
  }
  facts.levels.resize(usable.arrays.size());
  for (std::size_t i = 0; i < usable.places.size(); ++i) {
    std::vector<std::string> doubts;
    facts.levels[i].geometry.worldFromVoxel =
        checkedGeometry(glm::dmat3(1.0), usable.places[i].spacingMm, usable.places[i].originMm, name, doubts);
    if (i == 0) facts.warnings.insert(facts.warnings.end(), doubts.begin(), doubts.end());
  }
  return std::make_unique<ArrayVolume>(std::move(facts), image.axes, std::move(usable.arrays));
}

// The image of the folder above, with this array as its one level: a level opened by itself lies where it
// does.
std::optional<OmeImage> imageOfLevel(const ZarrStore& store, const std::string& key) {
  if (key.empty()) return std::nullopt;
  const auto [parent, name] = parentAndName(key);
  std::optional<OmeImage> image;
  try {
    image = omeOf(store, parent);
  } catch (const base::Error&) {  // whatever is wrong with it: the array itself is asked for
    return std::nullopt;
  }
  if (!image) return std::nullopt;
  const bool placed = image->levels.front().placed;
  const OmeLevel finest = image->levels.front();
  std::erase_if(image->levels, [&wanted = name](const OmeLevel& level) { return level.path != wanted; });
  if (image->levels.size() != 1) return std::nullopt;
  OmeLevel& level = image->levels.front();
  if (!level.placed && !placed) level.originMm = finest.originMm + 0.5 * (level.spacingMm - finest.spacingMm);
  return image;
}

// Axes of more than one entry; of an image or one that cannot be read, as many as a volume has.
std::ptrdiff_t wideAxesOf(const std::shared_ptr<const ZarrStore>& store, const std::string& key) {
  try {
    if (ZarrArray::isArray(*store, key)) {
      const ZarrArray array(store, key);
      return std::min<std::ptrdiff_t>(
          std::count_if(array.metadata().dims.begin(), array.metadata().dims.end(),
                        [](auto n) { return n > 1; }),
          3);
    }
    return omeOf(*store, key) ? 3 : 0;
  } catch (const base::Error&) {  // a damaged one is told of when it is asked for
    return 3;
  }
}

// Of a group without an image of its own: its folders that hold an image or an array, volumes before
// pictures; the coordinates of axes only where there is nothing else. Of a plate: the images of all wells.
std::vector<std::string> imagesIn(const std::shared_ptr<const ZarrStore>& store, const std::string& key) {
  std::vector<std::pair<std::string, std::ptrdiff_t>> found;
  for (const std::string& name : store->folders(key))
    if (const std::ptrdiff_t wide = wideAxesOf(store, joinedKey(key, name)); wide > 0)
      found.emplace_back(name, wide);
  std::ranges::stable_sort(found, [](const auto& a, const auto& b) { return a.second > b.second; });
  if (!found.empty() && found.front().second >= 2)
    std::erase_if(found, [](const auto& entry) { return entry.second < 2; });
  std::vector<std::string> names;
  for (const auto& [name, wide] : found) names.push_back(name);
  if (const auto attributes = names.empty() ? attributesOf(*store, key) : std::nullopt)
    for (const std::string& well : wellsOf(attributes->json, attributes->file))
      for (const std::string& image : imagesIn(store, joinedKey(key, well)))
        names.push_back(joinedKey(well, image));
  return names;
}

}  // namespace

bool isZarrFolder(const fs::path& folder) {
  std::error_code ignored;
  return std::any_of(std::begin(kZarrFiles), std::end(kZarrFiles),
                     [&](const char* name) { return fs::is_regular_file(folder / name, ignored); });
}

fs::path zarrFolderOf(const fs::path& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return isZarrFolder(path) ? path : fs::path();
  const std::string name = path.filename().string();
  const bool metadata = std::any_of(std::begin(kZarrFiles), std::end(kZarrFiles),
                                    [&](const char* known) { return name == known; });
  if (!metadata || !fs::is_regular_file(path, ignored)) return {};
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

std::unique_ptr<ArrayVolume> openZarr(std::shared_ptr<const ZarrStore> store, const std::string& key,
                                      const std::string& name, const std::string& series) {
  if (ZarrArray::isArray(*store, key)) {
    if (const auto image = imageOfLevel(*store, key))
      return volumeOfImage(store, parentAndName(key).first, *image, name);
    return volumeOfArray(store, key, name);
  }
  if (const auto image = omeOf(*store, key)) {
    auto volume = volumeOfImage(store, key, *image, name);
    volume->setTitle(image->name);
    return volume;
  }
  const std::vector<std::string> images = imagesIn(store, key);
  if (images.empty())
    throwInput(name, "", "the Zarr group holds no image and no array; open a folder in it that does");
  const std::string chosen = series.empty() ? images.front() : series;
  if (std::ranges::find(images, chosen) == images.end())
    base::throwUsage(name, "source.series", "unknown image \"" + chosen + "\"");
  auto volume = openZarr(store, joinedKey(key, chosen), name, "");
  if (images.size() == 1) return volume;
  std::vector<std::string> choices;
  for (const std::string& image : images) choices.push_back(image + "\t" + image);
  volume->setChoices(std::move(choices),
                     series.empty() ? std::to_string(images.size()) +
                                          " images; the first is shown, source.series chooses another"
                                    : "");
  return volume;
}

std::unique_ptr<ArrayVolume> openZarr(const fs::path& folder, const std::string& series) {
  // The folder above is looked at, too: it may say where this one's voxels lie.
  const fs::path whole = fs::absolute(folder).lexically_normal();
  const fs::path path = whole.has_filename() ? whole : whole.parent_path();
  const bool inside = path.has_parent_path() && isZarrFolder(path.parent_path());
  const fs::path root = inside ? path.parent_path() : path;
  return openZarr(std::make_shared<const FolderStore>(root), inside ? path.filename().string() : "",
                  folder.string(), series);
}

}  // namespace isolux::volume
