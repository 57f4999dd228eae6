// Provides a volume with everything derived from it that every frame needs: computed once, on the loading
// thread.
#pragma once

#include <memory>
#include <optional>

#include "scene/rules/automatic.h"
#include "scene/settings/host_settings.h"
#include "volume/color/second_volume.h"
#include "volume/derived/cubic_fields.h"
#include "volume/labels/shown_labels.h"
#include "volume/pieces/piece_sets.h"
#include "volume/prepared/derivative_choices.h"
#include "volume/prepared/label_surfaces.h"
#include "volume/prepared/still_hits.h"
#include "volume/skip/box_bounds.h"
#include "volume/skip/min_max_blocks.h"
#include "volume/statistics/data_kind.h"
#include "volume/statistics/histogram.h"
#include "volume/statistics/white_matter.h"
#include "volume/volume.h"

namespace isolux::volume {

struct VolumeFile;

struct PreparedVolume {
  Volume volume;
  // A label map whose labels are shown (Source::labels) has their mask field as the grid above; `asRead`
  // is the volume with the labels themselves.
  std::shared_ptr<const ShownLabels> labels;
  std::optional<Volume> asRead;
  std::shared_ptr<const LabelSurfaces> labelSurfaces;  // of labels; computed at the first request
  std::shared_ptr<const MinMaxBlocks> blocks;
  // Sub-blocks of the trilinear field, for blocks of BoxBounds::kBlockCells; null if voxels stay in their
  // file.
  std::shared_ptr<const BoxBounds> boxes;
  std::shared_ptr<CubicFields> cubicFields;              // computed at the first request
  std::shared_ptr<DerivativeChoices> derivativeChoices;  // likewise
  std::shared_ptr<const StillHits> stillHits;            // likewise
  std::shared_ptr<const PieceSets> pieces;               // likewise
  std::shared_ptr<SecondVolumes> secondVolumes;          // that colour its surface
  std::shared_ptr<const KeptWhiteMatter> whiteMatter;    // of an MR scan
  Histogram histogram;
  FoundKind kind;
  scene::VolumeFacts facts;
  double readSeconds = 0.0, prepareSeconds = 0.0;

  const Grid& grid() const { return *volume.grid; }
};

// Runs readVolume(), the combination with a second volume (csg.h), and computes the derived structures.
// Throws base::Error.
std::shared_ptr<const PreparedVolume> loadVolume(const scene::Source& source, base::Progress& progress);
// As above for callers that only draw. A file that can be read in parts is not loaded if `machine` says so or
// if it does not fit (volume/bricks). Its index is read, or computed and stored next to it
// (volume/large/volume_index.h); grid() is then out-of-core.
std::shared_ptr<const PreparedVolume> loadVolume(const scene::Source& source, const scene::HostSettings& host,
                                                 base::Progress& progress);
// As the first, of a file that is open: readSource().
std::shared_ptr<const PreparedVolume> loadVolume(const scene::Source& source, const VolumeFile& first,
                                                 base::Progress& progress);
// Prepares voxels in memory; a label map keeps its values.
std::shared_ptr<const PreparedVolume> prepareVolume(Volume volume, base::Progress& progress);
// Prepares the mask field of some labels of a map, with what frames and light need; no histogram and no facts
// but the axes.
std::shared_ptr<const PreparedVolume> prepareMask(Volume asRead, std::shared_ptr<const ShownLabels> labels,
                                                  base::Progress& progress);
// As loadVolume() of a source that differs in `labels` and `smoothing` alone, without reading the file.
// Requires that `shown` has labels.
std::shared_ptr<const PreparedVolume> showOtherLabels(const PreparedVolume& shown,
                                                      const scene::Source& source, base::Progress& progress);

}  // namespace isolux::volume
