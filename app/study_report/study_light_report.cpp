#include "app/study_report/study_light_report.h"

#include <algorithm>
#include <ostream>

#include <nlohmann/json.hpp>

#include "app/study_report/study_table.h"
#include "volume/extent.h"

namespace isolux::app {

namespace {

using nlohmann::ordered_json;

constexpr double kMebi = 1024.0 * 1024.0;

std::string percent(double part, int digits = 3) {
  return tableNumber(100.0 * part, digits);
}

std::string withError(const LightErrors& errors, double value, double standardError) {
  return percent(errors.relative(value)) + " ± " + percent(errors.relative(standardError), 2);
}

const char* costHead(const Knob& knob) {
  if (knob.cost == Cost::bakeSeconds) return "bake, s (quartiles)";
  return knob.cost == Cost::gpuMegabytes ? "GPU, MiB" : "lookup, ms (quartiles)";
}

std::vector<TableColumn> lightColumns(const KnobStudy& study) {
  const Knob& knob = study.knob;
  std::vector<TableColumn> columns{{costHead(knob), [&knob](const StudySetting& setting) {
                                      return tableTime(costSpread(knob, setting, panelsOf(knob)[0]));
                                    }}};
  if (knob.cost == Cost::gpuMegabytes)
    columns[0].cell = [&knob](const StudySetting& setting) {
      return tableNumber(costOf(knob, setting, panelsOf(knob)[0]));
    };
  const auto add = [&](const char* head, auto text) {
    columns.push_back({head, [text](const StudySetting& setting) { return text(setting.errors.light); }});
  };
  add("RMSE, % of mean E", [](const LightErrors& e) { return withError(e, e.rmse, e.rmseStandardError); });
  add("bias, %", [](const LightErrors& e) { return withError(e, e.bias, e.biasStandardError); });
  add("largest, %", [](const LightErrors& e) { return percent(e.relative(e.maximum)); });
  const std::vector<TableColumn> picture = pictureColumns(study);
  columns.insert(columns.end(), picture.begin(), picture.end());
  return columns;
}

bool isLight(const KnobStudy& study) {
  return study.knob.measure == Measure::light && !study.settings.empty();
}

}  // namespace

ordered_json quartilesJson(const std::vector<double>& times) {
  if (times.empty()) return nullptr;
  const TimeSpread spread = spreadOfTimes(times);
  return {spread.low, spread.high};
}

ordered_json lightCostJson(const LightCost& cost) {
  return {{"bake_seconds", cost.bakeSeconds},
          {"bake_seconds_quartiles", quartilesJson(cost.bakeTimes)},
          {"rays", cost.rays},
          {"texels", cost.texels},
          {"lookup_milliseconds", cost.lookupMilliseconds},
          {"lookup_milliseconds_quartiles", quartilesJson(cost.lookupTimes)},
          {"lattice_bytes", cost.latticeBytes},
          {"gpu_bytes", cost.gpuBytes}};
}

ordered_json lightErrorsJson(const LightErrors& errors, glm::ivec2 size) {
  const glm::ivec2 place = volume::Extent2{size}.at(errors.maximumPixel);
  return {{"pixels", errors.pixels},
          {"mean_irradiance", errors.mean},
          {"truth_noise", errors.truthNoise},
          {"rmse", errors.rmse},
          {"rmse_standard_error", errors.rmseStandardError},
          {"rmse_relative", errors.relative(errors.rmse)},
          {"bias", errors.bias},
          {"bias_standard_error", errors.biasStandardError},
          {"bias_relative", errors.relative(errors.bias)},
          {"quantile_99", errors.most99},
          {"maximum", errors.maximum},
          {"maximum_z", errors.maximumZ},
          {"maximum_pixel", {place.x, place.y}}};
}

void writeLightTable(std::ostream& out, const KnobStudy& study) {
  const LightErrors& first = study.settings.front().errors.light;
  out << "Against path tracing at " << first.pixels << " pixels, " << study.truthSamples
      << " paths each, at most " << study.truthBounces << (study.truthBounces == 1 ? " bounce" : " bounces")
      << ": mean E " << tableNumber(first.mean, 4) << ", standard error of a pixel "
      << percent(first.relative(first.truthNoise), 2) << " % of it.\n\n";
  writeTable(out, study, lightColumns(study));
}

void writeLightReach(std::ostream& out, const std::vector<KnobStudy>& studies) {
  if (std::none_of(studies.begin(), studies.end(), isLight)) return;
  const auto& errors = errorsToReach(Measure::light);
  out << "\n## Which setting of light reaches an error\n\nThe cheapest value with at most this RMSE in parts "
         "of the mean irradiance, all other settings as the scene has them.\n\n| setting |";
  for (const double error : errors) out << ' ' << percent(error) << " % |";
  out << "\n|---|---|---|---|\n";
  for (const KnobStudy& study : studies) {
    if (!isLight(study)) continue;
    const Panel& panel = panelsOf(study.knob)[0];
    out << "| `" << study.knob.setting << "` |";
    for (const double error : errors) {
      const StudySetting* const setting = cheapest(study, error);
      if (setting)
        out << " `" << setting->value << "` (" << costText(study.knob, costOf(study.knob, *setting, panel))
            << ") |";
      else
        out << " none |";
    }
    out << '\n';
  }
}

}  // namespace isolux::app
