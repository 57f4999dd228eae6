#include "app/series/frame_range.h"

#include <charconv>
#include <system_error>

#include "base/error.h"

namespace isolux::app {

namespace {

[[noreturn]] void refuse(const std::string& reason) {
  throw base::Error(base::ErrorKind::usage, "", "--frames", reason);
}

}  // namespace

FrameRange parseFrames(const std::string& text) {
  FrameRange range;
  const char* const end = text.data() + text.size();
  auto read = std::from_chars(text.data(), end, range.first);
  bool good = read.ec == std::errc() && range.first >= 0;
  range.last = range.first;
  if (good && read.ptr != end) {
    good = *read.ptr == '-';
    if (good) read = std::from_chars(read.ptr + 1, end, range.last);
  }
  if (!good || read.ec != std::errc() || read.ptr != end || range.last < range.first)
    refuse("\"" + text + "\" is not a number, or two with a - between, the smaller one first, such as 0-99");
  return range;
}

bool FrameChoice::wants(int frame, const std::filesystem::path& file) const {
  if (frames && !frames->contains(frame)) return false;
  std::error_code missing;
  return !skipExisting || !std::filesystem::is_regular_file(file, missing);
}

void FrameChoice::check(int count) const {
  if (frames && frames->first >= count)
    refuse("frame " + std::to_string(frames->first) + " does not exist: there are " + std::to_string(count) +
           ", from 0");
}

}  // namespace isolux::app
