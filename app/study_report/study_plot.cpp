#include "app/study_report/study_plot.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <sstream>

#include "app/runtime/gnuplot.h"
#include "app/runtime/study_plot_script.h"
#include "base/words.h"

namespace isolux::app {

namespace {

constexpr std::string_view kTruth = "cubic_interpolating";

std::string costLabel(const QualitySetting& quality, const Panel& panel) {
  if (quality.cost == Cost::frameMilliseconds) return "time of a frame, ms";
  if (quality.cost == Cost::bakeSeconds) return "bake time of the visible part, s";
  if (quality.cost == Cost::gpuMegabytes) return "light on the graphics card, MiB";
  return "time of " + base::joined(panel.passes, " + ") + ", ms";
}

// "Paths per texel: head"
std::string titleOf(const QualitySetting& quality, const std::string& subject) {
  std::string title = quality.label;
  title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
  return title + ": " + subject;
}

// Of a logarithmic axis of errors.
struct ErrorAxis {
  double bottom = 0.01, top = 1.0;  // powers of ten
  bool zeros = false;               // some error is 0: drawn at the bottom, which then no other reaches
};

ErrorAxis axisOf(const QualityStudy& study, const Panel& panel) {
  double least = std::numeric_limits<double>::infinity(), most = 0.0;
  ErrorAxis axis;
  for (const StudySetting& setting : study.settings)
    for (const Errors* errors : {&setting.errors, &judged(setting)}) {
      const double error = panel.error(*errors);
      axis.zeros = axis.zeros || error == 0.0;
      if (!(error > 0.0)) continue;
      least = std::min(least, error);
      most = std::max(most, error);
    }
  if (most == 0.0) return axis;
  axis.bottom = std::pow(10.0, std::floor(std::log10(least / (axis.zeros ? 3.0 : 1.5))));
  axis.top = std::pow(10.0, std::ceil(std::log10(2.0 * most)));
  return axis;
}

void row(std::ostream& out, const QualitySetting& quality, const StudySetting& setting, const Errors& errors,
         const std::string& label) {
  out << label << '\t' << (setting.isDefault ? 1 : 0);
  for (const Panel& panel : panelsOf(quality)) {
    const TimeSpread cost = costSpread(quality, setting, panel);
    out << '\t' << cost.median << '\t' << cost.low << '\t' << cost.high << '\t';
    if (const double error = panel.error(errors); std::isfinite(error))
      out << error;
    else
      out << "NaN";
  }
  // The standard error of the first panel.
  if (setting.light) out << '\t' << errors.light.relative(errors.light.rmseStandardError);
  out << '\n';
}

// A panel without any point is none.
bool hasPoints(const QualityStudy& study, const Panel& panel) {
  return std::ranges::any_of(study.settings, [&](const StudySetting& setting) {
    return std::isfinite(panel.error(setting.errors)) || std::isfinite(panel.error(judged(setting)));
  });
}

}  // namespace

std::string plotScript(const QualityStudy& study, const std::string& subject, const std::string& picture) {
  const QualitySetting& quality = study.quality;
  const auto& panels = panelsOf(quality);
  const std::array<ErrorAxis, 2> axes{axisOf(study, panels[0]), axisOf(study, panels[1])};
  std::ostringstream own, other;  // a quality setting has exact hits beside it, or other errors, or neither
  bool comparison = false, fields = false;
  for (const StudySetting& setting : study.settings) {
    row(setting.comparison ? other : own, quality, setting, setting.errors, setting.value);
    // Its own truth: the same point again, whose label stands there.
    if (setting.fieldErrors)
      row(other, quality, setting, *setting.fieldErrors, setting.value == kTruth ? "" : setting.value);
    comparison = comparison || setting.comparison;
    fields = fields || setting.fieldErrors.has_value();
  }
  std::ostringstream out;
  out << "picture = " << gnuplotText(picture) << "\ntitle = " << gnuplotText(titleOf(quality, subject))
      << "\nseries = " << gnuplotText(quality.field() ? "against the same field" : "each value")
      << "\njoined = " << (quality.sampled() || quality.ordered())
      << "\nbars = " << (quality.measure == Measure::light) << "\ncomparison = " << comparison
      << "\nfields = " << fields << "\narray xlabels[2] = [" << gnuplotText(costLabel(quality, panels[0]))
      << ", " << gnuplotText(costLabel(quality, panels[1])) << "]\narray ylabels[2] = ["
      << gnuplotText(panels[0].label) << ", " << gnuplotText(panels[1].label) << "]\narray bottoms[2] = ["
      << axes[0].bottom << ", " << axes[1].bottom << "]\narray tops[2] = [" << axes[0].top << ", "
      << axes[1].top << "]\nzeros = " << (axes[0].zeros || axes[1].zeros) << "\n$data << END_OF_DATA\n";
  out << own.str() << "\n\n" << other.str();
  out << "END_OF_DATA\n" << studyPlotScript;
  return out.str();
}

bool writePlot(const std::filesystem::path& gnuplot, const QualityStudy& study, const std::string& subject,
               const std::filesystem::path& picture, base::Progress& progress, std::string& reason) {
  for (const Panel& panel : panelsOf(study.quality))
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
