#include "volume/read/input/convert.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include "base/number_text.h"

namespace isolux::volume {

namespace {

constexpr std::size_t chunkVoxels = std::size_t{1} << 20;  // between looks at the stop request

template <typename From, typename F>
void forEach(const std::vector<From>& from, const base::Progress& progress, F&& f) {
  for (std::size_t begin = 0; begin < from.size(); begin += chunkVoxels) {
    progress.throwIfStopped();
    const std::size_t end = std::min(from.size(), begin + chunkVoxels);
    for (std::size_t i = begin; i < end; ++i) f(from[i]);
  }
}

// to[i] = f(from[i]).
template <typename To, typename From, typename F>
std::vector<To> mapped(const std::vector<From>& from, const base::Progress& progress, F&& f) {
  std::vector<To> to;
  to.reserve(from.size());
  forEach(from, progress, [&](From v) { to.push_back(f(v)); });
  return to;
}

template <typename To, typename From>
bool holds(From least, From most) {
  return std::in_range<To>(least) && std::in_range<To>(most);
}

// `least` and `most` bound every voxel, and every voxel is a whole number.
template <typename From, typename Whole>
std::optional<VoxelArray> asSmallInteger(const std::vector<From>& from, Whole least, Whole most,
                                         const base::Progress& progress) {
  const auto cast = [&]<typename To>(To) {
    return VoxelArray(mapped<To>(from, progress, [](From v) { return static_cast<To>(v); }));
  };
  if (holds<std::uint8_t>(least, most)) return cast(std::uint8_t{});
  if (holds<std::int8_t>(least, most)) return cast(std::int8_t{});
  if (holds<std::int16_t>(least, most)) return cast(std::int16_t{});
  if (holds<std::uint16_t>(least, most)) return cast(std::uint16_t{});
  return std::nullopt;
}

std::string change(std::string_view type, double largest, double range) {
  return std::string(type) + " voxels stored as float32: values change by up to " + base::shortText(largest) +
         " in a range of " + base::shortText(range);
}

template <typename From>
StoredVoxels fromWideInteger(const std::vector<From>& from, const base::Progress& progress,
                             std::vector<std::string>& warnings) {
  using Unsigned = std::make_unsigned_t<From>;
  From least = std::numeric_limits<From>::max(), most = std::numeric_limits<From>::lowest();
  forEach(from, progress, [&](From v) {
    least = std::min(least, v);
    most = std::max(most, v);
  });
  if (auto small = asSmallInteger(from, least, most, progress)) return {std::move(*small), 1.0, 0.0};

  constexpr std::int64_t exactInFloat = std::int64_t{1} << 24, exactInDouble = std::int64_t{1} << 53;
  const auto fits = [](From v, std::int64_t limit) {
    return std::cmp_less_equal(v, limit) && std::cmp_greater_equal(v, -limit);
  };
  if (fits(least, exactInFloat) && fits(most, exactInFloat))
    return {mapped<float>(from, progress, [](From v) { return static_cast<float>(v); }), 1.0, 0.0};

  // Differences as unsigned numbers: exact, whatever the signs.
  const auto above = [](From v, From base) {
    return static_cast<Unsigned>(static_cast<Unsigned>(v) - static_cast<Unsigned>(base));
  };
  const Unsigned range = above(most, least);
  if (fits(least, exactInDouble)) {
    const double intercept = static_cast<double>(least);
    if (range <= 65535u)
      return {mapped<std::uint16_t>(from, progress,
                                    [&](From v) { return static_cast<std::uint16_t>(above(v, least)); }),
              1.0, intercept};
    if (range <= static_cast<Unsigned>(exactInFloat))
      return {mapped<float>(from, progress, [&](From v) { return static_cast<float>(above(v, least)); }), 1.0,
              intercept};
  }
  // Half the range above the least value, so that the differences are as small as they can be.
  const From middle = static_cast<From>(static_cast<Unsigned>(least) + range / 2);
  const auto difference = [&](From v) {
    return v >= middle ? static_cast<double>(above(v, middle)) : -static_cast<double>(above(middle, v));
  };
  double largest = 0.0;
  auto stored = mapped<float>(from, progress, [&](From v) {
    const double exact = difference(v);
    const float f = static_cast<float>(exact);
    largest = std::max(largest, std::abs(static_cast<double>(f) - exact));
    return f;
  });
  if (largest > 0.0) warnings.push_back(change("wide integer", largest, static_cast<double>(range)));
  return {std::move(stored), 1.0, static_cast<double>(middle)};
}

struct DoubleFacts {
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();
  double largestAbsolute = 0.0;
  double largestChange = 0.0;  // when cast to float
  bool whole = true, allFinite = true;
};

DoubleFacts factsOf(const std::vector<double>& from, const base::Progress& progress) {
  DoubleFacts facts;
  forEach(from, progress, [&](double v) {
    if (!std::isfinite(v)) {
      facts.allFinite = false;
      return;
    }
    facts.least = std::min(facts.least, v);
    facts.most = std::max(facts.most, v);
    facts.largestAbsolute = std::max(facts.largestAbsolute, std::abs(v));
    // Beyond the largest float the cast would be undefined.
    const double change = std::abs(v) > static_cast<double>(std::numeric_limits<float>::max())
                              ? std::numeric_limits<double>::infinity()
                              : std::abs(static_cast<double>(static_cast<float>(v)) - v);
    facts.largestChange = std::max(facts.largestChange, change);
    facts.whole = facts.whole && v == std::trunc(v) && !(v == 0.0 && std::signbit(v));
  });
  return facts;
}

float toFloat(double v) {
  return std::isfinite(v) ? static_cast<float>(v) : std::numeric_limits<float>::quiet_NaN();
}

StoredVoxels fromDouble(const std::vector<double>& from, const base::Progress& progress,
                        std::vector<std::string>& warnings) {
  const DoubleFacts facts = factsOf(from, progress);
  if (facts.least > facts.most) return {mapped<float>(from, progress, toFloat), 1.0, 0.0};  // nothing finite
  if (facts.whole && facts.allFinite && facts.largestAbsolute <= 65535.0) {
    if (auto small = asSmallInteger(from, static_cast<std::int64_t>(facts.least),
                                    static_cast<std::int64_t>(facts.most), progress))
      return {std::move(*small), 1.0, 0.0};
  }
  const double halfRange = facts.most / 2 - facts.least / 2;  // the range itself may overflow
  const double halfUlp = halfRange * 0x1p-23;                 // half a float32 ulp of the range
  if (facts.largestChange / 2 <= halfUlp) return {mapped<float>(from, progress, toFloat), 1.0, 0.0};

  // value = slope * stored + intercept. The intercept takes away what all values share, the slope (a power
  // of two, so exact) brings the rest into the range of normal float32 numbers.
  const double intercept =
      facts.least == facts.most ? facts.least : facts.least / 2 + facts.most / 2;  // the sum may overflow
  double slope = 1.0;
  if (halfRange > 1e30 || (halfRange > 0.0 && halfRange < 1e-20))
    slope = std::ldexp(1.0, std::ilogb(halfRange));
  if (slope < std::numeric_limits<double>::min()) slope = std::numeric_limits<double>::min();
  double largest = 0.0;
  auto stored = mapped<float>(from, progress, [&](double v) {
    float f = toFloat((v - intercept) / slope);
    // Rounded up beyond the largest double.
    if (std::isfinite(f) && !std::isfinite(slope * static_cast<double>(f) + intercept))
      f = std::nextafter(f, 0.0f);
    if (std::isfinite(f))
      largest = std::max(largest, std::abs((slope * static_cast<double>(f) + intercept) - v));
    return f;
  });
  if (largest / 2 > halfUlp) warnings.push_back(change("float64", largest, 2.0 * halfRange));
  return {std::move(stored), slope, intercept};
}

}  // namespace

std::optional<VoxelType> integerType(std::size_t bytes, bool isSigned) {
  for (int type = 0; type < static_cast<int>(VoxelType::float32); type += 2)  // with a sign, then without
    if (bytesOf(static_cast<VoxelType>(type)) == bytes)
      return static_cast<VoxelType>(isSigned ? type : type + 1);
  return std::nullopt;
}

StoredVoxels toStored(FileVoxels&& voxels, const base::Progress& progress,
                      std::vector<std::string>& warnings) {
  return std::visit(
      [&](auto&& array) -> StoredVoxels {
        using T = typename std::decay_t<decltype(array)>::value_type;
        if constexpr (std::is_same_v<T, double>) {
          return fromDouble(array, progress, warnings);
        } else if constexpr (std::is_integral_v<T> && sizeof(T) >= 4) {
          return fromWideInteger(array, progress, warnings);
        } else {
          return {VoxelArray(std::forward<decltype(array)>(array)), 1.0, 0.0};
        }
      },
      std::move(voxels));
}

}  // namespace isolux::volume
