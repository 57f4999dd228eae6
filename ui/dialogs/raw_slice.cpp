#include "ui/dialogs/raw_slice.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>
#include <vector>

#include <QFile>

#include "base/quantiles.h"
#include "volume/read/input/convert.h"

namespace isolux::ui {

namespace {

using volume::RawDescription;
using volume::VoxelType;

template <class T>
double decode(const char* bytes, bool swap) {
  std::array<char, sizeof(T)> copy;
  std::memcpy(copy.data(), bytes, sizeof(T));
  if (swap) std::reverse(copy.begin(), copy.end());
  return static_cast<double>(std::bit_cast<T>(copy));
}

double decodeVoxel(const char* bytes, VoxelType type, bool swap) {
  return volume::withType(type, [&](auto zero) { return decode<decltype(zero)>(bytes, swap); });
}

// Values at the given fractions of the sorted finite values.
std::pair<double, double> percentiles(std::vector<double> values, double low, double high) {
  std::erase_if(values, [](double v) { return !std::isfinite(v); });
  if (values.empty()) return {0.0, 1.0};
  double a = base::lowerQuantile(values, low), b = base::lowerQuantile(values, high);
  if (!(b > a)) {  // few bright voxels in a constant slice: the whole range
    a = *std::min_element(values.begin(), values.end());
    b = *std::max_element(values.begin(), values.end());
  }
  return {a, b > a ? b : a + 1.0};
}

}  // namespace

std::optional<QImage> rawSlice(const QString& path, const RawDescription& description, int z,
                               int longestSide) {
  const glm::ivec3 dims = description.dims;
  if (dims.x < 1 || dims.y < 1 || z < 0 || z >= dims.z || longestSide < 1) return std::nullopt;
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) return std::nullopt;

  const auto voxelBytes = static_cast<qint64>(volume::bytesOf(description.type));
  const qint64 rowBytes = voxelBytes * dims.x;
  constexpr qint64 readBudget = 64 << 20;
  const qint64 rows = std::clamp<qint64>(readBudget / rowBytes, 1, std::min(dims.y, longestSide));
  const qint64 columns = std::min(dims.x, longestSide);
  const bool swap =
      (description.endianness == volume::Endianness::big) == (std::endian::native == std::endian::little);

  std::vector<double> values(static_cast<std::size_t>(rows * columns),
                             std::numeric_limits<double>::quiet_NaN());
  QByteArray row(rowBytes, '\0');
  const auto start = static_cast<long double>(description.headerBytes) +
                     static_cast<long double>(z) * static_cast<long double>(rowBytes) * dims.y;
  if (start + static_cast<long double>(rowBytes) * dims.y > static_cast<long double>(file.size()))
    return std::nullopt;
  for (qint64 r = 0; r < rows; ++r) {
    const qint64 y = r * dims.y / rows;
    if (!file.seek(static_cast<qint64>(start) + y * rowBytes)) return std::nullopt;
    if (file.read(row.data(), rowBytes) != rowBytes) return std::nullopt;
    for (qint64 c = 0; c < columns; ++c) {
      const qint64 x = c * dims.x / columns;
      values[static_cast<std::size_t>(r * columns + c)] =
          decodeVoxel(row.constData() + x * voxelBytes, description.type, swap);
    }
  }

  const auto [black, white] = percentiles(values, 0.01, 0.99);
  QImage image(static_cast<int>(columns), static_cast<int>(rows), QImage::Format_RGB32);
  for (qint64 r = 0; r < rows; ++r) {
    auto* line = reinterpret_cast<QRgb*>(image.scanLine(static_cast<int>(r)));
    for (qint64 c = 0; c < columns; ++c) {
      const double value = values[static_cast<std::size_t>(r * columns + c)];
      if (!std::isfinite(value)) {
        line[c] = qRgb(110, 20, 20);
        continue;
      }
      const int grey =
          static_cast<int>(std::lround(std::clamp((value - black) / (white - black), 0.0, 1.0) * 255.0));
      line[c] = qRgb(grey, grey, grey);
    }
  }
  return image;
}

}  // namespace isolux::ui
