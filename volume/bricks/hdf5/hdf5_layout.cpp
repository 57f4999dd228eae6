#include "volume/bricks/hdf5/hdf5_layout.h"

#include <bit>
#include <cstring>

#include "volume/read/process/wire.h"

namespace isolux::volume {

namespace {

constexpr std::uint64_t kLongestHdf5Axis = std::uint64_t{1} << 40;
constexpr std::uint64_t kMostHdf5Filters = 32, kMostFilterValues = 256;
constexpr std::size_t kMostHdf5Datasets = 10000;

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
  wire.put(static_cast<std::uint64_t>(layout.elementSizeUm.size()));
  for (const double size : layout.elementSizeUm) wire.put(size);
  wire.put(std::string_view(layout.axisTags));
  wire.put(layout.labels);
  return wire.bytes();
}

Hdf5Layout decodeHdf5Layout(std::string_view body) {
  WireReader wire(body);
  Hdf5Layout layout;
  layout.dataset = wire.text();
  layout.others = wire.texts(kMostHdf5Datasets);
  layout.dims = takeAxes(wire);
  layout.chunk = takeAxes(wire);
  layout.contiguous = wire.number(0, 1) != 0;
  layout.number.type = static_cast<VoxelType>(wire.number(0, static_cast<std::uint64_t>(VoxelType::float64)));
  layout.number.half = wire.number(0, 1) != 0;
  layout.number.big = wire.number(0, 1) != 0;
  layout.fill = std::bit_cast<std::array<std::byte, 8>>(wire.number());
  layout.filters = takeFilters(wire);
  layout.elementSizeUm.resize(static_cast<std::size_t>(wire.number(0, kMostArrayAxes)));
  for (double& size : layout.elementSizeUm) size = wire.real();
  layout.axisTags = wire.text();
  layout.labels = wire.texts(kMostArrayAxes);
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
