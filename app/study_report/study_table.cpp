#include "app/study_report/study_table.h"

#include <algorithm>
#include <cmath>
#include <ostream>

#include "app/study/scale_study.h"
#include "base/number_text.h"
#include "base/words.h"

namespace isolux::app {

std::string tableNumber(double value, int digits) {
  if (!std::isfinite(value)) return "–";
  if (std::abs(value) >= 1000.0 && std::abs(value) < 1e6) return std::to_string(std::lround(value));
  return base::shortText(value, digits);
}

std::string costText(const QualitySetting& quality, double cost) {
  const char* unit = " ms";
  if (quality.cost == Cost::bakeSeconds) unit = " s";
  if (quality.cost == Cost::gpuMegabytes) unit = " MiB";
  return tableNumber(cost) + unit;
}

std::string errorText(const Panel& panel, double error) {
  return tableNumber(panel.shown * error) + panel.unit;
}

namespace {

// "22.8 (21.9–24)": median and quartiles.
std::string tableTime(const TimeSpread& spread) {
  if (!std::isfinite(spread.median)) return "–";
  return tableNumber(spread.median) + " (" + tableNumber(spread.low) + "–" + tableNumber(spread.high) + ')';
}

// The value, marked where it is the default.
std::string markedValue(const StudySetting& setting) {
  if (setting.isDefault) return "**" + setting.value + "** (default)";
  return setting.settingDefault ? setting.value + " (default where sampled)" : setting.value;
}

std::string cellText(const std::string& text) {
  return text;
}
std::string cellText(double number) {
  return tableNumber(number);
}

// A row per setting, its value first.
class StudyTable {
 public:
  explicit StudyTable(const QualityStudy& study)
      : study_(study), heads_("| " + std::string(study.quality.label)) {
    for (const StudySetting& setting : study.settings) rows_.push_back("| " + markedValue(setting));
  }

  // A column: `cell` of a setting is a text or a number.
  template <class Cell>
  void add(const std::string& head, const Cell& cell) {
    heads_ += " | " + head;
    rule_ += "---:|";
    for (std::size_t i = 0; i < rows_.size(); ++i) rows_[i] += " | " + cellText(cell(study_.settings[i]));
  }
  void addCost(const std::string& head, const Panel& panel) {
    add(head, [&](const StudySetting& s) { return tableTime(costSpread(study_.quality, s, panel)); });
  }
  // The processor's own time of a frame; no column where none was measured.
  void addProcessor() {
    if (study_.settings.empty() || study_.settings.front().processorTimes.empty()) return;
    add("processor, ms (quartiles)",
        [](const StudySetting& s) { return tableTime(spreadOfTimes(s.processorTimes)); });
  }
  // FLIP and root mean square of the whole picture, in steps of 255; their heads say against what. None where
  // all rows have the same picture: the look does not show what the quality setting changes.
  void addPicture() {
    if (std::ranges::all_of(study_.settings,
                            [](const StudySetting& s) { return s.errors.picture.rms == 0.0; }))
      return;
    const std::string reference = study_.quality.reference;
    add("FLIP to " + (reference.empty() ? "256 rays" : '`' + reference + '`'),
        [](const StudySetting& s) { return tableNumber(s.errors.picture.flip, 2); });
    add("RMS, of 255", [](const StudySetting& s) { return tableNumber(255.0 * s.errors.picture.rms, 2); });
  }

  void write(std::ostream& out) const {
    out << heads_ << " |\n|---|" << rule_ << '\n';
    for (const std::string& row : rows_) out << row << " |\n";
  }

 private:
  const QualityStudy& study_;
  std::string heads_, rule_;
  std::vector<std::string> rows_;
};

void addErrors(StudyTable& table, Measure measure, const Errors& (*errorsIn)(const StudySetting&)) {
  const auto add = [&](const char* head, auto cell) {
    table.add(head, [&](const StudySetting& setting) { return cell(errorsIn(setting)); });
  };
  if (measure == Measure::hits) {
    add("missed pixels", [](const Errors& e) { return std::to_string(e.missed); });
    add("depth RMS, voxels", [](const Errors& e) { return e.depthVoxels.rms; });
    add("largest", [](const Errors& e) { return e.depthVoxels.maximum; });
  } else {
    add("normal RMS, °", [](const Errors& e) { return e.normalDegrees.rms; });
    add("curvature median, %", [](const Errors& e) { return 100.0 * e.curvature.median; });
  }
}

std::string costHead(const Panel& panel) {
  return base::joined(panel.passes, " + ") + ", ms (quartiles)";
}

// Of a field a second table, against `cubic_interpolating`.
void writeSurfaceTables(std::ostream& out, const QualityStudy& study) {
  if (study.normalScaleMm > 0.0 || study.curvatureScaleMm > 0.0)
    out << "At the scales of the scene: normals " << tableNumber(study.normalScaleMm) << " mm, curvature "
        << tableNumber(study.curvatureScaleMm) << " mm.\n\n";
  const auto& panels = panelsOf(study.quality);
  StudyTable table(study);
  table.add("frame, ms", [](const StudySetting& s) { return s.frameMilliseconds; });
  table.addProcessor();
  table.addCost(costHead(panels[0]), panels[0]);
  if (panels[0].passes != panels[1].passes) table.addCost(costHead(panels[1]), panels[1]);
  addErrors(table, study.quality.measure, [](const StudySetting& s) -> const Errors& { return s.errors; });
  table.addPicture();
  table.write(out);
  if (!study.quality.field()) return;
  out << "\nAgainst `cubic_interpolating` in double precision, the field that passes through every "
         "sample:\n\n";
  StudyTable ofField(study);
  addErrors(ofField, study.quality.measure, judged);
  ofField.write(out);
}

// Writes the table of a setting that is judged by the picture alone: rays per pixel, or the shadow.
void writePictureTable(std::ostream& out, const QualityStudy& study) {
  StudyTable table(study);
  table.addCost("frame, ms (quartiles)", panelsOf(study.quality)[0]);
  table.addProcessor();
  if (study.quality.measure == Measure::shadow)
    table.add("shadow, ms (quartiles)", [](const StudySetting& s) {
      const auto found = s.passTimes.find("shadow");
      return found == s.passTimes.end() ? "–" : tableTime(spreadOfTimes(found->second));
    });
  else
    table.add("edges RMS, of 255", [](const StudySetting& s) { return 255.0 * s.errors.picture.edgeRms; });
  table.addPicture();
  table.write(out);
}

std::string percent(double part, int digits = 3) {
  return tableNumber(100.0 * part, digits);
}

std::string withError(const LightErrors& errors, double value, double standardError) {
  return percent(errors.relative(value)) + " ± " + percent(errors.relative(standardError), 2);
}

bool isLight(const QualityStudy& study) {
  return study.quality.measure == Measure::light && !study.settings.empty();
}

// What was compared with what, then a row per value.
void writeLightTable(std::ostream& out, const QualityStudy& study) {
  const QualitySetting& quality = study.quality;
  const Panel& panel = panelsOf(quality)[0];
  const LightErrors& first = study.settings.front().errors.light;
  out << "Against path tracing at " << first.pixels << " pixels, " << study.truthSamples
      << " paths each, at most " << study.truthBounces << (study.truthBounces == 1 ? " bounce" : " bounces")
      << ": mean E " << tableNumber(first.mean, 4) << ", standard error of a pixel "
      << percent(first.relative(first.truthNoise), 2) << " % of it.\n\n";
  StudyTable table(study);
  if (quality.cost == Cost::gpuMegabytes)
    table.add("GPU, MiB", [&](const StudySetting& s) { return costOf(quality, s, panel); });
  else
    table.addCost(quality.cost == Cost::bakeSeconds ? "bake, s (quartiles)" : "lookup, ms (quartiles)",
                  panel);
  const auto add = [&](const char* head, auto text) {
    table.add(head, [&](const StudySetting& s) { return text(s.errors.light); });
  };
  add("RMSE, % of mean E", [](const LightErrors& e) { return withError(e, e.rmse, e.rmseStandardError); });
  add("bias, %", [](const LightErrors& e) { return withError(e, e.bias, e.biasStandardError); });
  add("largest, %", [](const LightErrors& e) { return percent(e.relative(e.maximum)); });
  table.addPicture();
  table.write(out);
}

void writeScaleTable(std::ostream& out, const QualityStudy& study) {
  out << "Noise of deviation " << tableNumber(study.addedNoise) << " data units is added, " << kNoiseSeeds
      << " times. ";
  if (study.knowsTruth)
    out << "Errors are relative to the phantom without noise at scale 0: the effects of noise and of "
           "smoothing.";
  else
    out << "The volume's own noise has that deviation, and its reference is unknown. Errors are the change "
           "due to added noise at the same scale, as between two scans of one object. They exclude the "
           "effect of smoothing on the shape.";
  out << "\n\n";
  StudyTable table(study);
  table.add("scale, mm", [](const StudySetting& s) { return s.scale.value().scaleMm; });
  table.add("field, s", [](const StudySetting& s) { return s.scale.value().buildSeconds; });
  table.addCost("hessian, ms (quartiles)", panelsOf(study.quality)[0]);
  table.add("curvature median, %",
            [](const StudySetting& s) { return 100.0 * s.errors.noise.curvature.median; });
  table.add("normal RMS, °", [](const StudySetting& s) { return s.errors.noise.normalDegrees.rms; });
  table.add("no confidence, %", [](const StudySetting& s) { return 100.0 * s.scale.value().unknown; });
  table.addPicture();
  table.write(out);
}

}  // namespace

void writeQualityTable(std::ostream& out, const QualityStudy& study) {
  const Measure measure = study.quality.measure;
  if (measure == Measure::light) return writeLightTable(out, study);
  if (measure == Measure::scale) return writeScaleTable(out, study);
  if (measure == Measure::edges || measure == Measure::shadow) return writePictureTable(out, study);
  writeSurfaceTables(out, study);
}

void writeLightReach(std::ostream& out, const std::vector<QualityStudy>& studies) {
  if (std::ranges::none_of(studies, isLight)) return;
  const auto& errors = errorsToReach(Measure::light);
  out << "\n## Which setting of light reaches an error\n\nThe cheapest value with at most this RMSE in parts "
         "of the mean irradiance, all other settings as the scene has them.\n\n| setting |";
  for (const double error : errors) out << ' ' << percent(error) << " % |";
  out << "\n|---|---|---|---|\n";
  for (const QualityStudy& study : studies) {
    if (!isLight(study)) continue;
    const Panel& panel = panelsOf(study.quality)[0];
    out << "| `" << study.quality.setting << "` |";
    for (const double error : errors) {
      const StudySetting* const setting = cheapest(study, error);
      if (setting)
        out << " `" << setting->value << "` ("
            << costText(study.quality, costOf(study.quality, *setting, panel)) << ") |";
      else
        out << " none |";
    }
    out << '\n';
  }
}

}  // namespace isolux::app
