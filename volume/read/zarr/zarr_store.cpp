#include "volume/read/zarr/zarr_store.h"

#include <algorithm>
#include <system_error>

#include "base/error.h"
#include "volume/read/tiff/tiff_pages.h"

namespace isolux::volume {

namespace fs = std::filesystem;

std::string joinedKey(const std::string& folder, const std::string& name) {
  if (folder.empty() || name.empty()) return folder + name;
  return folder + "/" + name;
}

std::optional<std::string> ZarrStore::text(const std::string& key) const {
  constexpr std::size_t longest = std::size_t{16} << 20;
  const std::unique_ptr<Bytes> bytes = open(key);
  if (!bytes) return std::nullopt;
  if (bytes->size() > longest) base::throwInput(bytes->name(), "", "metadata of more than 16 MiB");
  return bytes->head(longest);
}

std::unique_ptr<Bytes> FolderStore::open(const std::string& key) const {
  const fs::path file = root_ / key;
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (status.type() == fs::file_type::not_found) return nullptr;
  return std::make_unique<FileBytes>(file);
}

std::vector<std::string> FolderStore::folders(const std::string& key) const {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator entry(root_ / key, error), end; !error && entry != end;
       entry.increment(error)) {
    std::error_code ignored;
    if (entry->is_directory(ignored)) names.push_back(entry->path().filename().string());
  }
  std::ranges::sort(names, naturalLess);
  return names;
}

}  // namespace isolux::volume
