// What a picture is asked for and what comes back: plain values, no GL.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/empty_picture.h"

namespace isolux::render {

// Deferred images (arbitrary output variables). float32; NaN where there is no hit (hit: 0).
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
  curvature_confidence,
  scale,
  edge_offset,
  edge_strength,
  color_value,
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
// Throws base::Error{usage} naming the unknown name and the known ones. "position,normal" -> list.
std::vector<Aov> parseAovList(const std::string& text);

// A part of a picture, pixels from its lower left corner.
struct Tile {
  glm::ivec2 origin{0}, size{0};
  bool operator==(const Tile&) const = default;
};

struct FrameRequest {
  glm::ivec2 size{512, 512};  // pixels, of the whole picture
  std::optional<Tile> tile;   // draw this part only; what is read back then has the tile's size
  // A small picture of the whole, before its tiles are drawn: they take from it what keeps light away.
  bool beforeTiles = false;
  bool linear = false;    // readLinearPicture() will be asked for
  bool color = true;      // the shaded picture
  std::vector<Aov> aovs;  // deferred images; then supersampling must be 1
  int supersampling = 1;  // rays per pixel and axis, 1..4
  // Pixels of the picture per pixel that settings mean (look.contour_width, flow.grain, flow.length): 2 on a
  // screen that is drawn at 200 %.
  double pixelRatio = 1.0;
  // Bricks uploaded in one frame, where the volume is in bricks; the next frames go on
  // (FrameReport::bricks.pending). 0: the frame takes as long as it takes to be complete.
  std::size_t brickUploadBytes = 0;
  // Stored light uploaded in one frame; the next frames go on (FrameReport::light.pending). 0: all of it.
  std::size_t lightUploadBytes = 0;
  // Once asked, render() throws Error{interrupted}; what is complete until then is kept for the next picture.
  std::stop_token stop = {};
};

// Throws Error{interrupted} once a stop is asked for.
void throwIfStopped(const FrameRequest& request);

enum class PassState { ran, cached, skipped };
const char* nameOf(PassState state);
struct PassReport {
  std::string name;
  PassState state = PassState::skipped;
  std::string reason;         // why it ran, or why not
  double milliseconds = 0.0;  // GPU timer where there is one, else wall time; 0 unless ran
  std::size_t bytes = 0;      // of the images it writes
  bool onProcessor = false;   // computed by the processor instead of a shader (Machine::executor)
};

// Of a volume in bricks (memory.layout).
struct BrickReport {
  bool inUse = false;
  std::size_t total = 0;     // of the volume
  std::size_t active = 0;    // hold an active block
  std::size_t resident = 0;  // of at most `slots`
  std::size_t slots = 0;
  std::size_t uploaded = 0, evicted = 0;  // in this frame
  // Of the rays: those that wait for a brick. They are drawn hatched.
  double missing = 0.0;
  // Of the rays: those that ended where the file cannot be read. They are drawn hatched, too.
  double lost = 0.0;
  std::size_t lostBricks = 0;  // of which something cannot be read, as far as any ray has come to them
  std::string lostReason;      // of the first of them: one line
  bool pending = false;        // the next frame gets further; otherwise what is missing does not fit
};

// Of stored light (Renderer::setLight), as far as the frame read it.
struct LightReport {
  bool stored = false;
  std::size_t resident = 0, uploaded = 0;  // blocks of the lattices; in this frame
  std::size_t withoutRoom = 0;             // blocks that do not fit into memory.gpu_budget_mb: local light
  std::size_t bytes = 0;
  bool pending = false;  // the next frame gets further
};

// What the look takes from the surface's curvature as a whole, where it reads any; 1/mm (Gaussian curvature:
// 1/mm^2).
struct CurvatureReport {
  glm::dvec2 range{0.0};            // of the colours that stand for numbers
  glm::dvec2 ridgeThresholds{0.0};  // of ridges, of valleys
};

struct FrameReport {
  std::vector<PassReport> passes;
  double milliseconds = 0.0;  // wall time of the frame, GL finished
  std::size_t blocksActive = 0, blocksTotal = 0;
  BrickReport bricks;
  LightReport light;
  std::optional<CurvatureReport> curvature;
  // Surface points were found anew since the last picture that was completed: Renderer::hitVoxels() differ.
  bool surfaceChanged = false;
  std::size_t gpuBytes = 0;           // textures and buffers held by the renderer
  std::optional<EmptyPicture> empty;  // nothing is to be seen, and why
  std::optional<Tile> legend;         // where it stands in the whole picture, if it was drawn
  // Settings that were automatic and followed the surface, and what they were: paths of scene/settings.h.
  std::map<std::string, double> found;
  // What the driver called an error in this frame (render/gl/gl_messages.h): the picture may be wrong.
  std::vector<std::string> glErrors;
};

// Row 0 is the top row.
struct ColorImage {
  glm::ivec2 size{0};
  std::vector<std::uint8_t> rgba;  // sRGB; alpha is 255, or straight
  bool transparent = false;        // alpha counts
};
struct AovImage {
  Aov aov{};
  glm::ivec2 size{0};
  int channels = 0;
  std::vector<float> values;  // channels interleaved
};

// The look before the background lies behind it: linear RGBA, premultiplied by opacity, one texel per ray.
struct LinearImage {
  glm::ivec2 size{0};
  std::vector<float> rgba;   // row 0 is the top row
  bool transparent = false;  // as a finished picture (Renderer::readLinearPicture): alpha counts
};

}  // namespace isolux::render
