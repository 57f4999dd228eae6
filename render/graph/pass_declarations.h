// The passes of an isosurface picture: a pure function from what is asked to what must be computed.
//
//   blocks     active blocks of the isovalues and the faces between active and inactive ones  (object order)
//   segments   where each ray enters and leaves the active blocks, by rasterising those faces
//   bricks     uploads of the bricks that the rays of the frame before asked for; none in a volume of one
//   texture cast       the first crossing of an isovalue on each ray: the surface point, or for sampled hits
//   a bracket [t0, t1] refine     the surface point of a sampled hit: bracket narrowed on the exact field of
//   hit.field gradient   world gradient at the surface point, by the field of derivatives.field (image space)
//   hessian    the same with the world Hessian, from the same samples: runs instead where second derivatives
//              are read
//   curvature  principal curvatures, first direction, confidence
//   ranges     the surface's curvature as a whole, from the volume: numbers that are automatic   (no view)
//   shadow     a second ray from each surface point to the key light
//   flow field direction on screen and noise on the surface;  flow: streaks along it
//   light      uploads of stored light that changed since the last frame
//   irradiance stored light, looked up at the surface points; local light where nothing is stored
//   shade      the look, linear colour, of the first crossing
//   layers     the crossings behind transparent surfaces: cast to shade again for each, front to back
//   resolve    background, supersamples averaged, sRGB encoded, legend
#pragma once

#include <cstdint>

#include "render/graph/frame_graph.h"
#include "scene/scene.h"

namespace isolux::render {

namespace pass {
inline constexpr const char *blocks = "blocks", *segments = "segments", *bricks = "bricks", *cast = "cast",
                            *refine = "refine", *gradient = "gradient", *hessian = "hessian",
                            *curvature = "curvature", *ranges = "ranges", *shadow = "shadow",
                            *flowField = "flow field", *flow = "flow", *light = "light",
                            *irradiance = "irradiance", *shade = "shade", *layers = "layers",
                            *resolve = "resolve";
}
// Of the resolve pass, where a request asks for it: the picture before it is encoded.
inline constexpr const char* kLinearPicture = "linear picture";
namespace image {
inline constexpr const char *activeBlocks = "active blocks", *faces = "block faces",
                            *segments = "ray segments", *bricks = "resident bricks", *bracket = "brackets",
                            *surface = "surface points", *gradient = "gradients", *hessian = "Hessians",
                            *curvature = "curvatures", *ranges = "curvature ranges", *shadow = "shadows",
                            *flowField = "flow fields", *flow = "streaks", *light = "stored light",
                            *irradiance = "irradiances", *front = "front colour", *color = "colour",
                            *picture = "picture";
}

// What a look reads.
struct LookNeeds {
  bool gradient = false;
  bool curvature = false;
  bool ranges = false;  // numbers from the surface's curvature as a whole
  bool shadow = false;
  bool flow = false;
  bool light = false;  // irradiance at the surface points
};
LookNeeds needsOf(const scene::Scene& scene);
// Colours stand for numbers: kappas, mean, Gaussian, shape index, curvedness, and the (kappa1, kappa2)
// square.
bool isMeasure(scene::LookMode mode);
bool showsLegend(const scene::Scene& scene);
// Where the pattern of the flow stands in its period, [0, 1).
double flowPhase(const scene::Flow& flow);
// Some surface lets through what lies behind it.
bool isTransparent(const scene::Scene& scene);

// The image comes from second derivatives.
bool readsHessian(Aov aov);

// The volume, as far as passes depend on it. Images that show the same voxels stay good when the GPU's copy
// of them is made anew; what lives in that copy (active blocks, resident bricks) does not: its passes depend
// on `made` too.
struct VolumeState {
  VolumeState(std::uint64_t hashOfVoxels = 0, std::uint64_t copiesMade = 0)  // NOLINT: a hash is a volume
      : hash(hashOfVoxels), made(copiesMade) {}
  std::uint64_t hash;   // of the voxels and where they lie; 0: none
  std::uint64_t made;   // differs between any two GpuVolumes of one renderer
  bool crossed = true;  // false: no cell holds a value of a surface that is shown
};

// A volume in bricks, as far as passes depend on it.
struct BrickState {
  bool inUse = false;
  bool mayReplace = false;  // not all bricks fit: those at the hits may be gone when they are wanted again
  std::uint64_t made = 0;   // how often the cache was made
  std::uint64_t asked = 0;  // changes when rays ask for bricks that the next frame can give
};

// The light of a picture (gi::PictureLight), as far as passes depend on it.
struct LightState {
  bool stored = false;        // there is a lattice, and the frame reads it
  std::uint64_t storage = 0;  // changes when other lattices, or other contents of them, are held
  std::uint64_t skyRevision = 0, lampsRevision = 0;  // of the lattices
  std::uint64_t unfinished = 0;                      // changes with each frame that has left uploads over
  std::uint64_t version = 0;                         // of all but the lattices; 0: nobody has said what it is
  float automaticExposure = 0.0f;                    // stops
  bool background = false;                           // the environment is there to be seen
};

std::vector<PassDeclaration> declarePasses(const scene::Scene& scene, const FrameRequest& request,
                                           const VolumeState& volumeState, const BrickState& bricks = {},
                                           const LightState& light = {});
// The images a request reads in the end. An opaque picture has no layers pass: shade writes its colour.
std::vector<std::string> wantedImages(const FrameRequest& request);

}  // namespace isolux::render
