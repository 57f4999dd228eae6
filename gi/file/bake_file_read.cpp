// Reading of bake files: only as writeBakeFile() writes them, and every claim checked before it is believed.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>
#include <span>
#include <vector>

#include <nlohmann/json.hpp>

#include <glm/geometric.hpp>

#include "base/number_text.h"
#include "gi/file/bake_file.h"
#include "gi/file/bake_header.h"
#include "gi/file/bake_layers.h"
#include "gi/file/compressed_array.h"
#include "volume/hit/nearest_point.h"
#include "volume/read/input/bytes.h"

namespace isolux::gi {

namespace fs = std::filesystem;
using base::throwInput;
using nlohmann::json;

namespace {

constexpr int kMostTexelsPerVoxel = 64;  // an axis

LightContent contentOf(const BakeHeader& header, const std::string& file) {
  const std::string* written = header.field("content");
  const json text = written ? json::parse(*written, nullptr, false) : json();
  const auto integer = [&](const char* name) {
    return text.contains(name) && text[name].is_number_integer() ? text[name].get<int>() : -1;
  };
  LightContent content;
  if (text.is_object() && text.contains("kind")) {
    content = {text["kind"] == "transfer" ? LightContent::Kind::transfer : LightContent::Kind::irradiance,
               integer("channels"), integer("order")};
    const bool orderFits = content.kind == LightContent::Kind::transfer
                               ? content.order >= 1 && content.order <= 8
                               : content.order == 0;
    if ((content.channels == 1 || content.channels == 3) && orderFits) return content;
  }
  throwInput(file, "Array content", "does not describe its light");
}

void checkKey(const BakeHeader& header, const std::string& file, const std::string& field,
              const std::string& wanted) {
  const std::string* stored = header.field(field);
  const std::string difference = stored ? keyDifference(*stored, wanted) : "is missing";
  if (!difference.empty()) throwInput(file, "Array " + field, difference);
}

// The isovalue that the key ties the lattice to, stored units.
std::optional<float> isovalueOf(const std::string& key, const volume::Grid& grid) {
  const json wanted = json::parse(key, nullptr, false);
  if (!wanted.is_object() || !wanted.contains("isovalue") || !wanted["isovalue"].is_number())
    return std::nullopt;
  return grid.storedIsovalue(wanted["isovalue"].get<double>());
}

// What the key says of content and lattice must be what the file has.
void checkShape(const LatticeGeometry& geometry, const LightContent& content, const std::string& key,
                const std::string& file) {
  const json wanted = json::parse(key, nullptr, false);
  if (!wanted.is_object()) return;
  if (wanted.contains("lattice_scale") && wanted["lattice_scale"].is_number() &&
      LatticeGeometry::make(geometry.volumeDims, wanted["lattice_scale"].get<double>(), geometry.isovalue) !=
          geometry)
    throwInput(file, "ImageData WholeExtent", "does not match the lattice of the key");
  const std::string kind = content.kind == LightContent::Kind::transfer ? "transfer" : "irradiance";
  if ((wanted.contains("content") && wanted["content"] != kind) ||
      (wanted.contains("channels") && wanted["channels"] != content.channels) ||
      (wanted.contains("sh_order") && wanted["sh_order"] != content.order))
    throwInput(file, "Array content", "does not match the key");
}

// Where the texel of a lattice with an isovalue was lit: a function of the volume and of what is hidden of
// it, so that no file holds it.
std::optional<glm::vec3> placeOf(const LatticeGeometry& geometry, const volume::Grid& grid,
                                 const volume::HiddenPieces& hidden, std::uint32_t block, std::size_t index) {
  const glm::vec3 voxel = geometry.voxelOf(geometry.texelOf(block, static_cast<int>(index)));
  return volume::nearestSurfacePoint(grid, voxel, geometry.reach(), *geometry.isovalue, hidden);
}

void readLattice(const volume::Bytes& bytes, const BakeHeader& header, const volume::Grid& grid,
                 std::span<const volume::HiddenOfSurface> surfaces, LightLattice& lattice,
                 const std::string& suffix, base::Progress& progress) {
  const LatticeGeometry& geometry = lattice.geometry();
  const LightContent content = lattice.content();
  volume::HiddenPieces hidden;
  if (geometry.isovalue) hidden = volume::hiddenAt(surfaces, grid, *geometry.isovalue);
  const bool transfer = content.kind == LightContent::Kind::transfer;
  const auto stored = static_cast<std::size_t>(content.components());
  const std::size_t written = transfer ? stored : 3;
  ArrayReader lights(bytes, header, (transfer ? "transfer" : "irradiance") + suffix, "Float32",
                     static_cast<std::int64_t>(written));
  ArrayReader samples(bytes, header, "samples" + suffix, "UInt32", 1);
  ArrayReader normals(bytes, header, "normal", "Float32", 3);
  std::vector<std::uint32_t> light, count, normal;
  for (int layer = 0; layer < layersOf(geometry); ++layer) {
    progress.throwIfStopped();
    progress.report(static_cast<double>(layer) / layersOf(geometry), "reading light");
    const std::size_t texels = texelsOfLayer(geometry, layer);
    light.resize(texels * written);
    count.resize(texels);
    normal.resize(texels * 3);
    lights.next(light);
    samples.next(count);
    normals.next(normal);
    const std::uint32_t blocks = blocksPerLayer(geometry), begin = static_cast<std::uint32_t>(layer) * blocks;
    for (std::uint32_t b = begin; b < begin + blocks; ++b) {
      LatticeBlock block = lattice.dark();
      bool any = false;
      forEachTexelOfBlock(geometry, b, [&](std::size_t i, std::size_t t) {
        if (count[t] == 0) return;
        any = true;
        block.samples[i] = count[t];
        for (int a = 0; a < 3; ++a)
          block.normals[i][a] = std::bit_cast<float>(normal[3 * t + static_cast<std::size_t>(a)]);
        const float length2 = glm::dot(block.normals[i], block.normals[i]);
        if (!(length2 > 0.9f && length2 < 1.1f)) normals.fail("a lit texel has no normal");
        if (geometry.isovalue) {
          const std::optional<glm::vec3> place = placeOf(geometry, grid, hidden, b, i);
          if (!place) normals.fail("a lit texel has no isosurface near it");
          block.places[i] = *place;
        }
        for (std::size_t c = 0; c < stored; ++c) {
          block.means[i * stored + c] = std::bit_cast<float>(light[t * written + c]);
          if (!std::isfinite(block.means[i * stored + c])) lights.fail("holds a number that is not finite");
        }
      });
      if (any) lattice.write(b, std::move(block));
    }
  }
}

StoredLight read(const fs::path& path, const volume::Grid& grid,
                 std::span<const volume::HiddenOfSurface> hidden, const std::string& skyKey,
                 const std::string& lampsKey, base::Progress& progress) {
  const volume::FileBytes bytes(path);
  const std::string& file = bytes.name();
  const BakeHeader header = readBakeHeader(bytes);
  if (header.fields.at("volume_hash") != base::hexText(grid.hash())) {
    // Other versions of the light may have hashed the same volume in another way: that is said instead.
    for (const auto& [field, key] : {std::pair("key", &skyKey), std::pair("key_lamps", &lampsKey)})
      if (!key->empty() && header.fields.contains(field)) checkKey(header, file, field, *key);
    throwInput(file, "Array volume_hash", "the volume is another one");
  }
  LatticeGeometry geometry{header.dims, grid.dims(), {}};
  for (int a = 0; a < 3; ++a)
    if (geometry.dims[a] > (geometry.volumeDims[a] - 1) * kMostTexelsPerVoxel + 1)
      throwInput(file, "ImageData WholeExtent", "the lattice does not fit the volume");

  StoredLight light;
  light.facts = bakeFactsOf(header, file);
  const auto latticeOf = [&](const std::string& suffix, const std::string& key) {
    if (key.empty() || !header.arrays.contains("samples" + suffix)) return std::shared_ptr<LightLattice>();
    checkKey(header, file, "key" + suffix, key);
    const LightContent content = suffix.empty() ? contentOf(header, file) : LightContent{};
    geometry.isovalue = isovalueOf(key, grid);
    checkShape(geometry, content, key, file);
    auto lattice = std::make_shared<LightLattice>(geometry, content, key);
    readLattice(bytes, header, grid, hidden, *lattice, suffix, progress);
    return lattice;
  };
  light.sky = latticeOf("", skyKey);
  light.lamps = latticeOf("_lamps", lampsKey);
  if (!header.arrays.contains("samples") && !header.arrays.contains("samples_lamps"))
    throwInput(file, "PointData", "holds no light");
  progress.report(1.0, "reading light");
  return light;
}

}  // namespace

std::string keyDifference(const std::string& stored, const std::string& wanted) {
  if (stored == wanted) return {};
  const json a = json::parse(stored, nullptr, false), b = json::parse(wanted, nullptr, false);
  if (!a.is_object() || !b.is_object()) return "the light is another one";
  const auto differs = [&](const std::string& name) {
    return a.contains(name) != b.contains(name) || (a.contains(name) && a[name] != b[name]);
  };
  if (differs("format")) return "was baked by another version of Isolux with different light";
  if (differs("volume")) return "the volume is another one";
  for (const json* keys : {&b, &a})
    for (const auto& [name, value] : keys->items())
      if (differs(name)) {
        std::string words = name;
        std::replace(words.begin(), words.end(), '_', ' ');
        return words + " differs";
      }
  return {};  // the same, written differently
}

bool isOfOneIsovalue(const fs::path& path) {
  const BakeHeader header = readBakeHeader(volume::FileBytes(path));
  for (const char* const field : {"key", "key_lamps"})
    if (const std::string* stored = header.field(field)) {
      const json key = json::parse(*stored, nullptr, false);
      return key.is_object() && key.contains("isovalue");
    }
  return false;
}

StoredLight readBakeFile(const fs::path& path, const volume::Grid& grid,
                         std::span<const volume::HiddenOfSurface> hidden, const std::string& skyKey,
                         const std::string& lampsKey, base::Progress& progress) {
  return namingFile(path, "read", [&] { return read(path, grid, hidden, skyKey, lampsKey, progress); });
}

}  // namespace isolux::gi
