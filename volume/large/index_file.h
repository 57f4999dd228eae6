// The file of a volume's index: where it is, and whether it is of the volume as it is now.
//
// FILE.index beside the volume; where the folder cannot be written, in the user's cache ($XDG_CACHE_HOME or
// ~/.cache, isolux/index). What is not finished is in FILE.index.part-I-of-N, whichever run left it: the next
// one goes on from there, and removes it when the index is whole. A file that is cut off, damaged or of
// another state of the volume counts as none; so does an index of parts of the volume that could not be read
// then, and can be now.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "base/progress.h"
#include "volume/large/volume_index.h"
#include "volume/read/input/read_options.h"

namespace isolux::volume {

class IndexFile {
 public:
  // `path` and `options` as for readVolume(). `place`: the index; empty: beside the volume, or in the cache.
  IndexFile(const std::string& path, const ReadOptions& options, std::filesystem::path place = {});

  const std::filesystem::path& place() const { return place_; }

  // Nothing: there is none of the volume as it is.
  std::optional<VolumeIndex> find(const ChunkedVolume& file) const;
  // Makes what is missing of it, and writes it. Part 1 of 1 takes what any parts have and ends with the
  // index; another part ends with its own file. Returns where it was written; `index` is the result. Throws
  // Error: input, memory, interrupted (what was done is kept).
  std::filesystem::path make(const ChunkedVolume& file, IndexPart part, std::optional<VolumeIndex>& index,
                             base::Progress& progress) const;

 private:
  std::filesystem::path partPath(IndexPart part) const;
  std::vector<std::filesystem::path> partFiles() const;
  void save(const VolumeIndex& index, const std::filesystem::path& to) const;
  std::optional<VolumeIndex> load(const std::filesystem::path& from, const ChunkedVolume& file) const;

  VolumePart part_;
  std::string identity_;  // of the volume's files as they are
  std::filesystem::path place_;
};

}  // namespace isolux::volume
