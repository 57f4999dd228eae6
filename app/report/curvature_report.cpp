#include "app/report/curvature_report.h"

#include <algorithm>
#include <sstream>

#include <nlohmann/json.hpp>

#include "app/runtime/curvature_plot_script.h"
#include "app/runtime/external_program.h"
#include "app/runtime/gnuplot.h"
#include "base/error.h"
#include "base/number_text.h"
#include "scene/looks.h"

namespace isolux::app {

namespace {

using nlohmann::ordered_json;
using volume::CurvatureDistribution;
using volume::CurvatureHistogram;

std::string plainUnit(const CurvatureHistogram& histogram) {
  const int dimension = scene::lookInfo(histogram.measure).dimension;
  return dimension == 2 ? "1/mm^2" : dimension == 1 ? "1/mm" : "";
}

std::string percent(double part, double whole) {
  return base::shortText(whole > 0.0 ? 100.0 * part / whole : 0.0, 3) + " %";
}

ordered_json histogramJson(const CurvatureHistogram& histogram) {
  return {{"unit", plainUnit(histogram)},
          {"area_mm2", histogram.areaMm2},
          {"mean", histogram.mean},
          {"deviation", histogram.deviation},
          {"quantiles",
           {{"5_percent", histogram.low5},
            {"25_percent", histogram.low25},
            {"median", histogram.median},
            {"75_percent", histogram.high75},
            {"95_percent", histogram.high95}}},
          {"histogram",
           {{"low", histogram.low},
            {"step", histogram.step},
            {"area_mm2", histogram.areasMm2},
            {"clear_area_mm2", histogram.clearMm2},
            {"below_mm2", histogram.belowMm2},
            {"above_mm2", histogram.aboveMm2}}}};
}

double lowOfBin(const CurvatureHistogram& histogram, std::size_t bin) {
  return histogram.low + static_cast<double>(bin) * histogram.step;
}

// What of the measures a plot has: columns as resources/plots/curvature.gp reads them.
void appendPlotData(const CurvatureHistogram& histogram, std::ostream& out) {
  for (std::size_t bin = 0; bin < histogram.areasMm2.size(); ++bin) {
    const double share = histogram.areaMm2 > 0.0 ? 100.0 / histogram.areaMm2 : 0.0;
    out << lowOfBin(histogram, bin) + 0.5 * histogram.step << '\t' << share * histogram.areasMm2[bin] << '\t'
        << share * histogram.clearMm2[bin] << '\n';
  }
  if (histogram.areasMm2.empty()) out << "0\t0\t0\n";
  out << "\n\n";
}

std::string scriptOf(const CurvatureDistribution& curvature, const std::string& title,
                     const std::string& picture) {
  std::ostringstream names, medians, lows, steps, highs, data;
  const char* comma = "";
  for (const CurvatureHistogram& histogram : curvature.measures) {
    const scene::LookInfo& look = scene::lookInfo(histogram.measure);
    const bool empty = histogram.areasMm2.empty();
    std::string name(look.quantity);
    if (const std::string_view unit = scene::unitOf(look); !unit.empty()) name += ", " + std::string(unit);
    names << comma << gnuplotText(name);
    medians << comma << histogram.median;
    lows << comma << (empty ? -1.0 : histogram.low);
    steps << comma << (empty ? 1.0 : histogram.step);
    highs << comma << (empty ? 1.0 : lowOfBin(histogram, histogram.areasMm2.size()));
    appendPlotData(histogram, data);
    comma = ", ";
  }
  std::ostringstream out;
  out << "picture = " << gnuplotText(picture) << "\ntitle = " << gnuplotText(title) << "\narray names[6] = ["
      << names.str() << "]\narray medians[6] = [" << medians.str() << "]\narray lows[6] = [" << lows.str()
      << "]\narray steps[6] = [" << steps.str() << "]\narray highs[6] = [" << highs.str()
      << "]\n$data << END_OF_DATA\n"
      << data.str() << "END_OF_DATA\n"
      << curvaturePlotScript;
  return out.str();
}

}  // namespace

ordered_json curvatureJson(const CurvatureDistribution& curvature) {
  ordered_json json{{"scale_mm", curvature.scaleMm},
                    {"noise_per_mm", curvature.noise},
                    {"area_mm2", curvature.areaMm2},
                    {"clear_area_mm2", curvature.clearMm2},
                    {"unknown_area_mm2", curvature.unknownMm2},
                    {"mean_curvature_integral_mm", curvature.meanIntegralMm},
                    {"gaussian_curvature_integral", curvature.gaussianIntegral}};
  for (const CurvatureHistogram& histogram : curvature.measures)
    json["measures"][std::string(scene::lookInfo(histogram.measure).name)] = histogramJson(histogram);
  return json;
}

void printCurvature(const ordered_json& curvature, std::ostream& out) {
  const double area = curvature["area_mm2"].get<double>(), clear = curvature["clear_area_mm2"].get<double>(),
               unknown = curvature["unknown_area_mm2"].get<double>();
  out << "curvature     at a scale of " << base::shortText(curvature["scale_mm"].get<double>(), 3)
      << " mm; noise makes " << base::shortText(curvature["noise_per_mm"].get<double>(), 2) << " 1/mm of it, "
      << percent(clear, area) << " of the area is clear of that";
  if (unknown > 0.0) out << "; " << percent(unknown, area + unknown) << " is not known";
  out << "\n                          mean  deviation        5 %     median       95 %\n";
  const auto column = [&out](const ordered_json& number) {
    const std::string text = base::shortText(number.get<double>(), 4);
    out << std::string(text.size() < 11 ? 11 - text.size() : 1, ' ') << text;
  };
  for (const auto& [name, measure] : curvature["measures"].items()) {
    const ordered_json& quantiles = measure["quantiles"];
    out << "  " << name << std::string(17 - std::min<std::size_t>(name.size(), 17), ' ');
    for (const ordered_json& number : {measure["mean"], measure["deviation"], quantiles["5_percent"],
                                       quantiles["median"], quantiles["95_percent"]})
      column(number);
    out << "  " << measure["unit"].get<std::string>() << '\n';
  }
}

std::string curvatureTable(const CurvatureDistribution& curvature) {
  std::ostringstream out;
  out << "measure,unit,low,high,area_mm2,clear_area_mm2\n";
  for (const CurvatureHistogram& histogram : curvature.measures) {
    const std::string begin =
        std::string(scene::lookInfo(histogram.measure).name) + "," + plainUnit(histogram) + ",";
    const auto row = [&](const std::string& low, const std::string& high, double area,
                         const std::string& clear) {
      out << begin << low << ',' << high << ',' << base::shortestText(area) << ',' << clear << '\n';
    };
    const std::size_t bins = histogram.areasMm2.size();
    const auto end = [&](std::size_t bin) { return base::shortText(lowOfBin(histogram, bin), 12); };
    if (histogram.belowMm2 > 0.0) row("-inf", end(0), histogram.belowMm2, "");
    for (std::size_t bin = 0; bin < bins; ++bin)
      row(end(bin), end(bin + 1), histogram.areasMm2[bin], base::shortestText(histogram.clearMm2[bin]));
    if (histogram.aboveMm2 > 0.0) row(end(bins), "inf", histogram.aboveMm2, "");
  }
  return out.str();
}

void requireGnuplot(const std::filesystem::path& picture) {
  if (findProgram("gnuplot").empty())
    base::throwInput(picture, "", "a plot needs gnuplot, which was not found (Debian: gnuplot-nox)");
}

void plotCurvature(const CurvatureDistribution& curvature, const std::string& title,
                   const std::filesystem::path& picture, base::Progress& progress) {
  requireGnuplot(picture);
  const auto failure = drawPlot(
      findProgram("gnuplot"), picture, [&](const std::string& to) { return scriptOf(curvature, title, to); },
      progress);
  if (failure) base::throwInput(picture, "", *failure);
}

}  // namespace isolux::app
