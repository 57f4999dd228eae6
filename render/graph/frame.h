// Defines the request for a frame and its results: plain values, no GL.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/graph/empty_picture.h"

namespace isolux::render {

// AOVs (arbitrary output variables), float32; NaN where there is no hit (hit: 0).
enum class Aov {
  position,
  voxel,
  depth,
  value_error,
  normal,
  gradient,
  hessian,
  kappa,
  direction1,
  direction2,
  flowline_curvature,
  curvature_confidence,
  scale,
  edge_offset,
  edge_strength,
  color_value,
  label,
  piece,
  irradiance,
  hit
};
struct AovInfo {
  Aov aov;
  const char* name;  // as on the command line
  const char* unit;
  std::vector<const char*> channels;  // suffixes: {"x","y","z"}, {""}
};
const std::vector<AovInfo>& aovs();
// Parses a list such as "position,normal". Throws base::Error{usage} naming the unknown name and the known
// ones.
std::vector<Aov> parseAovList(const std::string& text);

// A part of an image, in pixels from its lower left corner.
struct Tile {
  glm::ivec2 origin{0}, size{0};
  bool operator==(const Tile&) const = default;
};

struct FrameRequest {
  glm::ivec2 size{512, 512};   // pixels, of the whole image
  std::optional<Tile> tile{};  // draw only this part; images read back then have the tile's size
  // Draw a small version of the whole image before its tiles, which take ambient occlusion from it.
  bool beforeTiles = false;
  bool linear = false;  // readLinearPicture() will be called
  // Keep images for the next frame, as far as memory.gpu_budget_mb allows. False: each image is freed after
  // its last reader, and only the requested ones can be read back; the next frame runs all passes.
  bool keepImages = true;
  bool color = true;  // the shaded image
  // The surface points that Renderer::hitVoxels() returns: of at most about a million rays that are spread
  // evenly over the image, or of all.
  enum class Hits { none, many, all } hits = Hits::many;
  std::vector<Aov> aovs{};  // AOVs; requires supersampling 1
  bool asksFor(Aov aov) const { return std::ranges::find(aovs, aov) != aovs.end(); }
  int supersampling = 1;  // rays per pixel and axis, 1..4
  // Image pixels per pixel in settings (look.contour_width, flow.grain, flow.length): 2 on a screen drawn at
  // 200 %.
  double pixelRatio = 1.0;
  // Limits the bytes of bricks uploaded in one frame, if the volume is in bricks; the next frames continue
  // (FrameReport::bricks.pending). 0: the frame takes as long as it needs to be complete.
  std::size_t brickUploadBytes = 0;
  // Limits the bytes of baked lighting uploaded in one frame; the next frames continue
  // (FrameReport::light.pending). 0: no limit.
  std::size_t lightUploadBytes = 0;
  // After a stop request, render() throws Error{interrupted}; the next frame reuses completed results.
  std::stop_token stop = {};
};

// Throws Error{interrupted} after a stop request.
void throwIfStopped(const FrameRequest& request);

enum class PassState { ran, cached, skipped };
const char* nameOf(PassState state);
struct PassReport {
  std::string name;
  PassState state = PassState::skipped;
  std::string reason;         // why it ran or did not
  double milliseconds = 0.0;  // GPU timer if available, else wall time; 0 unless ran
  std::size_t bytes = 0;      // of the images that it writes
  bool onProcessor = false;   // computed on the CPU instead of by a shader (HostSettings::executor)
};

// Statistics of a volume in bricks (memory.layout).
struct BrickReport {
  bool inUse = false;
  std::size_t total = 0;     // of the volume
  std::size_t active = 0;    // with an active block
  std::size_t resident = 0;  // of at most `slots`
  std::size_t slots = 0;
  std::size_t uploaded = 0, evicted = 0;  // in this frame
  // Fraction of the rays that are waiting for a brick; they are drawn hatched.
  double missing = 0.0;
  // Fraction of the rays that ended at an unreadable part of the file; they are drawn hatched, too.
  double lost = 0.0;
  std::size_t lostBricks = 0;  // bricks with unreadable voxels among those that rays have reached
  std::string lostReason;      // the reason for the first of them: one line
  bool pending = false;        // the next frame continues; otherwise the missing bricks do not fit
};

// Statistics of baked lighting (Renderer::setLight) that the frame read.
struct LightReport {
  bool stored = false;
  std::size_t resident = 0, uploaded = 0;  // blocks of the lattices; in this frame
  std::size_t withoutRoom = 0;  // blocks that do not fit into memory.gpu_budget_mb: unshadowed light
  std::size_t bytes = 0;
  bool pending = false;  // the next frame continues
};

// Numbers that the look derives from the curvature of the whole surface; 1/mm (Gaussian curvature: 1/mm^2).
struct CurvatureReport {
  glm::dvec2 range{0.0};            // of the colour map
  glm::dvec2 ridgeThresholds{0.0};  // of ridges, of valleys
};

// Programs of the renderer's context since it was made: those that the driver compiled, and those that the
// cache had (render/gl/program_cache.h).
struct ProgramCounts {
  std::size_t compiled = 0, cached = 0;
};

struct FrameReport {
  std::vector<PassReport> passes;
  double milliseconds = 0.0;  // wall time of the frame, GL finished
  std::size_t blocksActive = 0, blocksTotal = 0;
  BrickReport bricks;
  LightReport light;
  ProgramCounts programs;
  std::optional<CurvatureReport> curvature;
  // The surface points changed since the last completed frame: Renderer::hitVoxels() differs.
  bool surfaceChanged = false;
  std::size_t imageBytes = 0;  // of the passes' images: the most held at the same time in this frame
  std::size_t gpuBytes = 0;    // the same with the textures and buffers of the volume and of baked light
  std::optional<EmptyPicture> empty;  // no surface is visible, and why
  std::optional<Tile> legend;         // its place in the whole image, if it was drawn
  // Values of automatic settings that were derived from the surface, by the paths of
  // scene/settings/settings.h.
  std::map<std::string, double> found;
  // The driver's errors in this frame (render/gl/gl_messages.h): the image may be wrong.
  std::vector<std::string> glErrors;
};

// Row 0 is the top row.
struct ColorImage {
  glm::ivec2 size{0};
  std::vector<std::uint8_t> rgba;  // sRGB; alpha is 255, or straight
  bool transparent = false;        // alpha is used
};
struct AovImage {
  Aov aov{};
  glm::ivec2 size{0};
  int channels = 0;
  std::vector<float> values;  // channels interleaved
};

// The look before the background is added: linear RGBA, premultiplied by opacity, one texel per ray.
struct LinearImage {
  glm::ivec2 size{0};
  std::vector<float> rgba;   // row 0 is the top row
  bool transparent = false;  // as a finished image (Renderer::readLinearPicture): alpha is used
};

}  // namespace isolux::render
