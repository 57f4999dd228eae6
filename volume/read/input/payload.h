// Decodes the voxels a header describes: the one path for raw, MetaImage, NRRD, NIfTI and legacy VTK.
//
// The claim of the header is compared with the real size of the file before anything is allocated: exactly
// for uncompressed data, by zlib's best ratio (1032:1) for compressed data, by two characters per number
// for text. Memory: the chosen component of the chosen time step in the file's type, and 1 MiB chunks.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "volume/read/input/bytes.h"
#include "volume/read/input/convert.h"
#include "volume/read/input/image_header.h"
#include "volume/volume.h"

namespace isolux::volume {

// Throws Error{input} when the file cannot hold the claim, Error{memory} when the volume is over the budget,
// Error{usage} when the component or time step does not exist, Error{interrupted}.
FileVoxels decodePayload(const ImageHeader& header, const Bytes& own, const OpenBeside& beside,
                         const ReadOptions& options, base::Progress& progress,
                         std::vector<std::string>& warnings);

// The bytes of an uncompressed payload: files in order, each with the same number of bytes from `begin` on.
// Throws Error{input} as decodePayload() does where a file cannot hold what the header claims.
struct PlainBytes {
  std::unique_ptr<Bytes> beside;  // null: in the file with the header
  std::uint64_t begin = 0;
};
std::vector<PlainBytes> plainBytes(const ImageHeader& header, const Bytes& own, const OpenBeside& beside);

// Whether a header's slope and intercept can be applied: values are finite, also their differences, and the
// stored range is not mapped to a single one.
bool scalingIsUsable(const Grid& grid);
inline constexpr std::string_view kScalingLeftOut = "slope and intercept are too extreme to apply; left out";

// A Volume without voxels, with what the header states and, as a warning, that it has more components than
// are shown.
Volume volumeOf(const ImageHeader& header, const ReadOptions& options);

// What a user should know: that the file has more than is shown, that voxels are missing.
void noteStep(Volume& volume, double step);
void noteMissing(Volume& volume, const Grid& grid);

// Everything after the header: checks, decodes, converts and fills the Volume (all but `name`).
Volume volumeFrom(ImageHeader header, const Bytes& own, const OpenBeside& beside, const ReadOptions& options,
                  base::Progress& progress);

// The last step, for readers that decode by other means: Grid, unit, warnings about components, time steps
// and missing voxels. `voxels` are those chosen by the options.
Volume finishVolume(const ImageHeader& header, FileVoxels&& voxels, const ReadOptions& options,
                    base::Progress& progress);

// Throws as decodePayload() does.
void checkChoices(const ImageHeader& header, const std::string& file, const ReadOptions& options);
// The second: of anything else that reading makes; `remedy` as in base::MemoryBudget.
void checkBudget(const ImageHeader& header, const std::string& file, const ReadOptions& options);
void checkBudget(std::uint64_t bytes, std::string_view what, std::string_view remedy, const std::string& file,
                 const ReadOptions& options);

}  // namespace isolux::volume
