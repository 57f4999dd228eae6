// Writing of bake files: the header with room for the places of the arrays, then the arrays, then the places.
#include <algorithm>
#include <bit>
#include <cinttypes>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <functional>
#include <new>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/number_text.h"
#include "base/pending_file.h"
#include "gi/file/bake_file.h"
#include "gi/file/bake_header.h"
#include "gi/file/bake_layers.h"
#include "gi/file/compressed_array.h"

namespace isolux::gi {

namespace fs = std::filesystem;

namespace {

static_assert(std::endian::native == std::endian::little);

constexpr const char* kFirstField = "<Array type=\"String\" Name=\"volume_hash\"";

using Blocks = std::vector<std::shared_ptr<const LatticeBlock>>;

struct Array {
  std::string name;
  const char* type;        // VTK's
  std::size_t components;  // of 4 bytes
  // Texel `i` of a block to `components` numbers; `block` is never null.
  const Blocks* blocks;
  std::function<void(const LatticeBlock& block, std::size_t i, std::uint32_t* out)> fill;
};

std::string exact(double value) {
  return base::shortText(value, 17);
}

std::string contentText(const LightContent& content) {
  return nlohmann::ordered_json{
      {"kind", content.kind == LightContent::Kind::transfer ? "transfer" : "irradiance"},
      {"channels", content.channels},
      {"order", content.order}}
      .dump();
}

std::string partText(const BakedPart& baked) {
  return nlohmann::ordered_json{{"part", baked.part.index},
                                {"of", baked.part.count},
                                {"samples", baked.samples},
                                {"texels", baked.texels},
                                {"complete", baked.complete}}
      .dump();
}

void addArrays(std::vector<Array>& arrays, const LightLattice& lattice, const Blocks& blocks,
               const std::string& suffix) {
  const LightContent content = lattice.content();
  const bool transfer = content.kind == LightContent::Kind::transfer;
  const auto stored = static_cast<std::size_t>(content.components());
  const std::size_t written = transfer ? stored : 3;
  arrays.push_back({(transfer ? "transfer" : "irradiance") + suffix, "Float32", written, &blocks,
                    [stored, written](const LatticeBlock& block, std::size_t i, std::uint32_t* out) {
                      for (std::size_t c = 0; c < written; ++c)
                        out[c] = block.samples[i] == 0 ? 0u
                                                       : std::bit_cast<std::uint32_t>(
                                                             block.means[i * stored + (stored == 1 ? 0 : c)]);
                    }});
  arrays.push_back(
      {"samples" + suffix, "UInt32", 1, &blocks,
       [](const LatticeBlock& block, std::size_t i, std::uint32_t* out) { *out = block.samples[i]; }});
}

std::string header(const volume::Grid& grid, const StoredLight& light, const std::vector<Array>& arrays,
                   std::vector<std::size_t>& places) {
  const LatticeGeometry& lattice = (light.sky ? light.sky : light.lamps)->geometry();
  const volume::GridGeometry& g = grid.geometry();
  std::string extent, spacing, origin, direction;
  const glm::dmat3 directions = g.directions();
  for (int a = 0; a < 3; ++a) {
    const char* const gap = a > 0 ? " " : "";
    const double step = lattice.dims[a] > 1 ? lattice.voxelsPerTexel()[a] : 1.0;
    extent += gap + ("0 " + std::to_string(lattice.dims[a] - 1));
    spacing += gap + exact(g.spacingMm()[a] * step);
    origin += gap + exact(g.originMm()[a]);
    for (int column = 0; column < 3; ++column)
      direction += (direction.empty() ? "" : " ") + exact(directions[column][a]);
  }
  std::string xml =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n  <ImageData WholeExtent=\"" +
      extent + "\" Origin=\"" + origin + "\" Spacing=\"" + spacing + "\" Direction=\"" + direction +
      "\">\n    <FieldData>\n" + bakeTextField("volume_hash", base::hexText(grid.hash()));  // kFirstField
  if (light.sky)
    xml +=
        bakeTextField("key", light.sky->key()) + bakeTextField("content", contentText(light.sky->content()));
  if (light.lamps) xml += bakeTextField("key_lamps", light.lamps->key());
  if (!light.facts.arithmetic.empty()) xml += bakeTextField("arithmetic", light.facts.arithmetic);
  if (light.facts.part) xml += bakeTextField("part", partText(*light.facts.part));
  xml += "    </FieldData>\n    <Piece Extent=\"" + extent + "\">\n      <PointData Scalars=\"" +
         arrays[0].name + "\">\n";
  for (const Array& array : arrays) {
    xml += "        <DataArray type=\"" + std::string(array.type) + "\" Name=\"" + array.name +
           "\" NumberOfComponents=\"" + std::to_string(array.components) + "\" format=\"appended\" offset=\"";
    places.push_back(xml.size());
    xml += "0000000000000000\"/>\n";
  }
  return xml + "      </PointData>\n    </Piece>\n  </ImageData>\n  <AppendedData encoding=\"raw\">\n_";
}

void write(const fs::path& path, const volume::Grid& grid, const StoredLight& light,
           base::Progress& progress) {
  const LatticeGeometry& lattice = (light.sky ? light.sky : light.lamps)->geometry();
  const auto snapshot = [](const std::shared_ptr<LightLattice>& from) {
    Blocks blocks;
    if (from)
      for (std::uint32_t b = 0; b < from->geometry().blockCount(); ++b) blocks.push_back(from->at(b));
    return blocks;
  };
  const Blocks sky = snapshot(light.sky), lamps = snapshot(light.lamps);
  Blocks normals = light.sky ? sky : lamps;  // the same in both
  for (std::size_t b = 0; b < lamps.size(); ++b)
    if (!normals[b]) normals[b] = lamps[b];

  std::vector<Array> arrays;
  if (light.sky) addArrays(arrays, *light.sky, sky, "");
  if (light.lamps) addArrays(arrays, *light.lamps, lamps, "_lamps");
  const auto otherNormal = [&](std::uint32_t block, std::size_t i) {
    return !lamps.empty() && lamps[block] ? lamps[block]->normals[i] : glm::vec3(0.0f);
  };
  arrays.push_back({"normal", "Float32", 3, &normals, nullptr});

  base::OutputFile file(path);
  std::vector<std::size_t> places;
  const std::string xml = header(grid, light, arrays, places);
  file.write(xml);
  const std::uint64_t texels = static_cast<std::uint64_t>(lattice.dims.x) *
                               static_cast<std::uint64_t>(lattice.dims.y) *
                               static_cast<std::uint64_t>(lattice.dims.z);
  std::vector<std::uint32_t> numbers;
  for (std::size_t a = 0; a < arrays.size(); ++a) {
    const Array& array = arrays[a];
    char offset[20];
    std::snprintf(offset, sizeof offset, "%016" PRIu64, file.at() - xml.size());
    const std::uint64_t begin = file.at();
    file.go(places[a]);
    file.write(offset, 16);
    file.go(begin);
    ArrayWriter out(file, texels * array.components * 4);
    for (int layer = 0; layer < layersOf(lattice); ++layer) {
      progress.throwIfStopped();
      progress.report((static_cast<double>(a) + static_cast<double>(layer) / layersOf(lattice)) /
                          static_cast<double>(arrays.size()),
                      "writing light");
      numbers.assign(layerOf(lattice, layer).count * array.components, 0);
      forEachTexelOfLayer(lattice, layer, [&](std::uint32_t b, std::size_t i, std::size_t t) {
        const LatticeBlock* const block = (*array.blocks)[b].get();
        if (!block) return;
        std::uint32_t* const to = numbers.data() + t * array.components;
        if (array.fill) return array.fill(*block, i, to);
        const glm::vec3 normal = block->normals[i] != glm::vec3(0.0f) ? block->normals[i] : otherNormal(b, i);
        const float components[] = {normal.x, normal.y, normal.z};
        std::memcpy(to, components, sizeof components);
      });
      out.add(numbers.data(), numbers.size() * 4);
    }
    out.end();
  }
  file.write(kBakeFileEnd);
  file.commit();
  progress.report(1.0, "writing light");
}

}  // namespace

void writeBakeFile(const fs::path& path, const volume::Grid& grid, const StoredLight& light,
                   base::Progress& progress) {
  try {
    write(path, grid, light, progress);
  } catch (const std::bad_alloc&) {
    throw base::Error(base::ErrorKind::memory, path.string(), "", "out of memory while light is written");
  }
}

bool looksLikeBakeFile(const fs::path& path) {
  constexpr std::size_t searched = 4096;  // the volume's hash is the first field
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) return false;
  std::string beginning(searched, '\0');
  std::ifstream stream(path, std::ios::binary);
  stream.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
  return beginning.find("<VTKFile type=\"ImageData\"") != std::string::npos &&
         beginning.find(kFirstField) != std::string::npos;
}

}  // namespace isolux::gi
