// One frame of a DICOM file, small.
#include <algorithm>
#include <cmath>

#include <vtkDataArray.h>

#include "base/color.h"
#include "base/error.h"
#include "base/quantiles.h"
#include "readers/dicom/dicom.h"
#include "readers/limits.h"
#include "readers/vtk_messages.h"
#include "volume/read/input/bytes.h"
#include "volume/read/input/payload.h"

namespace isolux::readers {

using namespace volume;
namespace fs = std::filesystem;
using base::throwInput;

namespace {

constexpr int longestSide = 160;  // pixels

// A frame's samples as doubles: means over cells of about a pixel of the small picture.
struct Reduced {
  int width = 0, height = 0;
  std::vector<glm::dvec3> samples;
};

// So that pixels are square and the longer side is at most `longestSide`.
glm::ivec2 smallSize(const DicomFile& file) {
  const DicomFrame& frame = file.frames.front();
  const double ratio =
      frame.spacingXMm > 0.0 && frame.spacingYMm > 0.0 ? frame.spacingXMm / frame.spacingYMm : 1.0;
  const double width = file.columns * std::clamp(ratio, 0.05, 20.0), height = file.rows;
  const double scale = longestSide / std::max({width, height, 1.0});
  const auto pixels = [&](double length) {
    return std::clamp(static_cast<int>(std::lround(length * scale)), 1, longestSide);
  };
  return {pixels(width), pixels(height)};
}

// `voxel(x, y, component)` of the frame.
template <class Voxel>
Reduced reduced(const DicomFile& file, const Voxel& voxel) {
  const glm::ivec2 size = smallSize(file);
  Reduced small{size.x, size.y, {}};
  const auto first = [](int i, int count, int of) {
    return static_cast<int>(static_cast<std::int64_t>(i) * of / count);
  };
  const int channels = file.samples >= 3 ? 3 : 1;
  for (int row = 0; row < size.y; ++row) {
    const int top = first(row, size.y, file.rows);
    const int bottom = std::max(first(row + 1, size.y, file.rows), top + 1);
    for (int column = 0; column < size.x; ++column) {
      const int left = first(column, size.x, file.columns);
      const int right = std::max(first(column + 1, size.x, file.columns), left + 1);
      glm::dvec3 sum(0.0);
      for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x)
          for (int c = 0; c < 3; ++c) sum[c] += voxel(x, y, std::min(c, channels - 1));
      small.samples.push_back(sum / static_cast<double>((bottom - top) * (right - left)));
    }
  }
  return small;
}

// What is black and what is white: the file's window, else all but the most extreme hundredths.
std::pair<double, double> greyRange(const DicomFile& file, const Reduced& small) {
  if (file.windowWidth > 0.0)
    return {file.windowCenter - 0.5 * file.windowWidth, file.windowCenter + 0.5 * file.windowWidth};
  std::vector<double> values;
  for (const glm::dvec3& sample : small.samples) values.push_back(sample.x);
  return {base::quantile(values, 0.01), base::quantile(values, 0.99)};
}

DecodedImage shown(const DicomFile& file, Reduced small) {
  DecodedImage image{small.width, small.height, {}};
  const bool colours = file.samples >= 3;
  auto [black, white] = colours ? std::pair(0.0, 255.0) : greyRange(file, small);
  if (!(white > black)) white = black + 1.0;
  for (const glm::dvec3& sample : small.samples) {
    glm::vec3 pixel;
    for (int c = 0; c < 3; ++c) {
      double grey = std::clamp((sample[c] - black) / (white - black), 0.0, 1.0);
      if (file.darkIsHigh() && !colours) grey = 1.0 - grey;
      pixel[c] = static_cast<float>(base::decodeSrgb(grey));
    }
    image.pixels.push_back(pixel);
  }
  return image;
}

}  // namespace

DecodedImage previewDicomFile(const fs::path& path, const ReadOptions& options, base::Progress& progress) {
  allowHeaders(1, FileBytes(path).size());
  const DicomFile file = readHeader(path);
  if (!file.notAScan.empty()) throwInput(path.string(), "SOPClassUID", file.notAScan);
  const auto frame = static_cast<std::size_t>(std::max(options.timeStep, 0));
  if (frame >= file.frames.size()) throwInput(path.string(), "", "has no such image");
  const auto type = voxelTypeOf(file);
  if (!type) throwInput(path.string(), "BitsAllocated", "is not supported");
  const std::uint64_t values = std::uint64_t{file.decodedPixels()} * static_cast<std::uint64_t>(file.samples);
  checkBudget(values * bytesOf(*type), "its images", "", path.string(), options);
  allowDecoding(FileBytes(path).size());
  const VtkMessages messages;
  const auto array = decodeFiles({file}, path.string(), messages, progress);
  const DicomFrame& header = file.frames[frame];
  return shown(file, reduced(file, [&](int x, int y, int component) {
                 const double stored =
                     array->GetComponent(static_cast<vtkIdType>(file.decodedRow(frame, y)) + x, component);
                 return file.samples >= 3 ? stored : file.valueOf(header, stored);
               }));
}

}  // namespace isolux::readers
