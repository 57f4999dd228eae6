// Wide types into the five stored types: exact where possible, never more than one ulp of the range away.
#include <cmath>
#include <limits>

#include "tests/volume/read/reader_support.h"
#include "volume/read/input/convert.h"

namespace isolux {
namespace {

using volume::StoredVoxels;

template <typename T>
StoredVoxels convert(std::vector<T> values, std::vector<std::string>* warnings = nullptr) {
  base::Progress progress;
  std::vector<std::string> own;
  StoredVoxels stored = volume::toStored(std::move(values), progress, warnings ? *warnings : own);
  if (!warnings) {
    EXPECT_THAT(own, testing::IsEmpty());
  }
  return stored;
}

std::vector<double> valuesOf(const StoredVoxels& stored) {
  std::vector<double> values;
  std::visit(
      [&](const auto& array) {
        for (const auto v : array) values.push_back(stored.slope * static_cast<double>(v) + stored.intercept);
      },
      stored.voxels);
  return values;
}

template <typename T>
bool holds(const StoredVoxels& stored) {
  return std::holds_alternative<std::vector<T>>(stored.voxels);
}

TEST(Convert, SmallIntegersTakeTheSmallestType) {
  EXPECT_TRUE(holds<std::uint8_t>(convert<std::int32_t>({0, 255})));
  EXPECT_TRUE(holds<std::int8_t>(convert<std::int64_t>({-128, 127})));
  EXPECT_TRUE(holds<std::int16_t>(convert<std::int32_t>({-1024, 3071})));
  EXPECT_TRUE(holds<std::uint16_t>(convert<std::uint64_t>({0, 65535})));
  EXPECT_TRUE(holds<std::uint8_t>(convert<double>({0.0, 255.0})));
  EXPECT_TRUE(holds<std::int16_t>(convert<double>({-300.0, 255.0})));
  EXPECT_TRUE(holds<float>(convert<double>({0.5, 255.0})));
}

TEST(Convert, IntegersWithAnOffsetAreExact) {
  const std::vector<std::int64_t> far{9000000000, 9000000001, 9000065535};
  const StoredVoxels stored = convert(far);
  EXPECT_TRUE(holds<std::uint16_t>(stored));
  EXPECT_THAT(valuesOf(stored), testing::ElementsAre(9000000000.0, 9000000001.0, 9000065535.0));
  const StoredVoxels wider = convert<std::uint32_t>({4294967295u, 4294967295u - 16777216u, 4294967295u - 7u});
  EXPECT_TRUE(holds<float>(wider));
  EXPECT_THAT(valuesOf(wider), testing::ElementsAre(4294967295.0, 4278190079.0, 4294967288.0));
}

TEST(Convert, ExtremeIntegersStayWithinAnUlpOfTheRangeAndSaySo) {
  constexpr std::int64_t least = std::numeric_limits<std::int64_t>::min();
  constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
  const std::vector<std::int64_t> values{least, -1, 0, 12345678901234567, most};
  std::vector<std::string> warnings;
  const auto got = valuesOf(convert(values, &warnings));
  const double ulp = 0x1p64 * 0x1p-23;
  for (std::size_t i = 0; i < values.size(); ++i) EXPECT_NEAR(got[i], static_cast<double>(values[i]), ulp);
  EXPECT_THAT(warnings, testing::ElementsAre(testing::HasSubstr("wide integer")));
  const auto big = valuesOf(convert<std::uint64_t>({0, ~std::uint64_t{0}}, &warnings));
  EXPECT_NEAR(big[0], 0.0, ulp);
  EXPECT_NEAR(big[1], 0x1p64, ulp);
}

TEST(Convert, MillionPlusSmallKeepsTheSmallPart) {
  std::vector<double> values;
  for (int i = 0; i < 1000; ++i) values.push_back(1e6 + 1e-3 * i / 1000.0);
  const auto got = valuesOf(convert(values));
  const double ulp = (values.back() - values.front()) * 0x1p-23;
  for (std::size_t i = 0; i < values.size(); ++i) {
    // One rounding of slope * stored + intercept in double is unavoidable: 1.2e-10 at 1e6.
    EXPECT_NEAR(got[i], values[i], ulp + 0x1p-33) << i;
  }
}

TEST(Convert, TinyAndHugeDoublesKeepTheirPrecision) {
  for (const double scale : {1e-300, 1e-45, 1e-20, 1.0, 1e30, 1e300}) {
    SCOPED_TRACE(scale);
    std::vector<double> values;
    for (int i = -50; i <= 70; ++i) values.push_back(scale * i / 3.0);
    const StoredVoxels stored = convert(values);
    const auto got = valuesOf(stored);
    const double ulp = (values.back() - values.front()) * 0x1p-23;
    for (std::size_t i = 0; i < values.size(); ++i) EXPECT_NEAR(got[i], values[i], ulp);
    EXPECT_TRUE(std::isfinite(stored.slope) && stored.slope != 0.0 && std::isfinite(stored.intercept));
  }
  const double most = std::numeric_limits<double>::max();
  const auto extremes = valuesOf(convert<double>({-most, 0.0, most}));
  for (double v : extremes) EXPECT_FALSE(std::isnan(v));
}

TEST(Convert, ConstantDoublesAreExact) {
  for (const double value : {0.1, 1e300, -1e-310, 123456789.123}) {
    EXPECT_THAT(valuesOf(convert(std::vector<double>(5, value))), testing::Each(value));
  }
}

TEST(Convert, NaNAndInfinityBecomeMissing) {
  const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  const StoredVoxels stored = convert<double>({1.0, nan, inf, -inf, 2.0});
  ASSERT_TRUE(holds<float>(stored));
  const auto& array = std::get<std::vector<float>>(stored.voxels);
  EXPECT_EQ(array[0], 1.0f);
  EXPECT_EQ(array[4], 2.0f);
  for (int i : {1, 2, 3}) EXPECT_TRUE(std::isnan(array[static_cast<std::size_t>(i)]));
  EXPECT_TRUE(holds<float>(convert<double>({nan, nan})));
}

}  // namespace
}  // namespace isolux
