#include "volume/write/writer.h"

#include <array>
#include <cmath>
#include <cstring>
#include <vector>

#include <glm/matrix.hpp>

#include "base/error.h"
#include "base/number_text.h"
#include "base/pending_file.h"
#include "base/words.h"
#include "volume/read/input/text.h"

namespace isolux::volume {

namespace fs = std::filesystem;

namespace {

// Voxels as they go into the file: without slope and intercept, for which these formats have no field.
struct Values {
  VoxelType type;
  VoxelArray stored;                 // when the type is one of a Grid
  std::vector<double> wide;          // float64
  std::span<const std::byte> bytes;  // of either
};

template <typename T>
std::vector<T> applied(const Grid& grid) {
  return grid.visit([&](const auto& array) {
    std::vector<T> out;
    out.reserve(array.size());
    for (const auto v : array) out.push_back(static_cast<T>(grid.valueOfStored(static_cast<double>(v))));
    return out;
  });
}

bool every(const Grid& grid, bool (*test)(double)) {
  return grid.visit([&](const auto& array) {
    for (const auto v : array)
      if (!test(grid.valueOfStored(static_cast<double>(v)))) return false;
    return true;
  });
}

// The stored type where slope and intercept lead back into it exactly; else the narrowest type that holds
// every value.
void fill(const Grid& grid, Values& values) {
  const auto view = [](const auto& array) { return std::as_bytes(std::span(array)); };
  values.type = grid.storedType();
  if (grid.slope() == 1.0 && grid.intercept() == 0.0) {
    values.bytes = grid.visit(view);
    return;
  }
  const auto integers = [](double v) { return v == std::trunc(v) && std::abs(v) <= 65535.0; };
  const auto floats = [](double v) {
    return std::isnan(v) || (std::abs(v) <= 3.4e38 && static_cast<double>(static_cast<float>(v)) == v);
  };
  const double low = grid.minimum(), high = grid.maximum();
  const auto use = [&]<typename T>(VoxelType type, T) {
    values.type = type;
    values.stored = applied<T>(grid);
    values.bytes = std::visit(view, values.stored);
  };
  const bool whole = grid.missingCount() == 0 && every(grid, integers);
  if (whole && values.type == VoxelType::uint8 && low >= 0 && high <= 255)
    return use(VoxelType::uint8, std::uint8_t{});
  if (whole && values.type == VoxelType::int8 && low >= -128 && high <= 127)
    return use(VoxelType::int8, std::int8_t{});
  if (whole && values.type == VoxelType::uint16 && low >= 0) return use(VoxelType::uint16, std::uint16_t{});
  if (whole && low >= -32768 && high <= 32767) return use(VoxelType::int16, std::int16_t{});
  if (whole && low >= 0) return use(VoxelType::uint16, std::uint16_t{});
  if (every(grid, floats)) return use(VoxelType::float32, float{});
  values.type = VoxelType::float64;
  values.wide = applied<double>(grid);
  values.bytes = view(values.wide);
}

std::string joined(const glm::dvec3& v, const char* separator = " ") {
  return base::joined(std::array{v.x, v.y, v.z}, separator, base::exactText);
}

std::string joined(const glm::dmat3& columns) {
  return joined(columns[0]) + " " + joined(columns[1]) + " " + joined(columns[2]);
}

std::string dimsText(const Grid& grid) {
  const glm::ivec3 n = grid.dims();
  return std::to_string(n.x) + " " + std::to_string(n.y) + " " + std::to_string(n.z);
}

// As ITK writes it: the ends that the voxel axes come from.
std::string anatomicalOrientation(const Grid& grid) {
  const glm::dmat3 d = grid.geometry().directions();
  std::string letters;
  for (int axis = 0; axis < 3; ++axis) letters += axisEnd(scene::WorldAxes::anatomical, -d[axis]);
  return letters;
}

std::string metaImageHeader(const Grid& grid, VoxelType type, const std::string& dataFile,
                            scene::WorldAxes axes) {
  static constexpr const char* types[] = {"MET_CHAR",  "MET_UCHAR", "MET_SHORT",     "MET_USHORT",
                                          "MET_INT",   "MET_UINT",  "MET_LONG_LONG", "MET_ULONG_LONG",
                                          "MET_FLOAT", "MET_DOUBLE"};
  const GridGeometry& g = grid.geometry();
  return "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\nCompressedData = "
         "False\n"
         "TransformMatrix = " +
         joined(g.directions()) +
         (axes == scene::WorldAxes::anatomical ? "\nAnatomicalOrientation = " + anatomicalOrientation(grid)
                                               : "") +
         "\nOffset = " + joined(g.originMm()) + "\nElementSpacing = " + joined(g.spacingMm()) +
         "\nDimSize = " + dimsText(grid) + "\nElementType = " + types[static_cast<int>(type)] +
         "\nElementDataFile = " + dataFile + "\n";
}

std::string nrrdHeader(const Grid& grid, VoxelType type, scene::WorldAxes axes) {
  static constexpr const char* types[] = {"int8",   "uint8", "int16",  "uint16", "int32",
                                          "uint32", "int64", "uint64", "float",  "double"};
  const GridGeometry& g = grid.geometry();
  const auto column = [&](int axis) { return "(" + joined(glm::dvec3(g.worldFromVoxel[axis]), ",") + ")"; };
  return std::string("NRRD0004\n# written by Isolux\ntype: ") + types[static_cast<int>(type)] +
         "\ndimension: 3\n" +
         (axes == scene::WorldAxes::anatomical ? "space: left-posterior-superior" : "space dimension: 3") +
         "\nsizes: " + dimsText(grid) + "\nspace directions: " + column(0) + " " + column(1) + " " +
         column(2) +
         "\nkinds: domain domain domain\nendian: little\nencoding: raw\nspace origin: " + column(3) + "\n\n";
}

std::string vtiHeader(const Grid& grid, VoxelType type, std::uint64_t bytes) {
  static constexpr const char* types[] = {"Int8",   "UInt8", "Int16",  "UInt16",  "Int32",
                                          "UInt32", "Int64", "UInt64", "Float32", "Float64"};
  const GridGeometry& g = grid.geometry();
  const glm::ivec3 n = grid.dims();
  const std::string extent =
      "0 " + std::to_string(n.x - 1) + " 0 " + std::to_string(n.y - 1) + " 0 " + std::to_string(n.z - 1);
  std::string text =
      "<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
      "  <ImageData WholeExtent=\"" +
      extent + "\" Origin=\"" + joined(g.originMm()) + "\" Spacing=\"" + joined(g.spacingMm()) +
      "\" Direction=\"" + joined(glm::transpose(g.directions())) + "\">\n    <Piece Extent=\"" + extent +
      "\">\n      <PointData Scalars=\"value\">\n        <DataArray type=\"" + types[static_cast<int>(type)] +
      "\" Name=\"value\" format=\"appended\" offset=\"0\"/>\n"
      "      </PointData>\n    </Piece>\n  </ImageData>\n  <AppendedData encoding=\"raw\">\n   _";
  char size[8];
  std::memcpy(size, &bytes, 8);
  return text + std::string(size, 8);
}

}  // namespace

void writeVolume(const Grid& grid, const fs::path& path, scene::WorldAxes axes) {
  const std::string extension = lowered(path.extension().string());
  if (extension != ".mhd" && extension != ".mha" && extension != ".nrrd" && extension != ".vti")
    base::throwUsage(path.string(), "file name",
                     "volumes are written as .mhd, .mha, .nrrd or .vti, not as " + inQuotes(extension));
  Values values;
  fill(grid, values);
  base::OutputFile file(path);
  if (extension == ".mhd") {
    fs::path data = path;
    data.replace_extension(".raw");
    base::OutputFile raw(data);
    raw.write(values.bytes.data(), values.bytes.size());
    raw.finish();
    file.write(metaImageHeader(grid, values.type, data.filename().string(), axes));
    file.finish();
    raw.commit();  // the voxels first: a header never stands without them
  } else {
    if (extension == ".mha") file.write(metaImageHeader(grid, values.type, "LOCAL", axes));
    if (extension == ".nrrd") file.write(nrrdHeader(grid, values.type, axes));
    if (extension == ".vti") file.write(vtiHeader(grid, values.type, values.bytes.size()));
    file.write(values.bytes.data(), values.bytes.size());
    if (extension == ".vti") file.write("\n  </AppendedData>\n</VTKFile>\n");
  }
  file.commit();
}

}  // namespace isolux::volume
