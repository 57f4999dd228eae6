// Which pictures of a numbered series are drawn: for jobs that share a film.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace isolux::app {

struct FrameRange {
  int first = 0, last = 0;  // numbers as in the names of the files, both drawn
  bool contains(int frame) const { return first <= frame && frame <= last; }
};
// "A-B" or "A". Throws base::Error{usage} naming --frames for anything else, and where B is below A.
FrameRange parseFrames(const std::string& text);

struct FrameChoice {
  std::optional<FrameRange> frames;  // none: all
  bool skipExisting = false;  // a file that is there is whole: every picture is written whole or not at all

  bool wants(int frame, const std::filesystem::path& file) const;
  // Throws base::Error{usage} where the range has none of `count` frames.
  void check(int count) const;
};

}  // namespace isolux::app
