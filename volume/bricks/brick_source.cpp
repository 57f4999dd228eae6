#include "volume/bricks/brick_source.h"

#include <algorithm>
#include <condition_variable>
#include <cstring>
#include <list>
#include <map>
#include <mutex>
#include <optional>
#include <thread>
#include <unordered_map>

#include <glm/common.hpp>

#include "base/caught_error.h"
#include "base/destroy_in_background.h"
#include "base/memory_budget.h"
#include "volume/voxels/stored_type.h"

namespace isolux::volume {

namespace {

constexpr std::size_t kMostReaders = 8;
constexpr std::size_t kMostChunkBytes = std::size_t{16} << 20;  // larger ones are read in bricks

// How a level is cut into bricks: brick b holds voxels b * edge - before .. (b + 1) * edge - 1 + behind.
struct Cut {
  glm::ivec3 dims, edge;
  int before = 0, behind = 0;

  glm::ivec3 bricks() const { return glm::max((dims + edge - 1) / edge, glm::ivec3(1)); }
  glm::ivec3 low(glm::ivec3 brick) const { return glm::max(brick * edge - before, glm::ivec3(0)); }
  glm::ivec3 behindLast(glm::ivec3 brick) const { return glm::min((brick + 1) * edge + behind, dims); }
};

Cut cutOf(const ChunkedLevel& level, VoxelType type) {
  const glm::ivec3 dims = level.geometry.dims, chunk = glm::min(level.chunkDims, dims);
  const bool boxes = level.keepsBoxes() && glm::any(glm::greaterThan(chunk, glm::ivec3(1))) &&
                     Extent3{chunk}.count() * bytesOf(type) <= kMostChunkBytes;
  if (boxes) return {dims, chunk};
  return {dims, glm::ivec3(BrickSource::kRowBrick), BrickSource::kApron, BrickSource::kApron + 1};
}

struct Key {
  std::size_t level;
  std::size_t brick;
  bool operator==(const Key&) const = default;
};

struct KeyHash {
  std::size_t operator()(const Key& key) const { return key.brick * 31 + key.level; }
};

// A run of voxels on an axis that lies in one brick; coordinates may be beyond the border.
struct Run {
  int brick, from, behind;
};

// One brick where it holds all of it, else as the edges of bricks say.
std::vector<Run> runsOf(const Cut& cut, int axis, int first, int size) {
  const int n = cut.dims[axis], edge = cut.edge[axis];
  const int low = std::clamp(first, 0, n - 1), high = std::clamp(first + size - 1, 0, n - 1);
  const int middle = std::clamp(first + size / 2, 0, n - 1) / edge;
  if (low >= cut.low(glm::ivec3(middle))[axis] && high < cut.behindLast(glm::ivec3(middle))[axis])
    return {{middle, first, first + size}};
  std::vector<Run> runs;
  for (int at = first; at < first + size;) {
    const int brick = std::clamp(at, 0, n - 1) / edge;
    const int behind = brick == (n - 1) / edge ? first + size : std::min((brick + 1) * edge, first + size);
    runs.push_back({brick, at, behind});
    at = behind;
  }
  return runs;
}

// One line of a box out of a row of voxels; beyond the border the border voxel repeats.
template <class T>
void copyLine(const T* row, int rowLow, int n, Run run, T* out) {
  for (int x = run.from; x < std::min(run.behind, 0); ++x) *out++ = row[0 - rowLow];
  const int from = std::clamp(run.from, 0, n), behind = std::clamp(run.behind, 0, n);
  if (behind > from) out = std::copy(row + (from - rowLow), row + (behind - rowLow), out);
  for (int x = std::max(run.from, n); x < run.behind; ++x) *out++ = row[n - 1 - rowLow];
}

}  // namespace

struct BrickSource::State {
  // What reading a brick has come to; who waits for it shares it.
  struct Reading {
    bool ended = false;
    std::shared_ptr<const Brick> brick;
    std::optional<base::Error> error;
  };
  struct Entry {  // a brick that is in memory, or being read
    std::shared_ptr<const Reading> reading;
    std::list<Key>::iterator recent;  // in memory
  };
  struct Priority {
    Key key;
    std::weak_ptr<void> wanted;
  };

  std::shared_ptr<const ChunkedVolume> file;
  VolumePart part;
  std::size_t budget = 0;
  std::vector<Cut> cuts;  // of the levels
  base::MemoryBudget::Held held;

  mutable std::mutex mutex;
  std::condition_variable ended, requested;
  std::unordered_map<Key, Entry, KeyHash> entries;
  std::list<Key> recent;  // the most recently used first
  std::multimap<int, Priority, std::greater<>> wishes;
  std::vector<std::unique_ptr<base::BackgroundThread<State>>> threads;
  bool stopping = false;
  Reads reads;

  glm::ivec3 indexOf(Key key) const { return Extent3{cuts[key.level].bricks()}.at(key.brick); }
  Key keyOf(std::size_t level, glm::ivec3 index) const {
    return {level, Extent3{cuts[level].bricks()}.index(index)};
  }

  std::shared_ptr<const Brick> get(Key key);
  std::shared_ptr<const Reading> readNow(Key key, std::unique_lock<std::mutex>& lock);
  void keep(Key key, Entry& entry);
  void work();
};

// With the lock, which is let go while the file is read.
auto BrickSource::State::readNow(Key key, std::unique_lock<std::mutex>& lock)
    -> std::shared_ptr<const Reading> {
  const auto reading = std::make_shared<Reading>();
  entries[key].reading = reading;
  lock.unlock();
  const auto brick = std::make_shared<Brick>();
  std::size_t bytes = 0;
  const auto error = base::caughtError(file->facts().name, "read a brick", [&] {
    const Cut& cut = cuts[key.level];
    brick->low = cut.low(indexOf(key));
    brick->size = cut.behindLast(indexOf(key)) - brick->low;
    brick->voxels.resize(Extent3{brick->size}.count() * bytesOf(file->facts().storedType));
    bytes = file->read(part, key.level, brick->low, brick->size, brick->voxels);
  });
  lock.lock();
  *reading = {true, brick, error};
  if (error) {
    entries.erase(key);
  } else {
    reads.fileBytes += bytes;
    reads.brickBytes += brick->voxels.size();
    ++reads.bricks;
    keep(key, entries[key]);
  }
  ended.notify_all();
  return reading;
}

void BrickSource::State::keep(Key key, Entry& entry) {
  reads.keptBytes += entry.reading->brick->voxels.size();
  recent.push_front(key);
  entry.recent = recent.begin();
  while (reads.keptBytes > budget && recent.size() > 1) {
    const auto oldest = entries.find(recent.back());
    reads.keptBytes -= oldest->second.reading->brick->voxels.size();
    entries.erase(oldest);
    recent.pop_back();
  }
}

std::shared_ptr<const BrickSource::Brick> BrickSource::State::get(Key key) {
  std::unique_lock lock(mutex);
  const auto found = entries.find(key);
  if (found != entries.end() && found->second.reading->ended)
    recent.splice(recent.begin(), recent, found->second.recent);
  const auto reading = found != entries.end() ? found->second.reading : readNow(key, lock);
  ended.wait(lock, [&] { return reading->ended; });
  if (reading->error) throw base::Error(*reading->error);
  return reading->brick;
}

void BrickSource::State::work() {
  std::unique_lock lock(mutex);
  for (;;) {
    requested.wait(lock, [&] { return stopping || !wishes.empty(); });
    if (stopping) return;
    const Priority asked = wishes.begin()->second;
    wishes.erase(wishes.begin());
    if (asked.wanted.expired()) continue;
    if (!entries.contains(asked.key)) readNow(asked.key, lock);
  }
}

BrickSource::BrickSource(std::shared_ptr<const ChunkedVolume> file, VolumePart part, std::size_t budgetBytes)
    : state_(std::make_shared<State>()) {
  state_->file = std::move(file);
  state_->part = part;
  state_->budget = budgetBytes;
  std::size_t whole = 0;
  for (const ChunkedLevel& level : facts().levels) {
    state_->cuts.push_back(cutOf(level, facts().storedType));
    whole += level.geometry.voxelCount() * bytesOf(facts().storedType);
  }
  state_->held = base::machineMemory().reserve(std::min(budgetBytes, 2 * whole), "parts of the volume",
                                               "a lower memory.ram_budget_mb needs less");
}

BrickSource::~BrickSource() {
  const std::lock_guard lock(state_->mutex);
  state_->stopping = true;
  state_->wishes.clear();
  state_->requested.notify_all();
  // Its threads hold the state, and the state its threads: they are let go here, and end elsewhere.
  base::destroyInBackground(std::move(state_->threads));
  state_->threads.clear();
}

const ChunkedVolume& BrickSource::file() const {
  return *state_->file;
}

const ChunkedFacts& BrickSource::facts() const {
  return state_->file->facts();
}

VolumePart BrickSource::part() const {
  return state_->part;
}

glm::ivec3 BrickSource::brickOf(std::size_t level, glm::ivec3 voxel) const {
  return voxel / state_->cuts[level].edge;
}

std::shared_ptr<const BrickSource::Brick> BrickSource::brick(std::size_t level, glm::ivec3 index) {
  return state_->get(state_->keyOf(level, index));
}

bool BrickSource::has(std::size_t level, glm::ivec3 index) const {
  const std::lock_guard lock(state_->mutex);
  const auto found = state_->entries.find(state_->keyOf(level, index));
  return found != state_->entries.end() && found->second.reading->ended;
}

BrickSource::Request BrickSource::request(std::size_t level, glm::ivec3 index, int priority) {
  const Key key = state_->keyOf(level, index);
  const std::lock_guard lock(state_->mutex);
  if (const auto found = state_->entries.find(key);
      found != state_->entries.end() && found->second.reading->ended)
    return {};
  const auto wanted = std::make_shared<int>(0);
  state_->wishes.emplace(priority, State::Priority{key, wanted});
  if (state_->threads.empty()) {
    const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
    for (std::size_t i = 0; i < std::min(cores, kMostReaders); ++i)
      state_->threads.push_back(std::make_unique<base::BackgroundThread<State>>(
          state_, [here = std::this_thread::get_id()](State& state) {
            // Where the system refuses a thread nothing is read ahead.
            if (std::this_thread::get_id() != here) state.work();
          }));
  }
  state_->requested.notify_one();
  return wanted;
}

void BrickSource::copyBox(std::size_t level, glm::ivec3 first, glm::ivec3 size, std::span<std::byte> voxels,
                          std::vector<DamagedPart>* unknown) {
  const Cut& cut = state_->cuts[level];
  const auto runsX = runsOf(cut, 0, first.x, size.x), runsY = runsOf(cut, 1, first.y, size.y),
             runsZ = runsOf(cut, 2, first.z, size.z);
  const auto copy = [&](const Brick& from, Run x, Run y, Run z) {
    withStoredType(facts().storedType, [&](auto zero) {
      using T = decltype(zero);
      const T* const stored = reinterpret_cast<const T*>(from.voxels.data());
      T* const out = reinterpret_cast<T*>(voxels.data());
      for (int k = z.from; k < z.behind; ++k)
        for (int j = y.from; j < y.behind; ++j) {
          const int inY = std::clamp(j, 0, cut.dims.y - 1), inZ = std::clamp(k, 0, cut.dims.z - 1);
          const std::size_t row = Extent3{from.size}.index(0, inY - from.low.y, inZ - from.low.z);
          const std::size_t to = Extent3{size}.index(glm::ivec3(x.from, j, k) - first);
          copyLine(stored + row, from.low.x, cut.dims.x, x, out + to);
        }
    });
  };
  if (unknown) std::ranges::fill(voxels, std::byte{0});
  for (const Run& z : runsZ)
    for (const Run& y : runsY)
      for (const Run& x : runsX) {
        std::shared_ptr<const Brick> from;
        try {
          from = brick(level, {x.brick, y.brick, z.brick});
        } catch (const base::Error& error) {
          if (!unknown || error.kind() != base::ErrorKind::input) throw;
          unknown->push_back({{x.from, y.from, z.from},
                              {x.behind - x.from, y.behind - y.from, z.behind - z.from},
                              error.what()});
          continue;
        }
        copy(*from, x, y, z);
      }
}

std::vector<BrickSource::Request> BrickSource::requestBox(std::size_t level, glm::ivec3 first,
                                                          glm::ivec3 size, int priority) {
  const Cut& cut = state_->cuts[level];
  std::vector<Request> requests;
  for (const Run& z : runsOf(cut, 2, first.z, size.z))
    for (const Run& y : runsOf(cut, 1, first.y, size.y))
      for (const Run& x : runsOf(cut, 0, first.x, size.x))
        requests.push_back(request(level, {x.brick, y.brick, z.brick}, priority));
  return requests;
}

double BrickSource::stored(glm::ivec3 voxel) {
  const std::shared_ptr<const Brick> from = brick(0, brickOf(0, voxel));
  const std::size_t i = Extent3{from->size}.index(voxel - from->low);
  return withStoredType(facts().storedType, [&](auto zero) {
    decltype(zero) value;
    std::memcpy(&value, from->voxels.data() + i * sizeof value, sizeof value);
    return static_cast<double>(value);
  });
}

BrickSource::Reads BrickSource::reads() const {
  const std::lock_guard lock(state_->mutex);
  return state_->reads;
}

std::size_t BrickSource::budgetBytes() const {
  return state_->budget;
}

}  // namespace isolux::volume
