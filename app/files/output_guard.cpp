#include "app/files/output_guard.h"

#include <system_error>

#include <sys/stat.h>

#include "base/error.h"
#include "base/pending_file.h"
#include "volume/read/source_files.h"

namespace isolux::app {

namespace fs = std::filesystem;

namespace {

// Equal for the same file, by whatever name. Empty: nobody knows.
std::string identityOf(const fs::path& file) {
  struct stat found {};
  if (::stat(file.c_str(), &found) == 0)
    return "#" + std::to_string(found.st_dev) + ":" + std::to_string(found.st_ino);
  // What does not exist yet has no inode, but its folder has.
  std::error_code error;
  const fs::path canonical = fs::weakly_canonical(fs::absolute(file, error), error);
  return error ? std::string() : canonical.string();
}

}  // namespace

void OutputGuard::reads(const fs::path& file, const std::string& role) {
  if (!file.empty()) read_.emplace(identityOf(file), role);
}

void OutputGuard::readsVolume(const std::string& path, const std::string& role) {
  for (const fs::path& file : volume::filesOfVolume(path)) reads(file, role);
}

void OutputGuard::reads(const scene::Scene& scene) {
  readsVolume(scene.source.path, "the volume");
  if (scene.source.csg != scene::Csg::none) readsVolume(scene.source.csgPath, "the second volume");
  readsVolume(scene.color.volume, "the volume that colours the surface");
  reads(scene.source.labelNames, "the file of labels' names");
  reads(scene.light.environment.file, "the environment map");
}

void OutputGuard::writes(const fs::path& file, const std::string& option) {
  const fs::path written = base::writtenPath(file);
  const std::string identity = identityOf(written);
  if (identity.empty()) return;
  if (const auto known = read_.find(identity); known != read_.end())
    base::throwUsage(file.string(), option,
                     "would be written over " + known->second + ", which is read from this file");
  if (const auto [known, isNew] = written_.emplace(identity, option); !isNew)
    base::throwUsage(file.string(), option, "is the file of " + known->second + ", too");
}

}  // namespace isolux::app
