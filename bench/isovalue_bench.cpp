// What a new isovalue costs before the first ray: active blocks and their faces kept up to date, against
// making both anew.
#include <cstdio>
#include <functional>

#include "bench/bench.h"
#include "render/volume/block_faces.h"
#include "tests/support/test_data.h"
#include "volume/phantom/phantom.h"
#include "volume/read/reader.h"
#include "volume/skip/active_blocks.h"

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
      render::BlockFaceSet faces(blocks->dims());
      std::size_t changedBlocks = 0, faceCount = 0;
      const auto scan = [&] {
        for (int i = 0; i < steps; ++i) {
          blocks->activeBlocks(scanned.next(), flags);
          faceCount = render::boundaryFaces(flags, blocks->dims()).size();
        }
      };
      const auto follow = [&] {
        changedBlocks = 0;
        for (int i = 0; i < steps; ++i) {
          const float isovalue = followed.next();
          const auto changed = active.update({&isovalue, 1});
          changedBlocks += changed.size();
          faces.update(active.flags(), changed);
          faces.takeDirty();
        }
      };
      const std::vector<double> times = medians({scan, follow}, 5);
      char changes[100];
      std::snprintf(changes, sizeof changes, "only what changes: %.0f blocks of %zu, %zu faces",
                    static_cast<double>(changedBlocks) / steps, active.activeCount(), faceCount);
      std::printf("  steps of 1/%.0f of the range\n", 1.0 / fraction);
      printComparison({"every block and face anew", changes}, times);
    }
  }
}

const Registration registration("isovalue",
                                "a new isovalue: blocks and faces anew, or only those that change", run);

}  // namespace
}  // namespace isolux::bench
