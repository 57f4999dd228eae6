#include "app/study/study_plot.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "app/process/gnuplot.h"
#include "app/process/study_plot_script.h"

namespace isolux::app {

namespace {

constexpr std::string_view kTruth = "cubic_interpolating";

std::string costLabel(const Knob& knob, const Panel& panel) {
  switch (knob.cost) {
    case Cost::bakeSeconds:
      return "time to bake what the view shows, s";
    case Cost::gpuMegabytes:
      return "light on the graphics card, MiB";
    case Cost::passes:
    case Cost::lookupMilliseconds:
      break;
  }
  std::string passes;
  for (const char* const pass : panel.passes) passes += (passes.empty() ? "" : " + ") + std::string(pass);
  return "time of " + passes + ", ms";
}

// The height of "no error" on a logarithmic axis: below every error that is not 0.
double heightOfZero(const KnobStudy& study, const Panel& panel) {
  double least = 1.0;
  for (const StudySetting& setting : study.settings)
    for (const Errors* errors : {&setting.errors, &judged(setting)})
      if (const double error = panel.error(*errors); error > 0.0) least = std::min(least, error);
  return 0.3 * least;
}

void row(std::ostream& out, const Knob& knob, const StudySetting& setting, const Errors& errors,
         const std::array<double, 2>& zeros) {
  const auto& panels = panelsOf(knob);
  out << setting.value << '\t' << (setting.isDefault ? 1 : 0);
  for (std::size_t p = 0; p < panels.size(); ++p) {
    const double error = panels[p].error(errors);
    out << '\t' << costOf(knob, setting, panels[p]) << '\t';
    if (std::isfinite(error))
      out << std::max(error, zeros[p]);
    else
      out << "NaN";
  }
  // The standard error of the first panel.
  if (setting.light) out << '\t' << errors.light.relative(errors.light.rmseStandardError);
  out << '\n';
}

// A panel without any point is none.
bool hasPoints(const KnobStudy& study, const Panel& panel) {
  return std::any_of(study.settings.begin(), study.settings.end(), [&](const StudySetting& setting) {
    return std::isfinite(panel.error(setting.errors)) || std::isfinite(panel.error(judged(setting)));
  });
}

}  // namespace

std::string plotScript(const KnobStudy& study, const std::string& subject, const std::string& picture) {
  const Knob& knob = study.knob;
  const auto& panels = panelsOf(knob);
  const std::array<double, 2> zeros{heightOfZero(study, panels[0]), heightOfZero(study, panels[1])};
  std::ostringstream own, other;  // a knob has exact hits beside it, or other errors, or neither
  bool comparison = false, fields = false;
  for (const StudySetting& setting : study.settings) {
    row(setting.comparison ? other : own, knob, setting, setting.errors, zeros);
    // Its own truth: the same point again.
    if (setting.fieldErrors && setting.value != kTruth)
      row(other, knob, setting, *setting.fieldErrors, zeros);
    comparison = comparison || setting.comparison;
    fields = fields || setting.fieldErrors.has_value();
  }
  std::ostringstream out;
  out << "picture = " << gnuplotText(picture)
      << "\ntitle = " << gnuplotText(std::string(knob.setting) + " of " + subject)
      << "\nseries = " << gnuplotText(knob.field ? "against the same field" : knob.label)
      << "\njoined = " << (knob.sampled || knob.ordered) << "\nbars = " << (knob.measure == Measure::light)
      << "\ncomparison = " << comparison << "\nfields = " << fields << "\narray xlabels[2] = ["
      << gnuplotText(costLabel(knob, panels[0])) << ", " << gnuplotText(costLabel(knob, panels[1]))
      << "]\narray ylabels[2] = [" << gnuplotText(panels[0].label) << ", " << gnuplotText(panels[1].label)
      << "]\narray zeros[2] = [" << zeros[0] << ", " << zeros[1] << "]\n$data << END_OF_DATA\n";
  out << own.str() << "\n\n" << other.str();
  out << "END_OF_DATA\n" << studyPlotScript;
  return out.str();
}

bool writePlot(const std::filesystem::path& gnuplot, const KnobStudy& study, const std::string& subject,
               const std::filesystem::path& picture, base::Progress& progress, std::string& reason) {
  for (const Panel& panel : panelsOf(study.knob))
    if (!hasPoints(study, panel)) {
      reason = std::string("no pixel has a ") + panel.label;
      return false;
    }
  const auto failure = drawPlot(
      gnuplot, picture, [&](const std::string& to) { return plotScript(study, subject, to); }, progress);
  reason = failure.value_or("");
  return !failure;
}

}  // namespace isolux::app
