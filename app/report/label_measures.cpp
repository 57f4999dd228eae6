#include "app/report/label_measures.h"

#include <cstddef>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/files/csv_field.h"
#include "app/files/json_text.h"
#include "app/report/measure_report.h"
#include "app/report/notes.h"
#include "app/report/piece_report.h"
#include "base/error.h"
#include "base/number_text.h"
#include "base/printable.h"
#include "volume/measure/label_measure.h"
#include "volume/prepared/prepared_labels.h"
#include "volume/read/input/spacing_reliability.h"

namespace isolux::app {

namespace {

using nlohmann::ordered_json;

ordered_json labelJson(const volume::LabelMeasure& label, const volume::LabelTable* names) {
  return {{"label", label.label},
          {"name", volume::labelName(names, label.label)},
          {"voxels", label.voxels},
          {"counted_mm3", label.countedMm3},
          {"volume_mm3", measuredJson(label.volumeMm3)},
          {"area_mm2", measuredJson(label.areaMm2)},
          {"thin_share", static_cast<double>(label.thinVoxels) / static_cast<double>(label.voxels)},
          {"bounds_mm", {label.bounds.lowMm, label.bounds.highMm}},
          {"pieces", label.pieces},
          {"open", label.meetsBorder}};
}

std::vector<std::string> labelRow(const ordered_json& label) {
  const double share = 100.0 * label["thin_share"].get<double>();
  return {std::to_string(label["label"].get<int>()),
          base::printable(label["name"].get<std::string>()),
          std::to_string(label["voxels"].get<std::size_t>()),
          base::shortText(label["counted_mm3"].get<double>(), 8),
          withErrorText(label["volume_mm3"]),
          withErrorText(label["area_mm2"]),
          base::shortText(share, 2) + " %",
          std::to_string(label["pieces"].get<std::size_t>()) + (label["open"].get<bool>() ? " open" : ""),
          boundsText(label["bounds_mm"])};
}

}  // namespace

ordered_json labelMeasuresJson(const volume::PreparedVolume& prepared, const std::string& file,
                               double smoothing, bool anyway, base::Progress& progress) {
  const auto doubt = volume::spacingDoubt(prepared.volume.warnings);
  if (doubt && !anyway)
    base::throwInput(file, "", "lengths are doubtful: " + *doubt + "; --anyway measures all the same");
  const auto blocks = labelBlocksOf(prepared, file, progress);
  ordered_json json{{"smoothing_voxels", smoothing}};
  if (doubt) json["doubt"] = *doubt;
  json["labels"] = ordered_json::array();
  for (const volume::LabelMeasure& label : measureLabels(*blocks, smoothing, progress))
    json["labels"].push_back(labelJson(label, prepared.volume.labelTable.get()));
  return json;
}

void printLabelMeasures(const ordered_json& json, std::ostream& out) {
  printRow(out, "labels", std::to_string(json["labels"].size()));
  printRow(out, "smoothing", base::shortText(json["smoothing_voxels"].get<double>()) + " voxels");
  std::vector<std::vector<std::string>> rows{
      {"label", "name", "voxels", "counted mm^3", "smooth mm^3", "area mm^2", "thin", "pieces", "bounds mm"}};
  for (const ordered_json& label : json["labels"]) rows.push_back(labelRow(label));
  printTable(out, rows);
}

std::string labelMeasuresCsv(const ordered_json& json) {
  std::string text =
      "label,name,voxels,counted_mm3,volume_mm3,volume_error_mm3,area_mm2,area_error_mm2,thin_share,pieces,"
      "open,"
      "low_x_mm,low_y_mm,low_z_mm,high_x_mm,high_y_mm,high_z_mm\n";
  const auto add = [&](const ordered_json& number) {
    text += ',' + base::shortestText(number.get<double>());
  };
  for (const ordered_json& label : json["labels"]) {
    text += std::to_string(label["label"].get<int>()) + ',' + csvWords(label["name"].get<std::string>()) +
            ',' + std::to_string(label["voxels"].get<std::size_t>());
    add(label["counted_mm3"]);
    for (const char* measured : {"volume_mm3", "area_mm2"}) {
      add(label[measured]["value"]);
      add(label[measured]["error"]);
    }
    add(label["thin_share"]);
    text += ',' + std::to_string(label["pieces"].get<std::size_t>());
    text += label["open"].get<bool>() ? ",1" : ",0";
    for (const ordered_json& corner : label["bounds_mm"])
      for (const ordered_json& number : corner) add(number);
    text += '\n';
  }
  return text;
}

}  // namespace isolux::app
