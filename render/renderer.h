// Draws a Scene: the one renderer behind the window, `isolux render` and replay.
//
// The renderer owns its GL objects and does not depend on a window. It keeps no GL state between frames and
// changes only its own framebuffers. All members require the context to be current on the calling thread.
// Throws base::Error{graphics, memory}.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gi/picture_light.h"
#include "gi/visible_point_set.h"
#include "render/graph/frame.h"
#include "scene/scene.h"
#include "scene/settings/host_settings.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::render {

struct Gl;
class Texture;

class Renderer {
 public:
  explicit Renderer(const std::shared_ptr<const Gl>& gl);
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  // Sets the GPU memory for volumes and light, the layout of volumes there, and the device that computes hits
  // and derivatives. Takes effect at the next render().
  void setHostSettings(const scene::HostSettings& host);

  // Sets the volume, which the next render() uploads. Null: only the background is drawn.
  void setVolume(std::shared_ptr<const volume::PreparedVolume> volume);

  // Sets the light of the next frames. Null: the light is unknown, and looks that read it show a neutral sky.
  // A bake may go on filling its lattices; each render() uses the light baked so far.
  void setLight(std::shared_ptr<const gi::PictureLight> light);

  // Renders a frame. Requires a resolved `scene` (scene::resolve). Chooses automatic settings of derivatives
  // here unless that was done before (volume/prepared/derivative_choices.h: takes long). Computes only
  // results that `request` needs and that changed since the last call.
  const FrameReport& render(const scene::Scene& scene, const FrameRequest& request);

  // Discards the results of earlier frames, so that the next render() runs every pass it needs (benchmarks).
  void invalidate();

  // Returns the bytes that images of the passes may take: of memory.gpu_budget_mb, or of main memory with a
  // software driver.
  std::size_t imageBudget() const;

  ColorImage readColor();
  // Returns the shaded image where it is: RGBA8, bottom row first, valid until the next render().
  const Texture& color() const;
  LinearImage readLinear();
  // Returns the image as linear float32, not clamped, without legend and dither, at the requested size. It
  // includes the background, averages supersamples and has alpha 1. With picture.transparent, it has no
  // background and values are premultiplied. Requires a request with `linear`.
  LinearImage readLinearPicture();
  AovImage readAov(Aov aov);
  // Returns the visible surface points of the last frame whose light is baked, in voxel coordinates, as many
  // as its request says. They include those behind transparent surfaces if the look reads baked lighting and
  // the frame is shaded. Pixels without a surface are omitted.
  gi::VisiblePointSet hitVoxels();
  // Returns a hash of the images of each pass that the last frame needed, computed or cached, for tests.
  // Passes without images are omitted.
  std::map<std::string, std::uint64_t> imageHashes();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace isolux::render
