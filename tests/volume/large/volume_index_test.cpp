// The index of a file: what is made of the same volume in memory, however it was come by.
#include "volume/large/volume_index.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include "base/error.h"
#include "base/hash.h"
#include "tests/support/test_data.h"
#include "tests/support/volumes.h"
#include "tests/support/zarr_folder.h"
#include "tests/volume/bricks/grid_as_file.h"
#include "volume/bricks/brick_source.h"
#include "volume/bricks/slice_reader.h"
#include "volume/large/index_file.h"
#include "volume/prepared/prepared_volume.h"
#include "volume/read/volume_file.h"
#include "volume/write/writer.h"

namespace isolux::test {
namespace {

namespace fs = std::filesystem;

void expectSameBlocks(const volume::MinMaxBlocks& a, const volume::MinMaxBlocks& b) {
  ASSERT_EQ(a.dims(), b.dims());
  std::size_t differing = 0;
  for (std::size_t i = 0; i < a.count(); ++i)
    if (a.minimum(i) != b.minimum(i) || a.maximum(i) != b.maximum(i)) ++differing;
  EXPECT_EQ(differing, 0u) << "of " << a.count();
}

void expectSameFacts(const scene::VolumeFacts& a, const scene::VolumeFacts& b) {
  EXPECT_EQ(a.minimum, b.minimum);
  EXPECT_EQ(a.maximum, b.maximum);
  EXPECT_EQ(a.suggestedIsovalue, b.suggestedIsovalue);
  EXPECT_EQ(a.suggestedIsovalues, b.suggestedIsovalues);
  EXPECT_EQ(a.typicalStep, b.typicalStep);
  EXPECT_EQ(a.boundsMinMm, b.boundsMinMm);
  EXPECT_EQ(a.boundsMaxMm, b.boundsMaxMm);
  EXPECT_EQ(a.spacingMm, b.spacingMm);
  EXPECT_EQ(a.axes, b.axes);
}

// Loaded from the file, in parts and whole.
void expectSameVolume(const scene::Source& source) {
  base::Progress progress;
  scene::HostSettings host;
  host.voxels = scene::VoxelPlace::file;
  const auto whole = volume::loadVolume(source, progress);
  for (const char* from : {"made", "read again"}) {
    SCOPED_TRACE(from);
    const auto parts = volume::loadVolume(source, host, progress);
    EXPECT_FALSE(parts->grid().isWhole());
    EXPECT_EQ(parts->volume.name, whole->volume.name);
    EXPECT_EQ(parts->volume.warnings, whole->volume.warnings);
    EXPECT_EQ(parts->grid().hash(), whole->grid().hash());
    EXPECT_EQ(parts->grid().missingCount(), whole->grid().missingCount());
    EXPECT_EQ(parts->grid().storedType(), whole->grid().storedType());
    EXPECT_EQ(parts->grid().storedMinimum(), whole->grid().storedMinimum());
    EXPECT_EQ(parts->grid().storedMaximum(), whole->grid().storedMaximum());
    EXPECT_EQ(parts->histogram.counts, whole->histogram.counts);
    EXPECT_EQ(parts->histogram.minimum, whole->histogram.minimum);
    EXPECT_EQ(parts->histogram.maximum, whole->histogram.maximum);
    EXPECT_EQ(parts->histogram.peaks, whole->histogram.peaks);
    expectSameBlocks(*parts->blocks, *whole->blocks);
    expectSameFacts(parts->facts, whole->facts);
    EXPECT_THROW(parts->grid().voxels(), base::Error);
    const glm::ivec3 at = (whole->grid().dims() - 1) / glm::ivec3(2, 3, 4);
    const double there = whole->grid().value(at.x, at.y, at.z), read = parts->grid().value(at.x, at.y, at.z);
    EXPECT_TRUE(there == read || (std::isnan(there) && std::isnan(read)));
  }
}

class Indexes : public testing::Test {
 protected:
  std::shared_ptr<const volume::ChunkedVolume> write(const volume::Grid& grid, const char* name = "v.nrrd") {
    file_ = folder_ / name;
    writeVolume(grid, file_);
    return volume::openVolume(file_.string(), {}, progress_).parts;
  }
  volume::IndexFile indexFile() const { return volume::IndexFile(file_.string(), {}); }
  scene::Source source() const {
    scene::Source source;
    source.path = file_.string();
    return source;
  }
  fs::path folder_ = temporaryFolder(), file_;
  base::Progress progress_;
};

TEST_F(Indexes, EqualWhatIsMadeOfPhantomsInMemory) {
  for (const char* name : {"head", "ball", "gyroid", "noise"}) {
    SCOPED_TRACE(name);
    write(phantomGrid(name, 61));
    expectSameVolume(source());
    EXPECT_TRUE(fs::exists(folder_ / "v.nrrd.index"));
  }
}

TEST_F(Indexes, EqualOfEveryTypeWithMissingVoxels) {
  const glm::ivec3 dims(37, 20, 31);
  const std::size_t count = unitGeometry(dims).voxelCount();
  const auto raw = [&]<class T>(T, const std::string& type) {
    SCOPED_TRACE(type);
    std::vector<T> voxels(count);
    for (std::size_t i = 0; i < count; ++i)
      voxels[i] =
          static_cast<T>(100.0 * std::sin(0.01 * static_cast<double>(i)) + (i % 7 == 0 ? 20.0 : 27.0));
    if constexpr (std::is_same_v<T, float>)
      for (std::size_t i = 0; i < count; i += 11) voxels[i] = i % 2 ? NAN : -INFINITY;
    file_ = folder_ / ("v-" + type + ".raw");
    std::ofstream(file_, std::ios::binary)
        .write(reinterpret_cast<const char*>(voxels.data()), static_cast<std::streamsize>(count * sizeof(T)));
    scene::Source source = this->source();
    source.raw = "37x20x31 " + type + " spacing 0.5,1,2";
    expectSameVolume(source);
  };
  raw(std::int8_t{}, "int8");
  raw(std::uint8_t{}, "uint8");
  raw(std::int16_t{}, "int16");
  raw(std::uint16_t{}, "uint16");
  raw(float{}, "float32");
}

TEST_F(Indexes, ThinVolumesHaveNoBlocks) {
  for (const glm::ivec3& dims : {glm::ivec3(9, 9, 1), glm::ivec3(1, 40, 9), glm::ivec3(10, 17, 9)}) {
    write(phantomGrid("plane", dims));
    expectSameVolume(source());
  }
}

// Units of more than a slab, pieces of the hash across their borders: parts, in any order, are the whole.
TEST_F(Indexes, PartsJoinToTheIndexMadeAtOnce) {
  const auto file = write(phantomGrid("ball", glm::ivec3(300, 301, 120)));
  std::optional<volume::VolumeIndex> once, part, joined;
  indexFile().make(*file, {}, once, progress_);
  ASSERT_GT(once->units(), 3u);
  fs::remove(folder_ / "v.nrrd.index");
  for (const int i : {3, 1}) indexFile().make(*file, {i, 3}, part, progress_);
  EXPECT_FALSE(indexFile().find(*file));
  indexFile().make(*file, {}, joined, progress_);
  EXPECT_LT(joined->bytesRead(), once->bytesRead() * 3 / 4);  // a third, and the histogram's pass
  EXPECT_EQ(joined->voxelFacts(1.0, 0.0).hash, once->voxelFacts(1.0, 0.0).hash);
  expectSameBlocks(*joined->blocks(), *once->blocks());
  expectSameVolume(source());
  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(folder_))
    files += entry.path().filename().string().find("part") != std::string::npos;
  EXPECT_EQ(files, 0u);  // parts are gone
}

// However thin the units are beside the chunks.
TEST_F(Indexes, EachChunkIsUnpackedOnce) {
  const glm::ivec3 dims(300, 301, 120);
  const volume::Grid grid = phantomGrid("ball", dims);
  const volume::GridGeometry geometry = grid.geometry();
  const GridAsFile rows(grid, {dims.x, 1, 1});
  volume::VolumeIndex whole(rows.facts(), {});
  whole.scan(rows, {}, progress_, [] {});
  for (const glm::ivec3& chunk : {glm::ivec3(64, 64, 50), glm::ivec3(300, 301, 64), glm::ivec3(100, 301, 120),
                                  glm::ivec3(300, 50, 1), glm::ivec3(7, 300, 33)}) {
    SCOPED_TRACE(testing::Message() << chunk.x << "x" << chunk.y << "x" << chunk.z);
    const GridAsFile file(grid, chunk);
    volume::VolumeIndex index(file.facts(), {});
    ASSERT_GT(index.units(), 3u);
    index.scan(file, {}, progress_, [] {});
    const glm::ivec3 chunks = (dims + chunk - 1) / chunk;
    EXPECT_LE(file.reads, chunks.x * chunks.y * chunks.z);  // thin ones several at a time
    EXPECT_EQ(file.readsWithin, 0);
    EXPECT_EQ(file.voxelsRead, geometry.voxelCount());
    EXPECT_EQ(index.voxelFacts(1.0, 0.0).hash, whole.voxelFacts(1.0, 0.0).hash);
    expectSameBlocks(*index.blocks(), *whole.blocks());
  }
}

// Where a layer of chunks is more than a quarter of what is left.
TEST_F(Indexes, LayersOfChunksAreReadInPartsWhereMemoryIsShort) {
  const glm::ivec3 dims(300, 301, 120), chunk(64, 64, 100);
  const volume::Grid grid = phantomGrid("ball", dims);
  const GridAsFile file(grid, chunk);
  const std::size_t slice = 300 * 301 * sizeof(float), limit = base::machineMemory().limit();
  base::machineMemory().setLimit(base::machineMemory().held() + 100 * slice);
  {
    volume::SliceReader reader(file, {}, 30, [](volume::DamagedPart&&) { FAIL(); });
    EXPECT_LE(base::machineMemory().left(), 60 * slice);
    EXPECT_GE(base::machineMemory().left(), 40 * slice);
    for (int z = 0; z < dims.z; z += 10) {
      const int behind = std::min(z + 13, dims.z);
      const std::span<const float> slices = reader.slices<float>(z, behind, progress_);
      ASSERT_EQ(slices.size() * sizeof(float), static_cast<std::size_t>(behind - z) * slice);
      std::size_t differing = 0, i = 0;
      for (int k = z; k < behind; ++k)
        for (int j = 0; j < dims.y; ++j)
          for (int x = 0; x < dims.x; ++x, ++i)
            differing += static_cast<double>(slices[i]) != grid.stored(x, j, k);
      ASSERT_EQ(differing, 0u) << z;
    }
    EXPECT_EQ(reader.bytesRead(), grid.geometry().voxelCount() * sizeof(float));
  }
  base::machineMemory().setLimit(limit);
  EXPECT_EQ(file.reads, 5 * 5 * 5);  // a layer of 100 slices in four parts, the rest of the volume in one
}

// Chunks that cannot be read: blocks that hold any of their voxels may hold anything, all others are as they
// were, and their voxels count nowhere.
TEST_F(Indexes, GoAroundWhatCannotBeRead) {
  const glm::ivec3 dims(70, 61, 80);
  const volume::Grid floats = phantomGrid("ball", dims);
  std::vector<std::int16_t> rounded(floats.geometry().voxelCount());
  for (std::size_t i = 0; i < rounded.size(); ++i)
    rounded[i] = static_cast<std::int16_t>(std::get<std::vector<float>>(floats.voxels())[i] + 200.0f);
  const volume::Grid grids[] = {volume::Grid(floats), volume::Grid(unitGeometry(dims), std::move(rounded))};
  for (const volume::Grid& grid : grids)
    for (const glm::ivec3& chunk : {glm::ivec3(16, 20, 24), glm::ivec3(70, 61, 1)}) {
      SCOPED_TRACE(std::string(nameOf(grid.storedType())) + " " + std::to_string(chunk.x));
      GridAsFile file(grid, chunk);
      volume::VolumeIndex whole(file.facts(), {}), index(file.facts(), {});
      whole.scan(file, {}, progress_, [] {});
      whole.finish(file, progress_);
      file.damaged = chunk.z == 1 ? std::vector{glm::ivec3(0, 0, 17)}
                                  : std::vector{glm::ivec3(1, 2, 0), glm::ivec3(4, 0, 3)};
      index.scan(file, {}, progress_, [] {});
      index.finish(file, progress_);
      ASSERT_EQ(index.damaged().size(), file.damaged.size());
      std::size_t lost = 0;
      for (const volume::DamagedPart& part : index.damaged()) {
        EXPECT_THAT(part.error, testing::HasSubstr("is cut off"));
        EXPECT_TRUE(std::any_of(file.damaged.begin(), file.damaged.end(), [&](glm::ivec3 one) {
          return part.low == one * chunk && part.size == glm::min(chunk, dims - part.low);
        }));
        lost += static_cast<std::size_t>(part.size.x * part.size.y * part.size.z);
      }
      std::size_t open = 0, others = 0;
      const glm::ivec3 blocks = index.blocks()->dims();
      for (int z = 0; z < blocks.z; ++z)
        for (int y = 0; y < blocks.y; ++y)
          for (int x = 0; x < blocks.x; ++x) {
            const std::size_t i = index.blocks()->index({x, y, z});
            const glm::ivec3 low = 8 * glm::ivec3(x, y, z), high = low + 8;
            const bool holds = std::any_of(index.damaged().begin(), index.damaged().end(),
                                           [&](const volume::DamagedPart& part) {
                                             return glm::all(glm::lessThanEqual(part.low, high)) &&
                                                    glm::all(glm::lessThan(low, part.low + part.size));
                                           });
            if (holds) {
              open += index.blocks()->minimum(i) == std::numeric_limits<float>::lowest() &&
                      index.blocks()->maximum(i) == std::numeric_limits<float>::max();
              ++others;
            } else {
              EXPECT_EQ(index.blocks()->minimum(i), whole.blocks()->minimum(i));
              EXPECT_EQ(index.blocks()->maximum(i), whole.blocks()->maximum(i));
            }
          }
      EXPECT_EQ(open, others);
      EXPECT_GT(open, 0u);
      const volume::Histogram found = index.histogram(grid);
      std::uint64_t counted = 0;
      for (const std::uint64_t count : found.counts) counted += count;
      EXPECT_EQ(counted, grid.geometry().voxelCount() - lost);
      const volume::VoxelFacts facts = index.voxelFacts(1.0, 0.0);
      EXPECT_EQ(facts.missing, 0u);
      EXPECT_GE(facts.storedMinimum, grid.storedMinimum());  // not of zeros in the place of what is unknown
      EXPECT_LE(facts.storedMaximum, grid.storedMaximum());
      EXPECT_NE(facts.hash, whole.voxelFacts(1.0, 0.0).hash);
      // Written and read, and joined of two parts.
      std::vector<std::byte> bytes;
      index.write([&](const void* from, std::size_t count) {
        const auto* first = static_cast<const std::byte*>(from);
        bytes.insert(bytes.end(), first, first + count);
      });
      EXPECT_LE(bytes.size(), index.mostBytes());
      volume::VolumeIndex again(file.facts(), {});
      base::Hasher sum;
      ASSERT_TRUE(again.read(bytes, sum));
      EXPECT_EQ(again.damaged(), index.damaged());
      EXPECT_FALSE(volume::isRepaired(file, {}, again.damaged()));
      file.damaged.pop_back();
      EXPECT_TRUE(volume::isRepaired(file, {}, again.damaged()));
    }
}

TEST_F(Indexes, OfAFileOfWhichNothingCanBeReadAreRefused) {
  GridAsFile file(phantomGrid("ball", 40), glm::ivec3(20));
  file.fails = true;
  volume::VolumeIndex index(file.facts(), {});
  index.scan(file, {}, progress_, [] {});
  EXPECT_THROW(index.finish(file, progress_), base::Error);
  GridAsFile rows(phantomGrid("ball", glm::ivec3(2, 2, 5000)), glm::ivec3(2, 2, 1));
  rows.fails = true;
  volume::VolumeIndex many(rows.facts(), {});
  EXPECT_THROW(many.scan(rows, {}, progress_, [] {}), base::Error);
}

// A list that points out of the volume is no list.
TEST_F(Indexes, ADamagedListOfDamageCountsAsNone) {
  GridAsFile file(phantomGrid("ball", 40), glm::ivec3(20));
  file.damaged = {glm::ivec3(1, 1, 1)};
  volume::VolumeIndex index(file.facts(), {});
  index.scan(file, {}, progress_, [] {});
  index.finish(file, progress_);
  std::vector<std::byte> bytes;
  index.write([&](const void* from, std::size_t count) {
    const auto* first = static_cast<const std::byte*>(from);
    bytes.insert(bytes.end(), first, first + count);
  });
  const std::size_t text = index.damaged()[0].error.size(),
                    box = bytes.size() - text - sizeof(std::uint64_t) - 24;
  const auto isRead = [&](std::size_t at, std::int32_t number) {
    std::vector<std::byte> broken = bytes;
    std::memcpy(broken.data() + at, &number, sizeof number);
    base::Hasher sum;
    return volume::VolumeIndex(file.facts(), {}).read(broken, sum);
  };
  EXPECT_TRUE(isRead(box, 20));
  EXPECT_FALSE(isRead(box, 21));
  EXPECT_FALSE(isRead(box, -1));
  EXPECT_FALSE(isRead(box + 12, 0));
  EXPECT_FALSE(isRead(box + 12, std::numeric_limits<std::int32_t>::max()));
}

// A reader that stops after some parts of slabs.
class StopsEarly final : public volume::ChunkedVolume {
 public:
  StopsEarly(std::shared_ptr<const volume::ChunkedVolume> file, int reads, base::Progress& progress)
      : file_(std::move(file)), left_(reads), progress_(progress) {}
  const volume::ChunkedFacts& facts() const override { return file_->facts(); }
  std::size_t read(volume::VolumePart part, std::size_t level, glm::ivec3 low, glm::ivec3 size,
                   std::span<std::byte> voxels) const override {
    if (left_-- == 0) progress_.requestStop();
    return file_->read(part, level, low, size, voxels);
  }

 private:
  std::shared_ptr<const volume::ChunkedVolume> file_;
  mutable std::atomic<int> left_;
  base::Progress& progress_;
};

TEST_F(Indexes, WhatWasDoneBeforeAnInterruptIsNotDoneAgain) {
  const auto file = write(phantomGrid("ball", glm::ivec3(300, 301, 120)));
  base::Progress stopped;
  std::optional<volume::VolumeIndex> index;
  EXPECT_THROW(indexFile().make(StopsEarly(file, 7, stopped), {}, index, stopped), base::Error);
  ASSERT_TRUE(fs::exists(folder_ / "v.nrrd.index.part-1-of-1"));
  indexFile().make(*file, {}, index, progress_);
  std::optional<volume::VolumeIndex> once;
  fs::remove(folder_ / "v.nrrd.index");
  indexFile().make(*file, {}, once, progress_);
  EXPECT_LT(index->bytesRead(), once->bytesRead());
  EXPECT_EQ(index->voxelFacts(1.0, 0.0).hash, once->voxelFacts(1.0, 0.0).hash);
}

TEST_F(Indexes, OfAnotherFileCutOffOrDamagedCountAsNone) {
  auto file = write(phantomGrid("ball", 40));
  std::optional<volume::VolumeIndex> index;
  const fs::path kept = indexFile().make(*file, {}, index, progress_);
  ASSERT_TRUE(indexFile().find(*file));
  const auto bytes = fs::file_size(kept);
  std::fstream(kept, std::ios::in | std::ios::out | std::ios::binary)
      .seekp(static_cast<std::streamoff>(bytes / 2))
      .put('\x55')
      .put('\xaa');
  EXPECT_FALSE(indexFile().find(*file));
  index.reset();
  indexFile().make(*file, {}, index, progress_);
  fs::resize_file(kept, bytes - 20);
  EXPECT_FALSE(indexFile().find(*file));
  indexFile().make(*file, {}, index, progress_);
  fs::last_write_time(file_, fs::last_write_time(file_) + std::chrono::seconds(5));
  EXPECT_FALSE(indexFile().find(*file));
}

// More chunks than any list of names that a file should hold.
TEST_F(Indexes, OfAStoreOfManyFilesSeesTheChangeOfAnyOfThem) {
  constexpr int kChunks = 17;
  file_ = folder_ / "many.zarr";
  writeZarr(file_, glm::ivec3(2 * kChunks), glm::ivec3(2),
            std::vector<std::uint8_t>(8 * kChunks * kChunks * kChunks, 10));
  const auto file = volume::openSource(source(), progress_).parts;
  ASSERT_TRUE(file);
  std::optional<volume::VolumeIndex> index;
  indexFile().make(*file, {}, index, progress_);
  ASSERT_TRUE(indexFile().find(*file));
  for (int i = 0; i < kChunks; ++i) {
    const fs::path chunk = file_ / chunkName({i, (7 * i) % kChunks, (11 * i + 3) % kChunks});
    const auto before = fs::last_write_time(chunk);
    fs::last_write_time(chunk, before + std::chrono::seconds(5));
    EXPECT_FALSE(indexFile().find(*file)) << chunk;
    fs::last_write_time(chunk, before);
  }
  EXPECT_TRUE(indexFile().find(*file));
}

}  // namespace
}  // namespace isolux::test
