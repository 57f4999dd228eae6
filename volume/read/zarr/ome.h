// OME-Zarr's multiscales: which arrays are the levels of an image, and where they lie (OME-NGFF 0.1 to 0.5,
// https://ngff.openmicroscopy.org).
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "volume/labels/label_table.h"
#include "volume/read/chunks/array_volume.h"
#include "volume/read/input/length_unit.h"
#include "volume/read/zarr/json_fields.h"

namespace isolux::volume {

struct OmeLevel {
  std::string path;  // of its array, in the folder of the metadata; without ".."
  glm::dvec3 spacingMm{1.0}, originMm{0.0};
  bool placed = false;  // the file says where it begins
};

struct OmeImage {
  std::string version, name;
  ArrayAxes axes;
  std::size_t axisCount = 5;
  std::vector<OmeLevel> levels;              // at least one
  std::shared_ptr<const LabelTable> labels;  // null: they are not said to be
  std::vector<std::string> warnings;
};

// `attributes` of a group: of version 3 those under "ome" are meant, of version 2 all. Nothing where they
// hold no multiscales. Throws base::Error{input}.
std::optional<OmeImage> parseOme(const nlohmann::json& attributes, const std::string& file);

// The folders of a plate's wells; none where the attributes of a group are of no plate. Throws
// base::Error{input}.
std::vector<std::string> wellsOf(const nlohmann::json& attributes, const std::string& file);

// What axes are by their names ("t", "c", "z", "y", "x", and those of CF and MINC; "" is any), else by their
// place: the last are y and x, z before them, then channel and time. Throws base::Error{input} at `place`.
ArrayAxes axesNamed(const std::vector<std::string>& names, const std::vector<std::uint64_t>& dims,
                    const std::string& file, const std::string& place);

}  // namespace isolux::volume
