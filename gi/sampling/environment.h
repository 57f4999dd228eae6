// Represents distant light, an equirectangular environment map or a constant, and samples it.
//
// In the environment's own frame, +z is up and row 0 of the image is up. The image's middle is towards +y and
// is seen from inside, not mirrored: +x is to the right of the middle. The left edge of column 0 (and the
// right edge of the last) is towards -y. In the world (LPS) and unturned, a viewer in front of a patient sees
// the image's middle behind the patient.
//
// The radiance of a direction is the radiance of its pixel (piecewise constant). A pixel's solid angle is 2
// pi / width * (cos of its upper edge - cos of its lower edge). radiance(), sample(), lookUp(), project() and
// mean() all use this piecewise constant function. Radiance is linear RGB (BT.709), without exposure.
// Densities are per steradian. Directions are unit vectors. Immutable; safe from any thread.
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

#include "gi/sampling/batch.h"

namespace isolux::gi {

class Environment {
 public:
  static Environment constant(glm::dvec3 radiance);
  // Makes an environment of width * height `pixels`, row by row, row 0 up; both are at least 1. Throws
  // Error{memory} for 2^31 pixels or more. Negative values become 0. A pixel with NaN or infinity becomes the
  // mean of its up to 8 finite neighbours, or 0 if none is finite.
  Environment(int width, int height, std::vector<glm::vec3> pixels);
  // Reads any format of OpenImageIO: .hdr, .exr and others of one channel (grey) or more. Decodes integer
  // samples and those marked sRGB from the sRGB curve; ignores alpha. Throws base::Error of kind input,
  // naming file, place and reason, and of kind memory. A sandboxed process parses the file
  // (volume/read/process/foreign.h).
  static Environment load(const std::string& path);

  int width() const { return width_; }
  int height() const { return height_; }
  const std::vector<glm::vec3>& pixels() const { return pixels_; }
  bool isConstant() const { return constant_; }  // every pixel has the same radiance
  bool isBlack() const { return black_; }
  std::size_t badPixels() const { return badPixels_; }  // of the image as given
  std::uint64_t hash() const { return hash_; }          // of size and pixels
  glm::dvec3 mean() const { return mean_; }             // over the sphere

  glm::vec3 radiance(glm::vec3 direction) const { return pixels_[pixelOf(direction).index]; }

  // A direction with density proportional to luminance, uniform within a pixel; if all pixels are black,
  // uniform over the sphere. `u` in [0, 1)^2; neighbouring u give neighbouring directions. The pdf is above
  // 0.
  struct Sample {
    glm::vec3 direction, radiance;
    float pdf;
  };
  Sample sample(glm::vec2 u) const;
  // Returns radiance and density of a direction: that of sample(), above 0 wherever the radiance is.
  Sample lookUp(glm::vec3 direction) const {
    const Pixel pixel = pixelOf(direction);
    return {direction, pixels_[pixel.index], pdfOf(pixel.row, pixel.index)};
  }

  // Returns the tables for sampling in batches (batch.h); valid for the environment's lifetime.
  EnvironmentTables tables() const;

  // Returns the spherical-harmonic coefficients of this order, 1 .. 8 (gi/harmonics/spherical_harmonics.h),
  // integrated exactly over every pixel.
  std::vector<glm::dvec3> project(int order) const;

  // Returns the direction of an image point: column in [0, width], row in [0, height]; a pixel's middle is at
  // + 1/2.
  glm::dvec3 directionOf(double column, double row) const;
  double solidAngle(int row) const;  // of one pixel of this row, sr

 private:
  struct Pixel {
    int row;
    std::size_t index;
  };

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

  // Probabilities are integer multiples of 2^-31, at least one for pixels that are not black, so that samples
  // and densities agree exactly. Row r has [rowStart_[r], rowStart_[r + 1]). Pixels divide a row's columns
  // likewise; the starts are stored, and the last ends at 2^31.
  std::vector<std::uint32_t> rowStart_, columnStart_;
  std::vector<std::uint32_t> rowGuide_, columnGuide_;  // guide_table.h; columns row by row
  std::vector<float> rowDensity_;                      // 2^-62 / solid angle
  std::vector<float> sineSquaredHalf_;  // of the upper edge's angle from the zenith, height + 1
};

// An environment in the world, rotated and scaled. Cheap to copy.
struct Sky {
  std::shared_ptr<const Environment> environment;  // required by all member functions
  glm::mat3 worldFromEnvironment{1.0f};            // a proper rotation
  float scale = 1.0f;                              // of the radiance, at least 0

  Environment::Sample sample(glm::vec2 u) const {
    Environment::Sample s = environment->sample(u);
    s.direction = worldFromEnvironment * s.direction;
    s.radiance *= scale;
    return s;
  }
  Environment::Sample lookUp(glm::vec3 world) const {
    Environment::Sample s = environment->lookUp(world * worldFromEnvironment);  // by the transpose
    s.direction = world;
    s.radiance *= scale;
    return s;
  }
};

// Returns the rotation of a quaternion of any length; that of (0, 0, 0, 0) is the identity. Direction d of
// the environment is worldFromEnvironment(q) * d in the world.
glm::dmat3 worldFromEnvironment(glm::dquat rotation);

}  // namespace isolux::gi
