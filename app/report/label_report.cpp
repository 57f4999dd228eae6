#include "app/report/label_report.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/report/notes.h"
#include "base/color.h"
#include "volume/labels/label_table.h"
#include "volume/statistics/label_map.h"

namespace isolux::app {

namespace {

using nlohmann::ordered_json;

constexpr std::size_t kLabelRows = 20;

// "#dd8844", as screens show it.
std::string hexColor(const ordered_json& linear) {
  std::string text = "#";
  for (const ordered_json& channel : linear) {
    char digits[3];
    std::snprintf(digits, sizeof(digits), "%02x",
                  static_cast<unsigned>(base::screenByte(channel.get<double>())));
    text += digits;
  }
  return text;
}

}  // namespace

ordered_json labelTableJson(const volume::PreparedVolume& prepared, base::Progress& progress) {
  if (prepared.kind.kind != scene::DataKind::labels) return nullptr;
  const volume::Volume& v = prepared.volume;
  std::map<std::int64_t, ordered_json> voxels;  // null: not counted
  if (v.labelTable)
    for (const volume::Label& label : v.labelTable->labels) voxels[label.value] = nullptr;
  if (v.grid->isWhole()) {
    for (auto& [label, count] : voxels) count = 0;
    const auto counts = volume::valueCounts(*v.grid, volume::kMostStatedLabels, progress);
    if (counts)
      for (const auto& [value, count] : *counts) voxels[static_cast<std::int64_t>(value)] = count;
  }
  voxels.erase(0);
  ordered_json list = ordered_json::array();
  for (const auto& [label, count] : voxels) {
    const glm::vec3 color = volume::labelColor(v.labelTable.get(), label);
    list.push_back({{"label", label},
                    {"name", volume::labelName(v.labelTable.get(), label)},
                    {"color", {color.x, color.y, color.z}},
                    {"voxels", count}});
  }
  return {{"reason", prepared.kind.reason},
          {"names_from", v.labelTable ? v.labelTable->source : ""},
          {"list", std::move(list)}};
}

void printLabelTable(const ordered_json& labels, std::ostream& out) {
  const ordered_json& list = labels["list"];
  const std::string from = labels["names_from"].get<std::string>();
  printRow(out, "labels", std::to_string(list.size()) + (from.empty() ? "" : ", names from " + from));
  for (std::size_t i = 0; i < std::min(list.size(), kLabelRows); ++i) {
    const ordered_json& label = list[i];
    const std::string name = label["name"].get<std::string>();
    const std::string voxels = label["voxels"].is_null()
                                   ? ""
                                   : ", " + std::to_string(label["voxels"].get<std::size_t>()) + " voxels";
    printRow(out, "",
             std::to_string(label["label"].get<std::int64_t>()) + (name.empty() ? "" : " " + name) + voxels +
                 ", " + hexColor(label["color"]));
  }
  if (list.size() > kLabelRows)
    printRow(out, "", std::to_string(list.size() - kLabelRows) + " more; --json lists all");
}

}  // namespace isolux::app
