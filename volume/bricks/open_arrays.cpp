#include "volume/bricks/open_arrays.h"

#include "volume/bricks/hdf5/hdf5.h"
#include "volume/bricks/zarr/zarr.h"

namespace isolux::volume {

std::shared_ptr<const ChunkedVolume> openArrays(const std::string& path, const std::string& series,
                                                base::Progress& progress) {
  if (const auto folder = zarrFolderOf(path); !folder.empty()) return openZarr(folder, series).volume;
  if (auto dataset = hdf5PathOf(path)) {
    if (dataset->dataset.empty()) dataset->dataset = series;
    return openHdf5(*dataset, progress).volume;
  }
  return nullptr;
}

}  // namespace isolux::volume
