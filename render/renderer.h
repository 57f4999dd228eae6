// Draws a Scene: the one renderer behind the window, `isolux render` and replay.
//
// The renderer owns its GL objects and knows no window. It keeps no GL state between frames and touches no
// framebuffer that it does not own.
// All members need the context current on the calling thread. Errors: base::Error{graphics, memory}.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gi/picture_light.h"
#include "gi/seen_points.h"
#include "render/graph/frame.h"
#include "scene/machine.h"
#include "scene/scene.h"
#include "volume/prepared_volume.h"

namespace isolux::render {

struct Gl;

class Renderer {
 public:
  explicit Renderer(const std::shared_ptr<const Gl>& gl);
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  // What volumes and light may take of the graphics card, how volumes lie there, and what computes hits and
  // derivatives. From the next render() on.
  void setMachine(const scene::Machine& machine);

  // Uploads at the next render(). Null: the background only.
  void setVolume(std::shared_ptr<const volume::PreparedVolume> volume);

  // The light of the next pictures; null: nobody has said what it is, and looks that read it show a neutral
  // sky. Its lattices may go on being filled; each render() takes what is there.
  void setLight(std::shared_ptr<const gi::PictureLight> light);

  // `scene` must be resolved (scene::resolve). What is automatic about derivatives is chosen here where
  // nobody has done so (volume/statistics/derivative_choices.h: takes long). Only what `request` needs is
  // computed; what has not changed since the last call is not computed again.
  const FrameReport& render(const scene::Scene& scene, const FrameRequest& request);

  // Forgets what earlier frames computed, so that the next render() runs every pass it needs (benchmarks).
  void invalidate();

  ColorImage readColor();
  LinearImage readLinear();
  // The picture as linear float32, not clamped, without legend and dither, one pixel per pixel: the
  // background behind the look, supersamples averaged, alpha 1; with picture.transparent premultiplied, and
  // nothing behind. After a request that has `linear`.
  LinearImage readLinearPicture();
  AovImage readAov(Aov aov);
  // Voxel coordinates of the surface points of the last picture, those behind transparent surfaces too where
  // the look reads stored light; about a million at most of the first crossings and of
  // those behind, spread evenly over the picture. Pixels without one are left out. `everyRay`: of first
  // crossings all.
  gi::SeenPoints hitVoxels(bool everyRay = false);
  // A hash of what each pass that the last picture needed holds in its images, drawn anew or kept: what tests
  // compare. Passes that hold none are left out.
  std::map<std::string, std::uint64_t> imageHashes();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace isolux::render
