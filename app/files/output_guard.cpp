#include "app/files/output_guard.h"

#include <system_error>

#include "base/error.h"
#include "base/pending_file.h"
#include "volume/read/source_files.h"

namespace isolux::app {

namespace fs = std::filesystem;

namespace {

bool sameFile(const fs::path& a, const fs::path& b) {
  std::error_code error;
  if (fs::exists(a, error) && fs::exists(b, error)) return fs::equivalent(a, b, error) && !error;
  // What does not exist yet has no inode, but its folder has.
  const fs::path first = fs::weakly_canonical(fs::absolute(a, error), error);
  const fs::path second = fs::weakly_canonical(fs::absolute(b, error), error);
  return !error && !first.empty() && first == second;
}

}  // namespace

void OutputGuard::reads(const fs::path& file, const std::string& role) {
  if (!file.empty()) read_.push_back({file, role});
}

void OutputGuard::readsVolume(const std::string& path, const std::string& role) {
  for (const fs::path& file : volume::filesOfVolume(path)) reads(file, role);
}

void OutputGuard::reads(const scene::Scene& scene) {
  readsVolume(scene.source.path, "the volume");
  if (scene.source.csg != scene::Csg::none) readsVolume(scene.source.csgPath, "the second volume");
  readsVolume(scene.color.volume, "the volume that colours the surface");
  reads(scene.light.environment.file, "the light probe");
}

void OutputGuard::writes(const fs::path& file, const std::string& option) {
  const fs::path written = base::writtenPath(file);
  for (const Known& known : read_)
    if (sameFile(written, known.file))
      throw base::Error(base::ErrorKind::usage, file.string(), option,
                        "would be written over " + known.role + ", which is read from this file");
  for (const Known& known : written_)
    if (sameFile(written, known.file))
      throw base::Error(base::ErrorKind::usage, file.string(), option,
                        "is the file of " + known.role + ", too");
  written_.push_back({written, option});
}

}  // namespace isolux::app
