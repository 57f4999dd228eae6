// Pieces of volumes of 512^3: from nothing, and after a small step of the isovalue.
#include <cstdio>
#include <functional>

#include <glm/common.hpp>

#include "bench/bench.h"
#include "tests/support/test_data.h"
#include "volume/parallel/parallel_steps.h"
#include "volume/phantom/phantom.h"
#include "volume/pieces/pieces.h"
#include "volume/pieces/shown_pieces.h"
#include "volume/read/reader.h"

namespace isolux::bench {
namespace {

struct Subject {
  std::string name;
  std::shared_ptr<const volume::Grid> grid;
  double isovalue, step;
};

// Trilinear, int16.
std::shared_ptr<const volume::Grid> resampled(const volume::Grid& grid, int size) {
  const volume::GridGeometry geometry = volume::GridGeometry::make(glm::ivec3(size), glm::dvec3(1.0));
  const glm::dvec3 scale = glm::dvec3(grid.dims() - 1) / static_cast<double>(size - 1);
  const double units = 20000.0 / (grid.maximum() - grid.minimum());
  std::vector<std::int16_t> voxels(geometry.voxelCount());
  base::Progress progress;
  volume::parallelSteps(static_cast<std::size_t>(size), progress, {}, [&](std::size_t z) {
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        const glm::dvec3 at = glm::dvec3(x, y, static_cast<double>(z)) * scale;
        const glm::ivec3 low = glm::min(glm::ivec3(at), grid.dims() - 2);
        const glm::dvec3 part = at - glm::dvec3(low);
        double value = 0.0;
        for (int corner = 0; corner < 8; ++corner) {
          const glm::ivec3 step(corner & 1, corner >> 1 & 1, corner >> 2);
          const glm::dvec3 weight = glm::mix(1.0 - part, part, glm::dvec3(step));
          value +=
              weight.x * weight.y * weight.z * grid.value(low.x + step.x, low.y + step.y, low.z + step.z);
        }
        voxels[(z * static_cast<std::size_t>(size) + static_cast<std::size_t>(y)) *
                   static_cast<std::size_t>(size) +
               static_cast<std::size_t>(x)] = static_cast<std::int16_t>(units * (value - grid.minimum()));
      }
  });
  return std::make_shared<const volume::Grid>(geometry, std::move(voxels), 1.0 / units, grid.minimum());
}

std::vector<Subject> subjects() {
  base::Progress progress;
  const auto phantom = [&](const char* text) {
    return volume::makePhantom(volume::parsePhantom(text), progress);
  };
  std::vector<Subject> list;
  list.push_back({"gyroid, 512^3", std::make_shared<const volume::Grid>(phantom("gyroid:512")), 0.0, 0.01});
  list.push_back({"head phantom to 512^3, bone", resampled(phantom("head:256"), 512), 300.0, 5.0});
  if (const auto data = test::dataFolder(); !data.empty()) {
    const auto scan = volume::readVolume((data / "volumes/ct_head_pitch.nii.gz").string(), {}, progress).grid;
    list.push_back({"ct_head_pitch to 512^3, skin", resampled(*scan, 512), -300.0, 5.0});
    list.push_back({"the same, bone", list.back().grid, 300.0, 5.0});
    const auto bonsai = volume::readVolume((data / "volumes/bonsai.nii.gz").string(), {}, progress).grid;
    list.push_back({"bonsai to 512^3", resampled(*bonsai, 512), 40.0, 0.5});
  }
  return list;
}

void run() {
  for (const Subject& subject : subjects()) {
    base::Progress progress;
    const volume::MinMaxBlocks blocks(*subject.grid, 8, progress);
    int steps = 0;
    const auto at = [&](double isovalue) {
      return volume::Pieces(subject.grid, blocks, isovalue, scene::Inside::above, progress);
    };
    const volume::Pieces pieces = at(subject.isovalue);
    std::printf(" %s, isovalue %g: %zu pieces, %.1f MiB\n", subject.name.c_str(), subject.isovalue,
                pieces.list().size(), static_cast<double>(pieces.bytes()) / 1048576.0);
    const auto times =
        medians({[&] { volume::MinMaxBlocks(*subject.grid, 8, progress); }, [&] { at(subject.isovalue); },
                 [&] { at(subject.isovalue + subject.step * (++steps % 5)); },
                 [&] {
                   volume::hiddenVoxels(pieces, volume::shownPieces(pieces, {1, 0.0, {}, {}}), true);
                 }},
                5);
    printComparison({"blocks, which every picture needs", "pieces from nothing",
                     "after a step of the isovalue", "bits of all but the largest"},
                    times);
  }
}

const Registration registration("pieces",
                                "connected pieces of 512^3: from nothing, and after a step of the isovalue",
                                run);

}  // namespace
}  // namespace isolux::bench
