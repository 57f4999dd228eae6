// Writing of bake files: the header with room for the places of the arrays, then the arrays, then the places.
#include <algorithm>
#include <bit>
#include <cstring>
#include <fstream>
#include <functional>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/number_text.h"
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

// Slices of texels.
struct Slab {
  int first = 0, last = 0;
};

std::string extentText(const LatticeGeometry& lattice, Slab slab) {
  return "0 " + std::to_string(lattice.dims.x - 1) + " 0 " + std::to_string(lattice.dims.y - 1) + " " +
         std::to_string(slab.first) + " " + std::to_string(slab.last);
}

// Origin, Spacing, Direction.
std::string placeText(const volume::Grid& grid, const LatticeGeometry& lattice) {
  const volume::GridGeometry& g = grid.geometry();
  std::string spacing, origin, direction;
  const glm::dmat3 directions = g.directions();
  for (int a = 0; a < 3; ++a) {
    const char* const gap = a > 0 ? " " : "";
    const double step = lattice.dims[a] > 1 ? lattice.voxelsPerTexel()[a] : 1.0;
    spacing += gap + exact(g.spacingMm()[a] * step);
    origin += gap + exact(g.originMm()[a]);
    for (int column = 0; column < 3; ++column)
      direction += (direction.empty() ? "" : " ") + exact(directions[column][a]);
  }
  return " Origin=\"" + origin + "\" Spacing=\"" + spacing + "\" Direction=\"" + direction + "\"";
}

std::string header(const volume::Grid& grid, const StoredLight& light, const std::vector<Array>& arrays,
                   Slab slab) {
  const LatticeGeometry& lattice = (light.sky ? light.sky : light.lamps)->geometry();
  const std::string extent = extentText(lattice, slab);
  std::string xml =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n  <ImageData WholeExtent=\"" +
      extent + "\"" + placeText(grid, lattice) + ">\n    <FieldData>\n" +
      bakeTextField("volume_hash", base::hexText(grid.hash()));  // kFirstField
  if (light.sky)
    xml +=
        bakeTextField("key", light.sky->key()) + bakeTextField("content", contentText(light.sky->content()));
  if (light.lamps) xml += bakeTextField("key_lamps", light.lamps->key());
  if (!light.facts.arithmetic.empty()) xml += bakeTextField("arithmetic", light.facts.arithmetic);
  if (light.facts.part) xml += bakeTextField("part", partText(*light.facts.part));
  xml += "    </FieldData>\n    <Piece Extent=\"" + extent + "\">\n      <PointData Scalars=\"" +
         arrays[0].name + "\">\n";
  for (const Array& array : arrays)
    xml += "        <DataArray type=\"" + std::string(array.type) + "\" Name=\"" + array.name +
           "\" NumberOfComponents=\"" + std::to_string(array.components) +
           "\" format=\"appended\" offset=\"" + std::string(kOffsetDigits, '0') + "\"/>\n";
  return xml + "      </PointData>\n    </Piece>\n  </ImageData>\n  <AppendedData encoding=\"raw\">\n_";
}

// What a file of it holds, as it is now.
struct Snapshot {
  Snapshot(const volume::Grid& of, const StoredLight& stored);
  Snapshot(const Snapshot&) = delete;
  Snapshot& operator=(const Snapshot&) = delete;

  const volume::Grid& grid;
  const StoredLight& light;
  const LatticeGeometry& lattice;
  Blocks sky, lamps, normals;
  std::vector<Array> arrays;
};

Blocks blocksOf(const std::shared_ptr<LightLattice>& from) {
  Blocks blocks;
  if (from)
    for (std::uint32_t b = 0; b < from->geometry().blockCount(); ++b) blocks.push_back(from->at(b));
  return blocks;
}

Snapshot::Snapshot(const volume::Grid& of, const StoredLight& stored)
    : grid(of),
      light(stored),
      lattice((stored.sky ? stored.sky : stored.lamps)->geometry()),
      sky(blocksOf(stored.sky)),
      lamps(blocksOf(stored.lamps)),
      normals(stored.sky ? sky : lamps) {  // the same in both
  for (std::size_t b = 0; b < lamps.size(); ++b)
    if (!normals[b]) normals[b] = lamps[b];
  if (light.sky) addArrays(arrays, *light.sky, sky, "");
  if (light.lamps) addArrays(arrays, *light.lamps, lamps, "_lamps");
  arrays.push_back({"normal", "Float32", 3, &normals, nullptr});
}

// A layer's numbers.
std::vector<std::uint32_t> numbersOf(const Snapshot& from, const Array& array, int layer) {
  std::vector<std::uint32_t> numbers(texelsOfLayer(from.lattice, layer) * array.components, 0);
  const auto otherNormal = [&](std::uint32_t block, std::size_t i) {
    return !from.lamps.empty() && from.lamps[block] ? from.lamps[block]->normals[i] : glm::vec3(0.0f);
  };
  const std::uint32_t count = blocksPerLayer(from.lattice), begin = static_cast<std::uint32_t>(layer) * count;
  for (std::uint32_t b = begin; b < begin + count; ++b)
    if (const LatticeBlock* const block = (*array.blocks)[b].get())
      forEachTexelOfBlock(from.lattice, b, [&](std::size_t i, std::size_t t) {
        std::uint32_t* const to = numbers.data() + t * array.components;
        if (array.fill) return array.fill(*block, i, to);
        const glm::vec3 normal = block->normals[i] != glm::vec3(0.0f) ? block->normals[i] : otherNormal(b, i);
        const float components[] = {normal.x, normal.y, normal.z};
        std::memcpy(to, components, sizeof components);
      });
  return numbers;
}

void write(const fs::path& path, const Snapshot& from, Slab slab, base::Progress& progress) {
  const LatticeGeometry& lattice = from.lattice;
  base::OutputFile file(path);
  const std::string xml = header(from.grid, from.light, from.arrays, slab);
  const std::vector<std::size_t> places = offsetsIn(xml);
  file.write(xml);
  const std::size_t slice = volume::Extent3{lattice.dims}.slice();
  const std::uint64_t texels = std::uint64_t{slice} * static_cast<std::uint64_t>(slab.last - slab.first + 1);
  for (std::size_t a = 0; a < from.arrays.size(); ++a) {
    const Array& array = from.arrays[a];
    writeOffset(file, places[a], xml.size());
    ArrayWriter out(file, texels * array.components * 4);
    for (int layer = slab.first / kBlockTexels; layer <= slab.last / kBlockTexels; ++layer) {
      progress.throwIfStopped();
      progress.report((static_cast<double>(a) + static_cast<double>(layer) / layersOf(lattice)) /
                          static_cast<double>(from.arrays.size()),
                      "writing light");
      const std::vector<std::uint32_t> numbers = numbersOf(from, array, layer);
      const int z = layer * kBlockTexels;
      const auto within = static_cast<std::size_t>(slab.last + 1 - z) * slice * array.components;
      out.add(numbers.data(), std::min(numbers.size(), within) * 4);
    }
    out.end();
  }
  file.write(kBakeFileEnd);
  file.commit();
  progress.report(1.0, "writing light");
}

// Slabs begin at layers of blocks; neighbours share a slice, as pieces of points do in VTK.
std::vector<Slab> slabsOf(const LatticeGeometry& lattice, int pieces) {
  const int layers =
      std::max(1, (lattice.dims.z - 2 + kBlockTexels) / kBlockTexels);  // of gaps between slices
  const int count = std::clamp(pieces, 1, layers);
  const auto slice = [&](int piece) {
    const auto layer = static_cast<std::int64_t>(layers) * piece / count;
    return std::min(static_cast<int>(layer) * kBlockTexels, lattice.dims.z - 1);
  };
  std::vector<Slab> slabs;
  for (int piece = 0; piece < count; ++piece) slabs.push_back({slice(piece), slice(piece + 1)});
  slabs.back().last = lattice.dims.z - 1;
  return slabs;
}

std::string escapedXml(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    const bool plain = c != '&' && c != '<' && c != '"';
    escaped += plain ? std::string(1, c) : "&#" + std::to_string(static_cast<unsigned char>(c)) + ";";
  }
  return escaped;
}

void writeIndex(const fs::path& path, const Snapshot& from, const std::vector<Slab>& slabs) {
  std::string xml =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PImageData\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n  <PImageData WholeExtent=\"" +
      extentText(from.lattice, {0, from.lattice.dims.z - 1}) + "\" GhostLevel=\"0\"" +
      placeText(from.grid, from.lattice) + ">\n    <PPointData Scalars=\"" + from.arrays[0].name + "\">\n";
  for (const Array& array : from.arrays)
    xml += "      <PDataArray type=\"" + std::string(array.type) + "\" Name=\"" + array.name +
           "\" NumberOfComponents=\"" + std::to_string(array.components) + "\"/>\n";
  xml += "    </PPointData>\n";
  for (std::size_t i = 0; i < slabs.size(); ++i) {
    const int number = static_cast<int>(i) + 1, count = static_cast<int>(slabs.size());
    xml += "    <Piece Extent=\"" + extentText(from.lattice, slabs[i]) + "\" Source=\"" +
           escapedXml(bakePieceFile(path, number, count).filename().string()) + "\"/>\n";
  }
  base::OutputFile file(path);
  file.write(xml + "  </PImageData>\n</VTKFile>\n");
  file.commit();
}

}  // namespace

void writeBakeFile(const fs::path& path, const volume::Grid& grid, const StoredLight& light,
                   base::Progress& progress) {
  namingFile(path, "written", [&] {
    const Snapshot from(grid, light);
    write(path, from, {0, from.lattice.dims.z - 1}, progress);
  });
}

fs::path bakePieceFile(const fs::path& index, int number, int count) {
  fs::path file = index;
  return file.replace_extension("piece-" + std::to_string(number) + "-of-" + std::to_string(count) + ".vti");
}

void writeBakePieces(const fs::path& index, int pieces, const volume::Grid& grid, const StoredLight& light,
                     base::Progress& progress) {
  namingFile(index, "written", [&] {
    const Snapshot from(grid, light);
    const std::vector<Slab> slabs = slabsOf(from.lattice, pieces);
    const int count = static_cast<int>(slabs.size());
    for (int i = 0; i < count; ++i)
      write(bakePieceFile(index, i + 1, count), from, slabs[static_cast<std::size_t>(i)], progress);
    writeIndex(index, from, slabs);
  });
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
