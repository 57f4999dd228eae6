#include "volume/read/hdf5/hdf5_layout.h"

#include <bit>
#include <limits>
#include <type_traits>

#include "volume/read/process/wire.h"

namespace isolux::volume {

namespace {

constexpr std::uint64_t kLongestHdf5Axis = std::uint64_t{1} << 40;
constexpr std::uint64_t kMostHdf5Filters = 32, kMostFilterValues = 256;
constexpr std::uint64_t kMostSlices = 1000000;
constexpr std::size_t kMostHdf5Datasets = 10000, kMostHdf5Files = 1000;

// Passes what a layout holds to a WireWriter or a WireReader.

constexpr auto passAxes = [](auto& wire, auto& axes) {
  wire.passEach(axes, 1, kMostArrayAxes, [&](auto& entries) { wire.pass(entries, 1, kLongestHdf5Axis); });
};

constexpr auto passVector = [](auto& wire, auto& v) {
  for (int i = 0; i < 3; ++i) wire.pass(v[i]);
};

constexpr auto passReals = [](auto& wire, auto& numbers, std::uint64_t most) {
  wire.passEach(numbers, 0, most, [&](auto& number) { wire.pass(number); });
};

constexpr auto passAxis = [](auto& wire, auto& axis) {
  wire.pass(axis.name);
  wire.pass(axis.unit);
  bool hasStep = axis.step.has_value();
  double step = axis.step.value_or(0.0);
  wire.pass(hasStep, 0, 1);
  wire.pass(step);
  if constexpr (std::is_same_v<decltype(wire), WireReader&>)
    if (hasStep) axis.step = step;
  wire.pass(axis.first);
  wire.pass(axis.deviation);
  passVector(wire, axis.direction);
};

constexpr auto passStatements = [](auto& wire, auto& statements, std::uint64_t layoutAxes) {
  constexpr std::uint64_t mostMissing = 4096, mostWarnings = 10000;
  wire.passEach(statements.axes, 0, kMostArrayAxes, [&](auto& axis) { passAxis(wire, axis); });
  passVector(wire, statements.originMm);
  wire.pass(statements.anatomical, 0, 1);
  wire.passFinite(statements.slope);
  wire.passFinite(statements.intercept);
  wire.pass(statements.unit);
  passReals(wire, statements.missing.values, mostMissing);
  wire.pass(statements.missing.least);
  wire.pass(statements.missing.greatest);
  wire.pass(statements.slices.axes, 0, layoutAxes);
  passReals(wire, statements.slices.slopes, kMostSlices);
  passReals(wire, statements.slices.intercepts, kMostSlices);
  wire.pass(statements.warnings, mostWarnings);
};

constexpr auto passLayout = [](auto& wire, auto& layout) {
  constexpr std::uint64_t any32 = 0xffffffffu;
  wire.pass(layout.dataset);
  wire.pass(layout.others, kMostHdf5Datasets);
  wire.pass(layout.files, kMostHdf5Files);
  passAxes(wire, layout.dims);
  passAxes(wire, layout.chunk);
  wire.pass(layout.contiguous, 0, 1);
  wire.pass(layout.number.type, 0, static_cast<std::uint64_t>(VoxelType::float64));
  wire.pass(layout.number.half, 0, 1);
  wire.pass(layout.number.big, 0, 1);
  auto fill = std::bit_cast<std::uint64_t>(layout.fill);
  wire.pass(fill, 0, std::numeric_limits<std::uint64_t>::max());
  if constexpr (std::is_same_v<decltype(wire), WireReader&>)
    layout.fill = std::bit_cast<std::array<std::byte, 8>>(fill);
  wire.passEach(layout.filters, 0, kMostHdf5Filters, [&](auto& filter) {
    wire.pass(filter.id, 0, any32);
    wire.passEach(filter.values, 0, kMostFilterValues, [&](auto& value) { wire.pass(value, 0, any32); });
  });
  passStatements(wire, layout.statements, layout.dims.size());
};

void checkStatements(const ArrayStatements& statements, const Hdf5Layout& layout) {
  const SliceScaling& slices = statements.slices;
  std::uint64_t places = slices.slopes.empty() ? 0 : 1;
  for (std::uint64_t axis = 0; axis < slices.axes && places <= kMostSlices; ++axis)
    places *= layout.dims[static_cast<std::size_t>(axis)];
  if (!(statements.axes.empty() || statements.axes.size() == layout.dims.size()) ||
      slices.slopes.size() != places || slices.intercepts.size() != places)
    throwBadAnswer("statements do not fit the axes");
}

}  // namespace

std::uint64_t Hdf5Layout::chunkCount() const {
  std::uint64_t count = 1;
  for (std::size_t axis = 0; axis < dims.size(); ++axis) {
    const std::uint64_t along = (dims[axis] - 1) / chunk[axis] + 1;
    if (__builtin_mul_overflow(count, along, &count)) return ~std::uint64_t{0};
  }
  return count;
}

std::string encode(const Hdf5Layout& layout) {
  return messageBytes(layout, passLayout);
}

Hdf5Layout decodeHdf5Layout(std::string_view body) {
  const auto layout = messageOf<Hdf5Layout>(body, passLayout);
  checkStatements(layout.statements, layout);
  if (layout.chunk.size() != layout.dims.size())
    throwBadAnswer("chunks have not as many axes as the dataset");
  if (layout.number.half && layout.number.type != VoxelType::float32) throwBadAnswer("no such type");
  if (layout.contiguous && (layout.chunk != layout.dims || !layout.filters.empty()))
    throwBadAnswer("a contiguous dataset has chunks");
  if (layout.chunkCount() > kMostHdf5Chunks) throwBadAnswer("the dataset has more than 16777216 chunks");
  return layout;
}

std::uint64_t bulkBytes(const Hdf5Layout& announced) {
  return announced.chunkCount() * sizeof(Hdf5Chunk);
}

}  // namespace isolux::volume
