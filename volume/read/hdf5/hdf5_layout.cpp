#include "volume/read/hdf5/hdf5_layout.h"

#include <bit>
#include <span>

#include "volume/read/process/wire.h"

namespace isolux::volume {

namespace {

constexpr std::uint64_t kLongestHdf5Axis = std::uint64_t{1} << 40;
constexpr std::uint64_t kMostHdf5Filters = 32, kMostFilterValues = 256;
constexpr std::size_t kMostHdf5Datasets = 10000, kMostHdf5Files = 1000;

void putNumbers(WireWriter& wire, const std::vector<std::uint64_t>& numbers) {
  wire.put(static_cast<std::uint64_t>(numbers.size()));
  for (const std::uint64_t number : numbers) wire.put(number);
}

std::vector<std::uint64_t> takeAxes(WireReader& wire) {
  std::vector<std::uint64_t> numbers(static_cast<std::size_t>(wire.number(1, kMostArrayAxes)));
  for (std::uint64_t& number : numbers) number = wire.number(1, kLongestHdf5Axis);
  return numbers;
}

std::vector<Hdf5Filter> takeFilters(WireReader& wire) {
  std::vector<Hdf5Filter> filters(static_cast<std::size_t>(wire.number(0, kMostHdf5Filters)));
  for (Hdf5Filter& filter : filters) {
    filter.id = static_cast<std::uint32_t>(wire.number(0, 0xffffffffu));
    filter.values.resize(static_cast<std::size_t>(wire.number(0, kMostFilterValues)));
    for (std::uint32_t& value : filter.values)
      value = static_cast<std::uint32_t>(wire.number(0, 0xffffffffu));
  }
  return filters;
}

void putReals(WireWriter& wire, std::span<const double> numbers) {
  wire.put(static_cast<std::uint64_t>(numbers.size()));
  for (const double number : numbers) wire.put(number);
}

std::vector<double> takeReals(WireReader& wire, std::uint64_t most) {
  std::vector<double> numbers(static_cast<std::size_t>(wire.number(0, most)));
  for (double& number : numbers) number = wire.real();
  return numbers;
}

void putVector(WireWriter& wire, const glm::dvec3& v) {
  for (int i = 0; i < 3; ++i) wire.put(v[i]);
}

glm::dvec3 takeVector(WireReader& wire) {
  glm::dvec3 v(0.0);
  for (int i = 0; i < 3; ++i) v[i] = wire.real();
  return v;
}

void putStatements(WireWriter& wire, const ArrayStatements& statements) {
  wire.put(static_cast<std::uint64_t>(statements.axes.size()));
  for (const AxisStatement& axis : statements.axes) {
    wire.put(std::string_view(axis.name));
    wire.put(std::string_view(axis.unit));
    wire.put(std::uint64_t{axis.step.has_value()});
    wire.put(axis.step.value_or(0.0));
    wire.put(axis.first);
    wire.put(axis.deviation);
    putVector(wire, axis.direction);
  }
  putVector(wire, statements.originMm);
  wire.put(std::uint64_t{statements.anatomical});
  wire.put(statements.slope);
  wire.put(statements.intercept);
  wire.put(std::string_view(statements.unit));
  putReals(wire, statements.missing.values);
  wire.put(statements.missing.least);
  wire.put(statements.missing.greatest);
  wire.put(statements.slices.axes);
  putReals(wire, statements.slices.slopes);
  putReals(wire, statements.slices.intercepts);
  wire.put(statements.warnings);
}

AxisStatement takeAxis(WireReader& wire) {
  AxisStatement axis;
  axis.name = wire.text();
  axis.unit = wire.text();
  const bool hasStep = wire.number(0, 1) != 0;
  if (const double step = wire.real(); hasStep) axis.step = step;
  axis.first = wire.real();
  axis.deviation = wire.real();
  axis.direction = takeVector(wire);
  return axis;
}

ArrayStatements takeStatements(WireReader& wire, const Hdf5Layout& layout) {
  constexpr std::uint64_t mostMissing = 4096, mostSlices = 1000000, mostWarnings = 10000;
  ArrayStatements statements;
  const std::uint64_t axes = wire.number(0, kMostArrayAxes);
  for (std::uint64_t i = 0; i < axes; ++i) statements.axes.push_back(takeAxis(wire));
  statements.originMm = takeVector(wire);
  statements.anatomical = wire.number(0, 1) != 0;
  statements.slope = wire.finite();
  statements.intercept = wire.finite();
  statements.unit = wire.text();
  statements.missing.values = takeReals(wire, mostMissing);
  statements.missing.least = wire.real();
  statements.missing.greatest = wire.real();
  SliceScaling& slices = statements.slices;
  slices.axes = wire.number(0, layout.dims.size());
  slices.slopes = takeReals(wire, mostSlices);
  slices.intercepts = takeReals(wire, mostSlices);
  statements.warnings = wire.texts(mostWarnings);
  std::uint64_t places = slices.slopes.empty() ? 0 : 1;
  for (std::uint64_t axis = 0; axis < slices.axes && places <= mostSlices; ++axis)
    places *= layout.dims[static_cast<std::size_t>(axis)];
  if (!(statements.axes.empty() || statements.axes.size() == layout.dims.size()) ||
      slices.slopes.size() != places || slices.intercepts.size() != places)
    throwBadAnswer("statements do not fit the axes");
  return statements;
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
  WireWriter wire;
  wire.put(std::string_view(layout.dataset));
  wire.put(layout.others);
  wire.put(layout.files);
  putNumbers(wire, layout.dims);
  putNumbers(wire, layout.chunk);
  wire.put(std::uint64_t{layout.contiguous});
  wire.put(static_cast<std::uint64_t>(layout.number.type));
  wire.put(std::uint64_t{layout.number.half});
  wire.put(std::uint64_t{layout.number.big});
  wire.put(std::bit_cast<std::uint64_t>(layout.fill));
  wire.put(static_cast<std::uint64_t>(layout.filters.size()));
  for (const Hdf5Filter& filter : layout.filters) {
    wire.put(std::uint64_t{filter.id});
    wire.put(static_cast<std::uint64_t>(filter.values.size()));
    for (const std::uint32_t value : filter.values) wire.put(std::uint64_t{value});
  }
  putStatements(wire, layout.statements);
  return wire.bytes();
}

Hdf5Layout decodeHdf5Layout(std::string_view body) {
  WireReader wire(body);
  Hdf5Layout layout;
  layout.dataset = wire.text();
  layout.others = wire.texts(kMostHdf5Datasets);
  layout.files = wire.texts(kMostHdf5Files);
  layout.dims = takeAxes(wire);
  layout.chunk = takeAxes(wire);
  layout.contiguous = wire.number(0, 1) != 0;
  layout.number.type = static_cast<VoxelType>(wire.number(0, static_cast<std::uint64_t>(VoxelType::float64)));
  layout.number.half = wire.number(0, 1) != 0;
  layout.number.big = wire.number(0, 1) != 0;
  layout.fill = std::bit_cast<std::array<std::byte, 8>>(wire.number());
  layout.filters = takeFilters(wire);
  layout.statements = takeStatements(wire, layout);
  wire.end();
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
