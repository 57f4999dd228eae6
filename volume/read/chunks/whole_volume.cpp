// A chunked volume read as a whole.
#include <cmath>

#include "volume/read/chunks/array_volume.h"
#include "volume/read/input/chunked_header.h"
#include "volume/read/input/payload.h"

namespace isolux::volume {

namespace {

// The square root of the sum of squares over all channels.
ArrayVolume::Whole magnitudeOf(const ArrayVolume& volume, int time, base::Progress& progress) {
  const std::size_t count = volume.facts().levels.front().geometry.voxelCount();
  std::vector<double> sums(count, 0.0);
  ArrayVolume::Whole whole;
  for (int channel = 0; channel < volume.facts().channels; ++channel) {
    whole = volume.readWhole({time, channel}, progress);
    std::visit(
        [&](const auto& voxels) {
          for (std::size_t i = 0; i < count; ++i) {
            const auto value = static_cast<double>(voxels[i]);
            sums[i] += value * value;
          }
        },
        whole.voxels);
  }
  std::vector<float> magnitudes(count);
  for (std::size_t i = 0; i < count; ++i) magnitudes[i] = static_cast<float>(std::sqrt(sums[i]));
  whole.voxels = std::move(magnitudes);
  return whole;
}

// Two more of the voxels in double precision while a magnitude is made.
void checkWholeBudget(const ImageHeader& header, const std::string& file, const ReadOptions& options) {
  checkBudget(header, file, options);
  if (options.component < 0)
    checkBudget(header.voxels() * (bytesOf(header.type) + sizeof(double) + sizeof(float)), "the magnitude",
                "source.component = 0 needs less", file, options);
}

}  // namespace

Volume wholeVolume(const ArrayVolume& volume, const ReadOptions& options, base::Progress& progress) {
  const std::string& file = volume.facts().name;
  const ChunkedFacts& facts = volume.facts();
  ImageHeader header = chunkedHeader(facts, facts.levels.front().geometry, volume.fileType());
  // How voxels become those of a Grid is decided when all are known: what is said of parts does not hold.
  std::erase_if(header.warnings, [](const std::string& warning) {
    return warning.find("are read as float32") != std::string::npos;
  });
  checkDims(header, file, "dims");
  checkChoices(header, file, options);
  checkWholeBudget(header, file, options);
  ArrayVolume::Whole whole = options.component < 0
                                 ? magnitudeOf(volume, options.timeStep, progress)
                                 : volume.readWhole({options.timeStep, options.component}, progress);
  if (whole.missingChunks > 0)
    header.warnings.push_back(std::to_string(whole.missingChunks) + " of " + std::to_string(whole.chunks) +
                              " chunks are not in the file: their voxels have its fill value");
  Volume made = finishVolume(header, std::move(whole.voxels), options, progress);
  made.fileType = volume.typeInFile();
  takeNames(made, facts);
  return made;
}

}  // namespace isolux::volume
