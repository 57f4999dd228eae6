#include "app/study/study_plot.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <system_error>

#include "app/files/files.h"
#include "app/process/external_program.h"
#include "app/study/study_plot_script.h"

namespace isolux::app {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kTruth = "cubic_interpolating";

// A word of gnuplot: within single quotes only the quote itself is special.
std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("''") : std::string(1, c == '\n' ? ' ' : c);
  return out + "'";
}

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

// gnuplot does not look whether its output could be written.
bool isWholeSvg(const fs::path& file) {
  constexpr std::size_t longest = std::size_t{64} << 20;
  const std::string text = readTextFile(file, longest);
  const std::size_t end = text.find_last_not_of(" \n\r\t");
  return end != std::string::npos && std::string_view(text).substr(0, end + 1).ends_with("</svg>");
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
  out << "picture = " << quoted(picture)
      << "\ntitle = " << quoted(std::string(knob.setting) + " of " + subject)
      << "\nseries = " << quoted(knob.field ? "against the same field" : knob.label)
      << "\njoined = " << (knob.sampled || knob.ordered) << "\nbars = " << (knob.measure == Measure::light)
      << "\ncomparison = " << comparison << "\nfields = " << fields << "\narray xlabels[2] = ["
      << quoted(costLabel(knob, panels[0])) << ", " << quoted(costLabel(knob, panels[1]))
      << "]\narray ylabels[2] = [" << quoted(panels[0].label) << ", " << quoted(panels[1].label)
      << "]\narray zeros[2] = [" << zeros[0] << ", " << zeros[1] << "]\n$data << END_OF_DATA\n";
  out << own.str() << "\n\n" << other.str();
  out << "END_OF_DATA\n" << studyPlotScript;
  return out.str();
}

bool writePlot(const fs::path& gnuplot, const KnobStudy& study, const std::string& subject,
               const fs::path& picture, base::Progress& progress, std::string& reason) {
  for (const Panel& panel : panelsOf(study.knob))
    if (!hasPoints(study, panel)) {
      reason = std::string("no pixel has a ") + panel.label;
      return false;
    }
  PendingFile plot(picture);
  base::OutputFile script(fs::path(picture).replace_extension(".gp"));  // never committed: removed after use
  script.write(plotScript(study, subject, fs::absolute(plot.path()).string()));
  script.finish();
  const ProgramResult result =
      runProgram(gnuplot, {fs::absolute(script.path()).string()}, picture.parent_path(), progress);
  if (result.exitCode == 0 && isWholeSvg(plot.path())) {
    plot.commit();
    return true;
  }
  reason = result.exitCode == 0 ? "the plot is not whole (is the disk full?)" : result.output;
  while (!reason.empty() && std::isspace(static_cast<unsigned char>(reason.back()))) reason.pop_back();
  reason = reason.substr(reason.rfind('\n') + 1);
  if (result.exitCode != 0) reason = "gnuplot failed: " + reason;
  return false;
}

}  // namespace isolux::app
