#include "volume/cast/cell_bits_on_demand.h"

namespace isolux::volume::casting {

CellBitsOnDemand::CellBitsOnDemand(std::size_t blocks, std::size_t active)
    : held_(base::machineMemory().reserve(blocks * sizeof(std::uint32_t) + active * sizeof(Words),
                                          "the cells that the isosurface may cross",
                                          "hit.field=trilinear or --executor gpu needs less")),
      places_(blocks) {}

const CellBitsOnDemand::Words* CellBitsOnDemand::find(std::size_t block) const {
  const std::uint32_t place = places_[block].load(std::memory_order_acquire);
  return place == 0 ? nullptr : &words_[place - 1];
}

const CellBitsOnDemand::Words* CellBitsOnDemand::add(std::size_t block, const Words& words) {
  const auto added = words_.push_back(words);
  places_[block].store(static_cast<std::uint32_t>(added - words_.begin()) + 1, std::memory_order_release);
  return &*added;
}

}  // namespace isolux::volume::casting
