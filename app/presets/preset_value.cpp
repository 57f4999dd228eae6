#include "app/presets/preset_value.h"

#include <cmath>
#include <numeric>

#include <nlohmann/json.hpp>

#include "base/error.h"

namespace isolux::app {

namespace {

constexpr const char* kForms =
    "must be a number, or one of {\"hu\": v}, {\"quantile\": q}, {\"between\": p}, {\"white_matter\": p}";

double histogramQuantile(const volume::Histogram& histogram, double part) {
  const std::uint64_t total =
      std::accumulate(histogram.counts.begin(), histogram.counts.end(), std::uint64_t{0});
  if (total == 0) return histogram.minimum;
  const double wanted = part * static_cast<double>(total);
  const double width = (histogram.maximum - histogram.minimum) / static_cast<double>(histogram.counts.size());
  double before = 0.0;
  for (std::size_t bin = 0; bin < histogram.counts.size(); ++bin) {
    const auto count = static_cast<double>(histogram.counts[bin]);
    if (count > 0.0 && before + count >= wanted)
      return histogram.minimum + width * (static_cast<double>(bin) + (wanted - before) / count);
    before += count;
  }
  return histogram.maximum;
}

}  // namespace

bool isValueOfVolume(const nlohmann::ordered_json& value) {
  return value.is_object();
}

void checkValueOfVolume(const scene::Setting& setting, const nlohmann::ordered_json& value) {
  const auto refuse = [&](const char* reason) { base::throwUsage("", setting.path, reason); };
  if (setting.unit != "data units" || setting.type != scene::SettingType::number)
    refuse("is not in data units and takes a plain value");
  if (value.size() != 1 || !value.begin().value().is_number()) refuse(kForms);
  const std::string& key = value.begin().key();
  const double number = value.begin().value().get<double>();
  if (key == "hu") return;
  if (key != "quantile" && key != "between" && key != "white_matter") refuse(kForms);
  const double least = key == "between" ? -1.0 : 0.0;
  if (!(number >= least && number <= 1.0))
    refuse("quantile and white_matter lie from 0 to 1, between from -1 to 1");
}

double valueInVolume(const nlohmann::ordered_json& value, const volume::PreparedVolume& volume) {
  const std::string& key = value.begin().key();
  const double number = value.begin().value().get<double>();
  if (key == "quantile") return histogramQuantile(volume.histogram, number);
  if (key == "between") {
    const double end = number < 0.0 ? volume.facts.minimum : volume.facts.maximum;
    return std::lerp(volume.facts.contrastIsovalue, end, std::abs(number));
  }
  if (key == "white_matter") {
    const std::optional<volume::WhiteMatter>& tissue = volume.whiteMatter->get();
    return tissue ? std::lerp(tissue->border, tissue->mean, number) : volume.facts.contrastIsovalue;
  }
  const std::optional<glm::dvec2>& scale = volume.kind.hounsfield;
  return scale ? scale->x + scale->y * number : number;
}

}  // namespace isolux::app
