// No command writes over what it reads, nor two results into one file.
//
// Files are the same when the system says so (device and inode: links, other spellings, other mounts of the
// same folder), and when a new file would come to stand under the same name. Checked before anything slow
// starts. Use: reads() for everything, then writes() for each output.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "scene/scene.h"

namespace isolux::app {

class OutputGuard {
 public:
  // `role` names it in messages: "the light probe".
  void reads(const std::filesystem::path& file, const std::string& role);
  // Everything a scene is drawn from: its volumes with all their files, and its light probe.
  void reads(const scene::Scene& scene);
  // Throws Error{usage} for a file that is read or written already. `option` names it in messages: "--out".
  void writes(const std::filesystem::path& file, const std::string& option);

 private:
  void readsVolume(const std::string& path, const std::string& role);

  // What they are for, by what tells files apart: a series has thousands.
  std::map<std::string, std::string> read_, written_;
};

}  // namespace isolux::app
