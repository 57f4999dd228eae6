// What a new isovalue costs before the first ray: active blocks kept up to date, against finding them anew;
// and the masks by which rays skip empty space.
#include <cstdio>
#include <functional>

#include "bench/bench.h"
#include "tests/support/test_data.h"
#include "volume/phantom/phantom.h"
#include "volume/read/reader.h"
#include "volume/skip/active_blocks.h"
#include "volume/skip/box_bounds.h"
#include "volume/skip/cell_bits.h"

namespace isolux::bench {
namespace {

struct Subject {
  std::string name;
  std::shared_ptr<const volume::Grid> grid;
  double isovalue;
};

std::vector<Subject> subjects() {
  base::Progress progress;
  std::vector<Subject> list;
  const auto phantom = [&](const char* text) {
    return std::make_shared<volume::Grid>(volume::makePhantom(volume::parsePhantom(text), progress));
  };
  list.push_back({"gyroid 512", phantom("gyroid:512"), 0.0});
  list.push_back({"head phantom, bone", phantom("head:256"), 300.0});
  if (const auto data = test::dataFolder(); !data.empty())
    list.push_back(
        {"ct_head_skin_bone, bone",
         volume::readVolume((data / "volumes/ct_head_skin_bone.nii.gz").string(), {}, progress).grid, 0.51});
  return list;
}

// Isovalues up and down in steps of a fraction of the range of values.
class Drag {
 public:
  Drag(const Subject& subject, double fractionOfRange)
      : grid_(*subject.grid),
        isovalue_(subject.isovalue),
        step_(fractionOfRange * (grid_.maximum() - grid_.minimum())) {}
  float next() {
    ++count_;
    return static_cast<float>(
        grid_.storedOfValue(isovalue_ + (count_ / 8 % 2 ? 8 - count_ % 8 : count_ % 8) * step_));
  }

 private:
  const volume::Grid& grid_;
  double isovalue_, step_;
  int count_ = 0;
};

// Of the isovalue at rest.
void printMasks(const Subject& subject, const std::shared_ptr<const volume::MinMaxBlocks>& blocks) {
  base::Progress progress;
  const volume::BoxBounds bounds(*subject.grid, *blocks, progress);
  const auto isovalue = subject.grid->storedIsovalue(subject.isovalue);
  volume::ActiveBlocks active(blocks);
  active.update({&isovalue, 1});
  std::vector<std::uint64_t> boxes, cells;
  const std::vector<double> times =
      medians({[&] {
                 bounds.masks({&isovalue, 1}, active.flags(), boxes);
               },
               [&] {
                 volume::cellBits(*subject.grid, blocks->dims(), boxes, {&isovalue, 1}, cells);
               }},
              5);
  printComparison({"masks of boxes", "bits of cells, from the second picture on"}, times);
}

void run() {
  constexpr int steps = 200;
  for (const Subject& subject : subjects()) {
    base::Progress progress;
    const auto blocks = std::make_shared<volume::MinMaxBlocks>(*subject.grid, 8, progress);
    std::printf(" %s, %zu blocks of 8^3; %d new isovalues\n", subject.name.c_str(), blocks->count(), steps);
    for (const double fraction : {1.0 / 2048.0, 1.0 / 256.0, 1.0 / 32.0}) {
      Drag scanned(subject, fraction), followed(subject, fraction);
      std::vector<std::uint8_t> flags;
      volume::ActiveBlocks active(blocks);
      std::size_t changedBlocks = 0;
      const auto scan = [&] {
        for (int i = 0; i < steps; ++i) blocks->activeBlocks(scanned.next(), flags);
      };
      const auto follow = [&] {
        changedBlocks = 0;
        for (int i = 0; i < steps; ++i) {
          const float isovalue = followed.next();
          changedBlocks += active.update({&isovalue, 1}).size();
        }
      };
      const std::vector<double> times = medians({scan, follow}, 5);
      char changes[100];
      std::snprintf(changes, sizeof changes, "only what changes: %.0f blocks of %zu",
                    static_cast<double>(changedBlocks) / steps, active.activeCount());
      std::printf("  steps of 1/%.0f of the range\n", 1.0 / fraction);
      printComparison({"every block anew", changes}, times);
    }
    printMasks(subject, blocks);
  }
}

const Registration registration("isovalue", "a new isovalue: blocks anew, or only those that change; masks",
                                run);

}  // namespace
}  // namespace isolux::bench
