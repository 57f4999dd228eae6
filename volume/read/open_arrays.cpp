#include "volume/read/open_arrays.h"

#include "volume/read/hdf5/hdf5.h"
#include "volume/read/zarr/zarr.h"

namespace isolux::volume {

std::shared_ptr<const ChunkedVolume> openArrays(const std::string& path, const std::string& series,
                                                base::Progress& progress) {
  if (const auto folder = zarrFolderOf(path); !folder.empty()) return openZarr(folder, series);
  if (const auto dataset = hdf5PathOf(path)) return openHdf5(*dataset, series, progress);
  return nullptr;
}

}  // namespace isolux::volume
