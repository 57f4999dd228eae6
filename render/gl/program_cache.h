// Stores linked programs as files, so that a later start compiles none that an earlier one has compiled.
//
// A file belongs to one driver, one version of Isolux and one pair of shader texts with all defines. A file
// that is damaged, cut off or of anything else is ignored and replaced. Without a folder, without formats of
// the driver, or where nothing can be read or written, every program is compiled; none of this is an error.
// Files are written in the background (base/destroy_in_background.h), each whole or not at all
// (base/pending_file.h), so that processes may share the folder. It is limited in size: the files not used
// for longest are removed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include <GL/glcorearb.h>

#include "render/graph/frame.h"

namespace isolux::render {

struct Gl;

struct ProgramStore {
  std::filesystem::path folder;  // created with the first file; empty: nothing is stored
  std::string version;           // of Isolux
  // Software rasterisers, too. Mesa has a cache of its own for them, which also holds machine code: figures
  // in docs/records/2026-11-benchmarks.md, First picture.
  bool software = false;
  std::uint64_t mostBytes = std::uint64_t{64} << 20;
};

// Sets the store of contexts made later; until then there is none. Safe from any thread.
void setProgramStore(ProgramStore store);
ProgramStore programStore();

struct StoredPrograms {
  std::size_t count = 0;
  std::uint64_t bytes = 0;
};
StoredPrograms storedPrograms(const std::filesystem::path& folder);

// The cache of one context, for the thread that it is current on.
class ProgramCache {
 public:
  ProgramCache(const Gl& gl, ProgramStore store);

  // Links `program`, a new one, from the file of these texts. Returns false if there is none that the driver
  // takes; the program can then be linked from shaders.
  bool load(const Gl& gl, GLuint program, std::string_view vertex, std::string_view fragment);
  // Requires that store() can read the program: to be called before it is linked from shaders.
  void beforeLink(const Gl& gl, GLuint program) const;
  // Counts a program that was linked from shaders, and stores it.
  void store(const Gl& gl, GLuint program, std::string_view vertex, std::string_view fragment);

  const ProgramCounts& counts() const { return counts_; }

 private:
  std::string identityOf(std::string_view vertex, std::string_view fragment) const;
  std::filesystem::path fileOf(const std::string& identity) const;

  ProgramStore store_;  // without folder: unused
  std::string driver_;
  ProgramCounts counts_;
};

}  // namespace isolux::render
