// The files of a Zarr hierarchy in memory.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "volume/read/zarr/zarr_store.h"

namespace isolux::test {

class MemoryStore final : public volume::ZarrStore {
 public:
  explicit MemoryStore(std::map<std::string, std::string> files) : files_(std::move(files)) {}

  std::unique_ptr<volume::Bytes> open(const std::string& key) const override {
    const auto found = files_.find(key);
    if (found == files_.end()) return nullptr;
    return std::make_unique<volume::MemoryBytes>(key, std::as_bytes(std::span(found->second)));
  }
  std::vector<std::string> folders(const std::string& key) const override {
    std::set<std::string> names;
    const std::string prefix = key.empty() ? "" : key + "/";
    for (const auto& [name, bytes] : files_) {
      if (!name.starts_with(prefix)) continue;
      const std::size_t slash = name.find('/', prefix.size());
      if (slash != std::string::npos) names.insert(name.substr(prefix.size(), slash - prefix.size()));
    }
    return {names.begin(), names.end()};
  }
  std::string nameOf(const std::string& key) const override { return key; }

 private:
  std::map<std::string, std::string> files_;
};

}  // namespace isolux::test
