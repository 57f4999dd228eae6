#include "app/series/sweep.h"

#include <array>
#include <cmath>

#include <nlohmann/json.hpp>

#include "base/decimal_text.h"
#include "base/error.h"
#include "base/number_text.h"
#include "scene/settings/assignment.h"
#include "scene/settings/host_settings.h"
#include "scene/settings/settings.h"

namespace isolux::app {

namespace {

constexpr int kMostSweptValues = 100000;

}  // namespace

double Sweep::value(int index) const {
  if (count < 2) return low;
  if (index == count - 1) return high;
  const double step = (high - low) / (count - 1);
  // Without the last bits of the sum, which would stand in names: 0.30000000000000004.
  return *base::readNumber(base::shortText(low + step * index, 12));
}

void Sweep::apply(scene::Scene& scene, int index) const {
  const scene::Setting setting = scene::setting(path);
  const double v = value(index);
  if (setting.type == scene::SettingType::integer)
    setting.set(scene, std::llround(v));
  else
    setting.set(scene, v);
}

Sweep parseSweep(const std::string& text) {
  Sweep sweep;
  sweep.path = std::string(scene::pathOf(text));
  const auto equals = text.find('=');
  std::array<double, 3> numbers{};
  std::size_t begin = equals == std::string::npos ? text.size() : equals + 1, read = 0;
  while (begin <= text.size() && read < numbers.size() + 1) {
    const std::size_t end = std::min(text.find(':', begin), text.size());
    const auto number = base::readNumber(std::string_view(text).substr(begin, end - begin));
    if (!number) break;
    if (read < numbers.size()) numbers[read] = *number;
    ++read;
    begin = end + 1;
  }
  const double count = numbers[2];
  if (equals == std::string::npos || read != numbers.size() || begin <= text.size() || count < 1 ||
      count > kMostSweptValues || count != std::floor(count))
    base::throwUsage("", "--sweep", '"' + text + "\" is not PATH=LOW:HIGH:COUNT, COUNT from 1 to 100000");
  sweep.low = numbers[0];
  sweep.high = numbers[1];
  sweep.count = static_cast<int>(count);
  if (scene::isHostSetting(sweep.path))
    base::throwUsage("", sweep.path, "is a host setting and changes no image");
  const scene::Setting setting = scene::setting(sweep.path);
  if (setting.type != scene::SettingType::number && setting.type != scene::SettingType::integer)
    base::throwUsage("", sweep.path, "is not a number and cannot be swept");
  if (setting.type == scene::SettingType::integer)
    for (int i = 0; i < sweep.count; ++i)
      if (sweep.value(i) != std::floor(sweep.value(i)))
        base::throwUsage("", sweep.path,
                         "takes whole numbers, " + base::shortText(sweep.value(i)) + " is none");
  scene::Scene scene;  // both ends lie in its range
  sweep.apply(scene, 0);
  sweep.apply(scene, sweep.count - 1);
  return sweep;
}

}  // namespace isolux::app
