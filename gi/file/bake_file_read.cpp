// Reading of bake files: only as writeBakeFile() writes them, and every claim checked before it is believed.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <map>
#include <new>
#include <optional>
#include <span>
#include <vector>

#include <zlib.h>
#include <nlohmann/json.hpp>

#include <glm/geometric.hpp>

#include "base/error.h"
#include "base/number_text.h"
#include "gi/file/bake_file.h"
#include "gi/file/bake_layers.h"
#include "volume/hit/nearest_point.h"
#include "volume/read/input/bytes.h"
#include "volume/read/input/streams.h"
#include "volume/read/input/text.h"
#include "volume/read/vtk/xml_tags.h"

namespace isolux::gi {

namespace fs = std::filesystem;
using base::throwInput;
using nlohmann::json;

namespace {

constexpr std::size_t kHeaderWithin = std::size_t{1} << 20;
constexpr std::uint64_t kMostChunkBytes = std::uint64_t{1} << 24;
constexpr int kMostTexelsPerVoxel = 64;  // an axis

struct ArrayTag {
  std::string type;
  std::int64_t components = 0, offset = 0;
};

struct Header {
  glm::ivec3 dims{0};
  std::map<std::string, ArrayTag> arrays;
  std::map<std::string, std::string> fields;
  std::uint64_t appendedAt = 0;
};

// A text as VTK writes it: the codes of its characters, then 0.
std::string textOf(std::string_view codes, const std::string& file, const std::string& place) {
  const auto numbers = volume::integersOf(codes);
  if (!numbers || numbers->empty() || numbers->back() != 0) throwInput(file, place, "is no text");
  std::string text;
  for (std::size_t i = 0; i + 1 < numbers->size(); ++i) {
    if ((*numbers)[i] < 1 || (*numbers)[i] > 255) throwInput(file, place, "is no text");
    text += static_cast<char>((*numbers)[i]);
  }
  return text;
}

Header readHeader(const volume::Bytes& bytes) {
  const std::string& file = bytes.name();
  std::string text = bytes.head(kHeaderWithin);
  const std::size_t appended = text.find("<AppendedData");
  const std::size_t mark = appended == std::string::npos ? appended : text.find('_', appended);
  if (mark == std::string::npos)
    throwInput(file, "AppendedData", "is not a file of light, or truncated: the data do not start");
  Header header;
  header.appendedAt = mark + 1;
  text.resize(mark);

  volume::Tags tags(text, file);
  bool zlib = false;
  while (const auto tag = tags.next()) {
    const auto attribute = [&](std::string_view key) { return std::string(tag->find(key).value_or("")); };
    if (tag->name == "VTKFile") {
      zlib = attribute("type") == "ImageData" && attribute("byte_order") == "LittleEndian" &&
             attribute("header_type") == "UInt64" && attribute("compressor") == "vtkZLibDataCompressor";
    } else if (tag->name == "ImageData") {
      const auto extent = volume::integersOf(attribute("WholeExtent"));
      if (!extent || extent->size() != 6)
        throwInput(file, "ImageData WholeExtent", "is not six whole numbers");
      for (std::size_t a = 0; a < 3; ++a) {
        const std::int64_t last = (*extent)[2 * a + 1];
        if ((*extent)[2 * a] != 0 || last < 0 || last >= 1 << 24)
          throwInput(file, "ImageData WholeExtent", "is not that of a light lattice");
        header.dims[static_cast<int>(a)] = static_cast<int>(last) + 1;
      }
    } else if (tag->name == "Array") {
      const std::size_t close = text.find("</Array", tag->end);
      if (close == std::string::npos)
        throwInput(file, "Array " + attribute("Name"), "truncated: is not closed");
      header.fields[attribute("Name")] = textOf(std::string_view(text).substr(tag->end, close - tag->end),
                                                file, "Array " + attribute("Name"));
    } else if (tag->name == "DataArray") {
      const auto components = volume::integerOf(attribute("NumberOfComponents"));
      const auto offset = volume::integerOf(attribute("offset"));
      if (!components || !offset || *components < 1 || *offset < 0 || attribute("format") != "appended")
        throwInput(file, "DataArray " + attribute("Name"), "is not as this program writes it");
      header.arrays[attribute("Name")] = {attribute("type"), *components, *offset};
    }
  }
  if (!zlib) throwInput(file, "VTKFile", "is not a file of light as this program writes it");
  if (header.dims.x < 1) throwInput(file, "ImageData", "is missing");
  if (!header.fields.contains("volume_hash"))
    throwInput(file, "Array volume_hash", "is missing: this is not a file of light");
  return header;
}

// An array, from its beginning to its end.
class ArrayReader {
 public:
  ArrayReader(const volume::Bytes& bytes, const Header& header, const std::string& name, const char* type,
              std::int64_t components)
      : bytes_(bytes), place_("DataArray " + name) {
    const auto found = header.arrays.find(name);
    if (found == header.arrays.end()) fail("is missing");
    const ArrayTag& tag = found->second;
    if (tag.type != type || tag.components != components)
      fail("is not " + std::to_string(components) + " components of " + type);
    total_ = static_cast<std::uint64_t>(components) * 4;
    for (int a = 0; a < 3; ++a)
      if (__builtin_mul_overflow(total_, static_cast<std::uint64_t>(header.dims[a]), &total_))
        fail("is too large");
    if (static_cast<std::uint64_t>(tag.offset) > bytes.size())
      fail("truncated: it begins behind the end of the file");
    at_ = header.appendedAt + static_cast<std::uint64_t>(tag.offset);
    std::array<std::uint64_t, 3> first{};
    read(std::as_writable_bytes(std::span(first)));
    const auto [chunks, size, rest] = first;
    if (size == 0 || size > kMostChunkBytes || rest >= size || chunks != (total_ + size - 1) / size ||
        rest != total_ % size)
      fail("the table of compressed chunks makes no sense");
    if (chunks > bytes.size() / 8 || total_ / volume::kBestDeflateRatio > bytes.size())
      fail("truncated: the file is too short");
    size_ = size;
    sizes_.resize(chunks);
    read(std::as_writable_bytes(std::span(sizes_)));
    for (const std::uint64_t packed : sizes_)
      if (packed > size + size / 100 + 1024) fail("the table of compressed chunks makes no sense");
  }

  void next(std::span<std::uint32_t> out) {
    auto* to = reinterpret_cast<std::uint8_t*>(out.data());
    for (std::size_t left = out.size_bytes(); left > 0;) {
      if (used_ == chunk_.size()) unpack();
      const std::size_t part = std::min(left, chunk_.size() - used_);
      std::memcpy(to, chunk_.data() + used_, part);
      to += part;
      used_ += part;
      left -= part;
    }
  }
  [[noreturn]] void fail(const std::string& reason) const { throwInput(bytes_.name(), place_, reason); }

 private:
  void read(std::span<std::byte> out) {
    if (at_ > bytes_.size() || out.size() > bytes_.size() - at_) fail("truncated: the file is too short");
    bytes_.read(at_, out);
    at_ += out.size();
  }
  void unpack() {
    packed_.resize(sizes_.at(chunkIndex_));
    read(packed_);
    const std::uint64_t done = chunkIndex_++ * size_;
    chunk_.resize(static_cast<std::size_t>(std::min(size_, total_ - done)));
    used_ = 0;
    uLongf size = chunk_.size();
    if (uncompress(chunk_.data(), &size, reinterpret_cast<const Bytef*>(packed_.data()), packed_.size()) !=
            Z_OK ||
        size != chunk_.size())
      fail("is damaged");
  }

  const volume::Bytes& bytes_;
  std::string place_;
  std::uint64_t total_ = 0, at_ = 0, size_ = 0;
  std::vector<std::uint64_t> sizes_;
  std::size_t chunkIndex_ = 0, used_ = 0;
  std::vector<std::byte> packed_;
  std::vector<std::uint8_t> chunk_;
};

LightContent contentOf(const Header& header, const std::string& file) {
  const auto found = header.fields.find("content");
  const json text = found == header.fields.end() ? json() : json::parse(found->second, nullptr, false);
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
  throwInput(file, "Array content", "says nothing of the light that is stored");
}

void checkKey(const Header& header, const std::string& file, const std::string& field,
              const std::string& wanted) {
  const auto found = header.fields.find(field);
  const std::string difference =
      found == header.fields.end() ? "is missing" : keyDifference(found->second, wanted);
  if (!difference.empty()) throwInput(file, "Array " + field, difference);
}

// The isovalue that the key ties the lattice to, stored units.
std::optional<float> isovalueOf(const std::string& key, const volume::Grid& grid) {
  const json wanted = json::parse(key, nullptr, false);
  if (!wanted.is_object() || !wanted.contains("isovalue") || !wanted["isovalue"].is_number())
    return std::nullopt;
  return static_cast<float>(grid.storedOfValue(wanted["isovalue"].get<double>()));
}

// What the key says of content and lattice must be what the file has.
void checkShape(const LatticeGeometry& geometry, const LightContent& content, const std::string& key,
                const std::string& file) {
  const json wanted = json::parse(key, nullptr, false);
  if (!wanted.is_object()) return;
  if (wanted.contains("lattice_scale") && wanted["lattice_scale"].is_number() &&
      LatticeGeometry::make(geometry.volumeDims, wanted["lattice_scale"].get<double>(), geometry.isovalue) !=
          geometry)
    throwInput(file, "ImageData WholeExtent", "is not that of the lattice that the key tells of");
  const std::string kind = content.kind == LightContent::Kind::transfer ? "transfer" : "irradiance";
  if ((wanted.contains("content") && wanted["content"] != kind) ||
      (wanted.contains("channels") && wanted["channels"] != content.channels) ||
      (wanted.contains("sh_order") && wanted["sh_order"] != content.order))
    throwInput(file, "Array content", "is not what the key tells of");
}

// Where the texel of a lattice with an isovalue was lit: a function of the volume, so that no file holds it.
std::optional<glm::vec3> placeOf(const LatticeGeometry& geometry, const volume::Grid& grid,
                                 std::uint32_t block, std::size_t index) {
  const glm::vec3 voxel = geometry.voxelOf(geometry.texelOf(block, static_cast<int>(index)));
  return volume::nearestSurfacePoint(grid, voxel, geometry.reach(), *geometry.isovalue);
}

void readLattice(const volume::Bytes& bytes, const Header& header, const volume::Grid& grid,
                 LightLattice& lattice, const std::string& suffix, base::Progress& progress) {
  const LatticeGeometry& geometry = lattice.geometry();
  const LightContent content = lattice.content();
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
    const std::size_t texels = layerOf(geometry, layer).count;
    light.resize(texels * written);
    count.resize(texels);
    normal.resize(texels * 3);
    lights.next(light);
    samples.next(count);
    normals.next(normal);
    LatticeBlock block;
    bool any = false;
    const auto begin = [&] {
      block = lattice.dark();
      any = false;
    };
    std::optional<std::uint32_t> now;
    const auto end = [&] {
      if (now && any) lattice.write(*now, std::move(block));
    };
    forEachTexelOfLayer(geometry, layer, [&](std::uint32_t b, std::size_t i, std::size_t t) {
      if (now != b) {
        end();
        begin();
        now = b;
      }
      if (count[t] == 0) return;
      any = true;
      block.samples[i] = count[t];
      for (int a = 0; a < 3; ++a)
        block.normals[i][a] = std::bit_cast<float>(normal[3 * t + static_cast<std::size_t>(a)]);
      const float length2 = glm::dot(block.normals[i], block.normals[i]);
      if (!(length2 > 0.9f && length2 < 1.1f)) normals.fail("a lit texel has no normal");
      if (geometry.isovalue) {
        const std::optional<glm::vec3> place = placeOf(geometry, grid, b, i);
        if (!place) normals.fail("a lit texel has no isosurface near it");
        block.places[i] = *place;
      }
      for (std::size_t c = 0; c < stored; ++c) {
        block.means[i * stored + c] = std::bit_cast<float>(light[t * written + c]);
        if (!std::isfinite(block.means[i * stored + c])) lights.fail("holds a number that is not finite");
      }
    });
    end();
  }
}

StoredLight read(const fs::path& path, const volume::Grid& grid, const std::string& skyKey,
                 const std::string& lampsKey, base::Progress& progress) {
  const volume::FileBytes bytes(path);
  const std::string& file = bytes.name();
  const Header header = readHeader(bytes);
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
  const bool hasSky = header.arrays.contains("samples"), hasLamps = header.arrays.contains("samples_lamps");
  if (hasSky && !skyKey.empty()) {
    checkKey(header, file, "key", skyKey);
    const LightContent content = contentOf(header, file);
    geometry.isovalue = isovalueOf(skyKey, grid);
    checkShape(geometry, content, skyKey, file);
    light.sky = std::make_shared<LightLattice>(geometry, content, skyKey);
    readLattice(bytes, header, grid, *light.sky, "", progress);
  }
  if (hasLamps && !lampsKey.empty()) {
    checkKey(header, file, "key_lamps", lampsKey);
    const LightContent content{LightContent::Kind::irradiance, 3, 0};
    geometry.isovalue = isovalueOf(lampsKey, grid);
    checkShape(geometry, content, lampsKey, file);
    light.lamps = std::make_shared<LightLattice>(geometry, content, lampsKey);
    readLattice(bytes, header, grid, *light.lamps, "_lamps", progress);
  }
  if (!hasSky && !hasLamps) throwInput(file, "PointData", "holds no light");
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
  if (differs("format")) return "was baked by another version of Isolux, whose light is not that of this one";
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
  const Header header = readHeader(volume::FileBytes(path));
  for (const char* const field : {"key", "key_lamps"})
    if (const auto found = header.fields.find(field); found != header.fields.end()) {
      const json key = json::parse(found->second, nullptr, false);
      return key.is_object() && key.contains("isovalue");
    }
  return false;
}

StoredLight readBakeFile(const fs::path& path, const volume::Grid& grid, const std::string& skyKey,
                         const std::string& lampsKey, base::Progress& progress) {
  try {
    return read(path, grid, skyKey, lampsKey, progress);
  } catch (const std::bad_alloc&) {
    throw base::Error(base::ErrorKind::memory, path.string(), "", "out of memory while light is read");
  }
}

}  // namespace isolux::gi
