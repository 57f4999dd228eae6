// What a mark says: numbers with errors and units, notes, and lines to draw; as text, JSON and CSV.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>
#include <nlohmann/json_fwd.hpp>

#include "scene/scene.h"

namespace isolux::app {

struct MarkQuantity {
  std::string name;  // "straight", "kappa1": docs/reference/outputs.md lists them
  double value = 0.0;
  std::optional<double> error;  // the same unit; nothing where none is known
  std::string unit;             // "mm", "HU"; empty: a plain number
};

struct MarkReport {
  std::vector<MarkQuantity> quantities;  // the first is said where there is room for one only
  std::string place;                     // of a point: "L 12.3, P 4.5, S 6.7 mm"
  std::vector<std::string> notes;        // what makes the numbers doubtful: a point that left the surface
  std::string problem;                   // why there are no numbers; empty: there are
  std::vector<glm::dvec3> line;          // world mm: the way along the surface, the ray through the inside
  std::optional<glm::dvec3> centre;      // of a circle, with its normal, and of the ball of a thickness
  glm::dvec3 normal{0.0};
  bool pending = false;  // it is being computed
};

// "92.31 ± 0.22 mm": digits as far as the error has them.
std::string quantityText(const MarkQuantity& quantity);
// The first quantity, the problem, or "…".
std::string summaryText(const MarkReport& report);
// All of it, a line each.
std::string fullText(const scene::Mark& mark, const MarkReport& report);

// {"name", "kind", "points_mm", "quantities": {NAME: {"value", "error", "unit"}}, "notes", "problem",
// "path_mm"}.
nlohmann::ordered_json markJson(const scene::Mark& mark, const MarkReport& report);
// A row for each quantity: mark, kind, points_mm, quantity, value, error, unit, notes. RFC 4180.
std::string marksCsv(std::span<const scene::Mark> marks, std::span<const MarkReport> reports);

}  // namespace isolux::app
