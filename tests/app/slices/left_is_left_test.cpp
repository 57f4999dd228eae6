// A mark at the patient's left stands under the letter L, whatever the file's format and axes.
#include <cmath>
#include <numbers>
#include <sstream>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "app/slices/slice_content.h"
#include "app/slices/slice_labels.h"
#include "scene/rules/automatic.h"
#include "tests/support/test_data.h"
#include "tests/volume/read/dicom_file.h"
#include "volume/write/writer.h"

namespace isolux::test {
namespace {

namespace fs = std::filesystem;
using scene::Convention;
using volume::GridGeometry;

const glm::dvec3 kMiddle(31.0, -47.0, 112.0), kMark(9.0, -6.5, 7.5);  // mm; left, in front, above
constexpr double kMarkMm = 2.0;

// Voxels of 0.9 x 1.1 x 1.7 mm whose axes lean; stored from head to foot where left-handed.
GridGeometry leaning(bool leftHanded) {
  glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), 0.31, glm::normalize(glm::dvec3(0.3, 1.0, -0.4)));
  turn = glm::rotate(turn, -0.2, glm::dvec3(1.0, 0.2, 0.1));
  glm::dmat3 directions(turn);
  if (leftHanded) directions[2] = -directions[2];
  const glm::ivec3 dims(40, 36, 30);
  const glm::dvec3 spacing(0.9, 1.1, 1.7);
  const glm::dvec3 origin = kMiddle - directions * (0.5 * spacing * glm::dvec3(dims - 1));
  return GridGeometry::make(dims, spacing, origin, directions);
}

std::vector<std::int16_t> voxelsOf(const GridGeometry& geometry) {
  std::vector<std::int16_t> voxels;
  for (int z = 0; z < geometry.dims.z; ++z)
    for (int y = 0; y < geometry.dims.y; ++y)
      for (int x = 0; x < geometry.dims.x; ++x) {
        const glm::dvec3 world(geometry.worldFromVoxel * glm::dvec4(x, y, z, 1));
        const double near = glm::distance(world, kMiddle + kMark) / kMarkMm;
        voxels.push_back(static_cast<std::int16_t>(100 + std::lround(1000.0 * std::exp(-near * near))));
      }
  return voxels;
}

std::string listOf(glm::dvec3 v, const char* between, double sign = 1.0) {
  std::ostringstream out;
  out.precision(12);
  out << sign * v.x << between << sign * v.y << between << v.z;
  return out.str();
}

fs::path writeNrrd(const fs::path& folder) {
  const GridGeometry geometry = leaning(true);
  std::string header =
      "NRRD0005\ntype: int16\ndimension: 3\nsizes: 40 36 30\nencoding: raw\nendian: little\n";
  header +=
      "space: right-anterior-superior\nspace origin: (" + listOf(geometry.originMm(), ",", -1.0) + ")\n";
  header += "space directions:";
  for (int axis = 0; axis < 3; ++axis)
    header += " (" + listOf(glm::dvec3(geometry.worldFromVoxel[axis]), ",", -1.0) + ")";
  writeFile(folder / "mark.nrrd", header + "\n\n" + bytesOf(voxelsOf(geometry)));
  return folder / "mark.nrrd";
}

fs::path writeNifti(const fs::path& folder) {
  const GridGeometry geometry = leaning(true);
  NiftiFile file;
  file.dims = {40, 36, 30};
  file.datatype = 4;
  file.bitpix = 16;
  file.pixdim = {1.0f, 0.9f, 1.1f, 1.7f};
  file.sformCode = 1;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column)
      file.srow[static_cast<std::size_t>(4 * row + column)] =
          static_cast<float>((row < 2 ? -1.0 : 1.0) * geometry.worldFromVoxel[column][row]);
  file.voxels = bytesOf(voxelsOf(geometry));
  writeFile(folder / "mark.nii", file.bytes());
  return folder / "mark.nii";
}

fs::path writeMetaImage(const fs::path& folder) {
  const GridGeometry geometry = leaning(true);
  volume::writeVolume(volume::Grid(geometry, voxelsOf(geometry)), folder / "mark.mha",
                      scene::WorldAxes::anatomical);
  return folder / "mark.mha";
}

fs::path writeDicom(const fs::path& folder) {
  const GridGeometry geometry = leaning(false);
  const std::vector<std::int16_t> voxels = voxelsOf(geometry);
  const glm::dmat3 directions = geometry.directions();
  fs::create_directories(folder / "series");
  for (int z = 0; z < 30; ++z) {
    DicomSlice slice;
    slice.instance = 30 - z;
    slice.columns = 40;
    slice.rows = 36;
    slice.intercept = "0";
    slice.position = listOf(glm::dvec3(geometry.worldFromVoxel * glm::dvec4(0, 0, z, 1)), "\\");
    slice.orientation = listOf(directions[0], "\\") + "\\" + listOf(directions[1], "\\");
    slice.spacing = "1.1\\0.9";
    slice.thickness = "1.7";
    const auto begin = voxels.begin() + z * 40 * 36;
    slice.pixels = bytesOf(std::vector<std::int16_t>(begin, begin + 40 * 36));
    writeFile(folder / "series" / ("IM" + std::to_string(z)), dicom(slice));
  }
  return folder / "series";
}

// Where the mark's centre of mass lies from the pixel that shows the middle, mm to the right and down.
glm::dvec2 markFrom(const app::SliceContent& content) {
  glm::dvec2 sum(0.0);
  double mass = 0.0;
  for (int y = 0; y < content.plane.size.y; ++y)
    for (int x = 0; x < content.plane.size.x; ++x) {
      const float value = content.values.values[static_cast<std::size_t>(y * content.plane.size.x + x)];
      if (!(value > 100.0f)) continue;
      mass += value - 100.0;
      sum += (value - 100.0) * glm::dvec2(x, y);
    }
  return content.plane.pixelMm() * (sum / mass - content.plane.pixelOf(kMiddle));
}

// The mark lies `mm` towards the side that this letter names: `before`, `behind` are the picture's ends.
void expectAt(const std::string& before, const std::string& behind, const std::string& letter,
              const std::string& opposite, double found, double mm) {
  ASSERT_TRUE((before == letter && behind == opposite) || (before == opposite && behind == letter))
      << before << behind;
  EXPECT_NEAR(behind == letter ? found : -found, mm, 0.1) << letter;
}

class LeftIsLeft : public testing::TestWithParam<fs::path (*)(const fs::path&)> {};

TEST_P(LeftIsLeft, InEverySliceAndBothConventions) {
  base::Progress progress;
  scene::Source source;
  source.path = GetParam()(temporaryFolder());
  const auto prepared = volume::loadVolume(source, progress);
  ASSERT_EQ(prepared->volume.axes, scene::WorldAxes::anatomical);
  const GridGeometry& geometry = prepared->grid().geometry();
  for (const Convention convention : {Convention::radiological, Convention::neurological}) {
    scene::Scene scene = scene::resolve({}, prepared->facts);
    scene.slice.convention = convention;
    const auto contentOf = [&](volume::SliceDirection direction) {
      const auto frame = sliceFrame(direction, prepared->volume.axes, convention);
      return app::sliceContent(*prepared, scene, fittedSlice(geometry, frame, kMiddle + kMark, {300, 300}),
                               progress);
    };
    const auto lettersAndMark = [&](volume::SliceDirection direction) {
      const app::SliceContent content = contentOf(direction);
      return std::pair{app::lettersOf(content.plane, prepared->volume.axes), markFrom(content)};
    };
    const auto [axial, inAxial] = lettersAndMark(volume::SliceDirection::axial);
    expectAt(axial.left, axial.right, "L", "R", inAxial.x, kMark.x);
    expectAt(axial.top, axial.bottom, "P", "A", inAxial.y, kMark.y);
    EXPECT_EQ(axial.left, convention == Convention::radiological ? "R" : "L");
    EXPECT_EQ(axial.top, "A");
    const auto [coronal, inCoronal] = lettersAndMark(volume::SliceDirection::coronal);
    expectAt(coronal.left, coronal.right, "L", "R", inCoronal.x, kMark.x);
    expectAt(coronal.top, coronal.bottom, "S", "I", inCoronal.y, kMark.z);
    EXPECT_EQ(coronal.left, axial.left);
    EXPECT_EQ(coronal.top, "S");
    const auto [sagittal, inSagittal] = lettersAndMark(volume::SliceDirection::sagittal);
    expectAt(sagittal.left, sagittal.right, "P", "A", inSagittal.x, kMark.y);
    expectAt(sagittal.top, sagittal.bottom, "S", "I", inSagittal.y, kMark.z);
    EXPECT_EQ(sagittal.left, "A");
  }
}
INSTANTIATE_TEST_SUITE_P(EveryFormat, LeftIsLeft,
                         testing::Values(&writeNrrd, &writeNifti, &writeMetaImage, &writeDicom));

}  // namespace
}  // namespace isolux::test
