// Light from far away: an equirectangular image (a light probe) or a constant, and its samples.
//
// Own frame of the environment: +z up. Row 0 of the image is up. The middle of the image looks to +y, and the
// image is seen from inside as it is, not mirrored: to the right of the middle is +x; the left edge of column
// 0 (and the right edge of the last) looks to -y. In the world (LPS) and unturned, a viewer in front of a
// patient sees the middle of the image behind them.
//
// The radiance is piecewise constant: that of the pixel a direction falls in, whose solid angle is
// 2 pi / width * (cos of its upper edge - cos of its lower edge). radiance(), sample(), pdf(), project() and
// mean() all are of this one function. Radiance is linear RGB (BT.709), without exposure. Densities are per
// steradian. Directions are unit vectors. Immutable; any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <glm/ext/quaternion_double.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "base/progress.h"
#include "gi/sampling/batch.h"

namespace isolux::gi {

class Environment {
 public:
  static Environment constant(glm::dvec3 radiance);
  // `pixels` row by row, row 0 up, width * height of them, both at least 1. Throws Error{memory} of 2^31.
  // Negative values become 0; a pixel with NaN or infinity becomes the mean of its up to 8 neighbours
  // without, or 0 where there are none.
  static Environment fromImage(int width, int height, std::vector<glm::vec3> pixels);
  // Whatever OpenImageIO reads: .hdr, .exr and others of one channel (grey) or more. Integer samples and
  // those marked sRGB are decoded from the sRGB curve. Alpha is left out. Throws base::Error of kind input,
  // naming file, place and reason, and of kind memory. The file is parsed in a process of its own
  // (volume/read/process/foreign.h).
  static Environment load(const std::string& path);
  static Environment load(const std::string& path, base::Progress& progress);  // Error{interrupted}, too

  int width() const { return width_; }
  int height() const { return height_; }
  const std::vector<glm::vec3>& pixels() const { return pixels_; }
  bool isConstant() const { return constant_; }  // every pixel has the same radiance
  bool isBlack() const { return black_; }
  std::size_t badPixels() const { return badPixels_; }  // of the image as given
  std::uint64_t hash() const { return hash_; }          // of size and pixels
  glm::dvec3 mean() const { return mean_; }             // over the sphere

  glm::vec3 radiance(glm::vec3 direction) const { return pixels_[pixelOf(direction).index]; }

  // A direction with density proportional to luminance, even within a pixel; where all is black, even over
  // the sphere. `u` in [0, 1)^2; neighbouring u give neighbouring directions. The pdf is above 0.
  struct Sample {
    glm::vec3 direction, radiance;
    float pdf;
  };
  Sample sample(glm::vec2 u) const;
  // The density of sample(): above 0 wherever the radiance is.
  float pdf(glm::vec3 direction) const;
  // Radiance and density of a direction at once.
  Sample lookUp(glm::vec3 direction) const {
    const Pixel pixel = pixelOf(direction);
    return {direction, pixels_[pixel.index], pdfOf(pixel.row, pixel.index)};
  }

  // For many at once (batch.h); they live as long as the environment.
  EnvironmentTables tables() const;

  // Spherical-harmonic coefficients of this order, 1 .. 8 (gi/harmonics/spherical_harmonics.h), integrated
  // exactly over every pixel.
  std::vector<glm::dvec3> project(int order) const;

  // Where a point of the image looks: column in [0, width], row in [0, height], a pixel's middle at + 1/2.
  glm::dvec3 directionOf(double column, double row) const;
  double solidAngle(int row) const;  // of one pixel of this row, sr

 private:
  struct Pixel {
    int row;
    std::size_t index;
  };

  Environment(int width, int height, std::vector<glm::vec3> pixels);
  void repair();
  void sumUp();
  void buildDistribution();
  Pixel pixelOf(glm::vec3 direction) const;
  float pdfOf(int row, std::size_t index) const;

  int width_, height_;
  std::vector<glm::vec3> pixels_;
  bool constant_ = false, black_ = false;
  std::size_t badPixels_ = 0;
  std::uint64_t hash_ = 0;
  glm::dvec3 mean_{0.0};

  // Probabilities are whole numbers of 2^-31, at least one for what is not black, so that the samples drawn
  // and the densities told agree exactly. Row r has [rowStart_[r], rowStart_[r + 1]); a pixel has its part of
  // the row's columns likewise, of which the starts are kept and the end of the last is 2^31.
  std::vector<std::uint32_t> rowStart_, columnStart_;
  std::vector<std::uint32_t> rowGuide_, columnGuide_;  // guide_table.h; of the columns row after row
  std::vector<float> rowDensity_;                      // 2^-62 / solid angle
  std::vector<float> sineSquaredHalf_;  // of the upper edge's angle from the zenith, height + 1
};

// An environment in the world: turned and scaled. Cheap to copy.
struct Sky {
  std::shared_ptr<const Environment> environment;  // never null where a member function is called
  glm::mat3 worldFromEnvironment{1.0f};            // a proper rotation
  float scale = 1.0f;                              // of the radiance, at least 0

  glm::vec3 radiance(glm::vec3 world) const {
    return scale * environment->radiance(world * worldFromEnvironment);  // by the transpose
  }
  Environment::Sample sample(glm::vec2 u) const {
    Environment::Sample s = environment->sample(u);
    s.direction = worldFromEnvironment * s.direction;
    s.radiance *= scale;
    return s;
  }
  float pdf(glm::vec3 world) const { return environment->pdf(world * worldFromEnvironment); }
  Environment::Sample lookUp(glm::vec3 world) const {
    Environment::Sample s = environment->lookUp(world * worldFromEnvironment);
    s.direction = world;
    s.radiance *= scale;
    return s;
  }
};

// The rotation of a quaternion of any length above 0; that of (0, 0, 0, 0) is the identity. What the
// environment has in direction d is seen in the world in worldFromEnvironment(q) * d.
glm::dmat3 worldFromEnvironment(glm::dquat rotation);

}  // namespace isolux::gi
