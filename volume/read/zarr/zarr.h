// Opens Zarr folders: OME-Zarr images, single levels of them, and arrays without any more words.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "volume/read/chunks/array_volume.h"
#include "volume/read/zarr/zarr_store.h"

namespace isolux::volume {

// True for a folder with the metadata of a Zarr group or array.
bool isZarrFolder(const std::filesystem::path& folder);
// The Zarr folder that `path` is or, being a metadata file of it, lies in; else empty.
std::filesystem::path zarrFolderOf(const std::filesystem::path& path);

// `series`: which image of a folder with several, by the name of its folder; empty: the first. Their choices
// are "NAME<TAB>NAME". Throws base::Error{input}.
std::unique_ptr<ArrayVolume> openZarr(const std::filesystem::path& folder, const std::string& series = "");
// The same of the folder `key` of any store; `name` for messages.
std::unique_ptr<ArrayVolume> openZarr(std::shared_ptr<const ZarrStore> store, const std::string& key,
                                      const std::string& name, const std::string& series);

}  // namespace isolux::volume
