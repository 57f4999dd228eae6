// The Scene: everything that decides a picture, as one plain value.
//
// Widgets, --set, sessions, undo and recordings all edit Scenes; nothing else holds state that changes a
// picture. Each member is listed once in scene/settings.cpp with its path, default, range, unit and meaning;
// JSON, --set, undo, hashing and the documentation come from that list.
//
// World space is millimetres, DICOM/LPS (+x patient left, +y posterior, +z superior). Colours are linear
// RGB (ITU-R BT.709 primaries) in [0, 1]. An empty optional means "automatic": scene::resolve() in
// scene/automatic.h fills it in from the volume.
#pragma once

#include <optional>
#include <string>

#include <glm/vec3.hpp>

namespace isolux::scene {

enum class Inside { above, below };       // inside is f >= isovalue, or f <= isovalue
enum class HitMethod { sampled, exact };  // Hadwiger et al. 2005 sec. 3.2, or every cell's first root
enum class DerivativeField { trilinear, cubic, cubic_interpolating };
enum class LookMode { blinn_phong, lambert, normal, depth };
enum class Projection { perspective, orthographic };

struct Source {
  std::string path = "phantom:head";  // file, folder, or "phantom:NAME[:SIZE]"
  std::string raw;     // how to read a raw file: "WxHxD TYPE [little|big] [spacing x,y,z] [header BYTES]"
  std::string series;  // DICOM SeriesInstanceUID, empty: the series with most slices
  int component = 0;   // of a file with several components per voxel; -1: their magnitude
  int timeStep = 0;    // of a file with several time steps
  bool operator==(const Source&) const = default;
};

struct Isosurface {
  std::optional<double> value;  // data units
  Inside inside = Inside::above;
  glm::dvec3 albedo{0.70, 0.62, 0.50};
  bool operator==(const Isosurface&) const = default;
};

struct Hit {
  HitMethod method = HitMethod::exact;
  double rate = 2.0;    // samples per voxel along the ray (method sampled)
  int refinements = 4;  // regula falsi steps after a sampled hit, Hadwiger et al. 2005 eq. (1)
  bool operator==(const Hit&) const = default;
};

struct Derivatives {
  DerivativeField field = DerivativeField::cubic;
  bool operator==(const Derivatives&) const = default;
};

struct Look {
  LookMode mode = LookMode::blinn_phong;
  double ambient = 0.12;
  double specular = 0.2;
  double shininess = 50.0;
  glm::dvec3 backgroundTop{0.10, 0.12, 0.15};
  glm::dvec3 backgroundBottom{0.02, 0.02, 0.03};
  bool operator==(const Look&) const = default;
};

struct Light {
  // Toward the light, in camera axes (right, up, toward the viewer); need not have unit length.
  glm::dvec3 direction{-0.5, 0.7, 0.9};
  double intensity = 1.0;
  bool operator==(const Light&) const = default;
};

struct Camera {
  std::optional<glm::dvec3> eye;     // mm
  std::optional<glm::dvec3> target;  // mm
  std::optional<glm::dvec3> up;      // any length, not along the view direction
  double fov = 30.0;  // vertical, degrees; the orthographic height is that of the target's distance
  Projection projection = Projection::perspective;
  bool operator==(const Camera&) const = default;
};

struct Picture {
  int supersampling = 2;  // rays per pixel and axis of a picture at rest
  bool operator==(const Picture&) const = default;
};

struct Memory {
  int gpuBudgetMb = 2048;
  bool operator==(const Memory&) const = default;
};

struct Scene {
  Source source;
  Isosurface isosurface;
  Hit hit;
  Derivatives derivatives;
  Look look;
  Light light;
  Camera camera;
  Picture picture;
  Memory memory;
  bool operator==(const Scene&) const = default;
};

}  // namespace isolux::scene
