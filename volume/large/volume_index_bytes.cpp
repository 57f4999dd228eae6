// The bytes of an index's file (volume/large/volume_index.h), and back.
#include <algorithm>
#include <cstring>
#include <string>
#include <utility>

#include <glm/vector_relational.hpp>

#include "volume/large/volume_index.h"

namespace isolux::volume {

namespace {

constexpr std::size_t kMostErrorText = 1024;  // of a damaged part

// Either direction of the same list of members.
struct Writer {
  static constexpr bool reads = false;
  const std::function<void(const void*, std::size_t)>& put;
  template <class T>
  bool number(T& value) {
    put(&value, sizeof value);
    return true;
  }
  template <class T>
  bool array(std::vector<T>& values, std::size_t) {
    std::uint64_t count = values.size();
    put(&count, sizeof count);
    if (!values.empty()) put(values.data(), values.size() * sizeof(T));
    return true;
  }
  bool text(std::string& value) {
    std::uint64_t length = std::min(value.size(), kMostErrorText);
    put(&length, sizeof length);
    put(value.data(), length);
    return true;
  }
};

struct Reader {
  static constexpr bool reads = true;
  std::span<const std::byte> bytes;
  base::Hasher& sum;
  bool take(void* to, std::size_t count) {
    if (bytes.size() < count) return false;
    if (count == 0) return true;
    std::memcpy(to, bytes.data(), count);
    sum.addWords(to, count);
    bytes = bytes.subspan(count);
    return true;
  }
  template <class T>
  bool number(T& value) {
    return take(&value, sizeof value);
  }
  template <class T>
  bool array(std::vector<T>& values, std::size_t expected) {
    std::uint64_t count = 0;
    if (!number(count) || count != expected) return false;
    values.resize(expected);
    return take(values.data(), expected * sizeof(T));
  }
  bool text(std::string& value) {
    std::uint64_t length = 0;
    if (!number(length) || length > kMostErrorText) return false;
    value.resize(length);
    return take(value.data(), length);
  }
};

}  // namespace

template <class Io>
bool VolumeIndex::transferDamaged(Io& io) {
  std::uint64_t count = damaged_.size();
  if (!io.number(count) || count > kMostDamagedParts) return false;
  damaged_.resize(count);
  for (DamagedPart& part : damaged_) {
    if (!io.number(part.low) || !io.number(part.size) || !io.text(part.error)) return false;
    const bool isInside = glm::all(glm::greaterThanEqual(part.low, glm::ivec3(0))) &&
                          glm::all(glm::greaterThan(part.size, glm::ivec3(0))) &&
                          glm::all(glm::lessThan(part.low, dims())) &&
                          glm::all(glm::lessThanEqual(part.size, dims() - part.low));
    if (!isInside) return false;
  }
  return true;
}

template <class Io>
bool VolumeIndex::transfer(Io& io) {
  // Version 2 has a list of damaged parts.
  std::uint32_t version = damaged_.empty() ? 1 : 2, type = static_cast<std::uint32_t>(facts_.storedType);
  glm::ivec3 size = dims();
  std::int32_t layers = layersOfUnit_, time = part_.time, channel = part_.channel;
  std::uint8_t finished = isFinished_ ? 1 : 0;
  std::uint64_t countSize = counts_.size();
  if (!io.number(version) || !io.number(type) || !io.number(size) || !io.number(layers) || !io.number(time) ||
      !io.number(channel) || !io.number(finished) || !io.number(typicalStep_) ||
      !io.number(typicalStoredStep_) || !io.number(countSize))
    return false;
  const bool same = (version == 1 || version == 2) && type == static_cast<std::uint32_t>(facts_.storedType) &&
                    size == dims() && layers == layersOfUnit_ && time == part_.time &&
                    channel == part_.channel;
  const bool countsFit = isWhole_ ? countSize == counts_.size() : countSize <= std::size_t{kHistogramBins};
  if (!same || !countsFit) return false;
  std::vector<float> minima(blocks_->count()), maxima(blocks_->count());
  for (std::size_t i = 0; i < minima.size(); ++i) {
    minima[i] = blocks_->minimum(i);
    maxima[i] = blocks_->maximum(i);
  }
  const std::size_t count = units();
  if (!io.array(done_, count) || !io.array(least_, count) || !io.array(most_, count) ||
      !io.array(missing_, count) || !io.array(hashes_, hashes_.size()) ||
      !io.array(minima, blocks_->count()) || !io.array(maxima, blocks_->count()) ||
      !io.array(counts_, countSize) || (version == 2 && !transferDamaged(io)))
    return false;
  if constexpr (Io::reads)  // who writes shares its blocks with others
    for (std::size_t i = 0; i < minima.size(); ++i) blocks_->set(i, minima[i], maxima[i]);
  isFinished_ = finished != 0;
  // Nothing of a file is believed that memory depends on.
  return std::ranges::all_of(done_, [](std::uint8_t d) { return d <= 1; });
}

void VolumeIndex::write(const std::function<void(const void*, std::size_t)>& put) const {
  VolumeIndex copy = *this;  // transfer() writes into what it reads
  Writer writer{put};
  copy.transfer(writer);
}

std::size_t VolumeIndex::mostBytes() const {
  std::size_t sum = 0;
  write([&](const void*, std::size_t count) { sum += count; });
  constexpr std::size_t damaged =
      sizeof(std::uint64_t) +
      kMostDamagedParts * (2 * sizeof(glm::ivec3) + sizeof(std::uint64_t) + kMostErrorText);
  return sum + static_cast<std::size_t>(kHistogramBins) * sizeof(std::uint64_t) + damaged;
}

bool VolumeIndex::read(std::span<const std::byte> bytes, base::Hasher& sum) {
  VolumeIndex copy(facts_, part_);
  Reader reader{bytes, sum};
  if (!copy.transfer(reader) || !reader.bytes.empty()) return false;
  *this = std::move(copy);
  return true;
}

}  // namespace isolux::volume
