#include "app/series/frame_range.h"

#include <system_error>

#include "base/decimal_text.h"
#include "base/error.h"

namespace isolux::app {

FrameRange parseFrames(const std::string& text) {
  const bool one = text.find('-') == std::string::npos;
  const auto range = base::readTwoIntegers(one ? text + '-' + text : text, '-');
  if (!range || range->first < 0 || range->second < range->first)
    base::throwUsage(
        "", "--frames",
        "\"" + text + "\" is not a number, or two with a - between, the smaller one first, such as 0-99");
  return {range->first, range->second};
}

bool FrameChoice::wants(int frame, const std::filesystem::path& file) const {
  if (frames && !frames->contains(frame)) return false;
  std::error_code missing;
  return !skipExisting || !std::filesystem::is_regular_file(file, missing);
}

void FrameChoice::check(int count) const {
  if (frames && frames->first >= count)
    base::throwUsage("", "--frames",
                     "frame " + std::to_string(frames->first) + " does not exist: there are " +
                         std::to_string(count) + ", from 0");
}

}  // namespace isolux::app
