// The files of a Zarr hierarchy by their keys ("0/c/1/2/3"): a folder, or what tests put there.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "volume/read/input/bytes.h"

namespace isolux::volume {

class ZarrStore {
 public:
  virtual ~ZarrStore() = default;

  // Null where there is no such file. Throws base::Error{input} where it is there and cannot be opened.
  virtual std::unique_ptr<Bytes> open(const std::string& key) const = 0;
  // Names of the folders in the folder `key` ("" is the root), in natural order.
  virtual std::vector<std::string> folders(const std::string& key) const = 0;
  // As messages name a key.
  virtual std::string nameOf(const std::string& key) const = 0;

  // A whole small file; nothing where there is none. Throws base::Error{input} above 16 MiB.
  std::optional<std::string> text(const std::string& key) const;
};

class FolderStore final : public ZarrStore {
 public:
  explicit FolderStore(std::filesystem::path root) : root_(std::move(root)) {}
  std::unique_ptr<Bytes> open(const std::string& key) const override;
  std::vector<std::string> folders(const std::string& key) const override;
  std::string nameOf(const std::string& key) const override {
    return key.empty() ? root_.string() : (root_ / key).string();
  }

 private:
  std::filesystem::path root_;
};

// "a" and "b" become "a/b"; an empty one is left out.
std::string joinedKey(const std::string& folder, const std::string& name);

}  // namespace isolux::volume
