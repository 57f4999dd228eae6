// The passes of an isosurface picture: a pure function from what is asked to what must be computed.
//
//   blocks    active blocks of the isovalue and the faces between active and inactive ones   (object order)
//   segments  where each ray enters and leaves the active blocks, by rasterising those faces
//   cast      the first crossing of the isovalue on each ray, as a bracket [t0, t1]
//   refine    the surface point: bracket narrowed on the exact trilinear field
//   gradient  world gradient at the surface point, by the field of derivatives.field         (image space)
//   shade     the look, linear colour
//   resolve   supersamples averaged, sRGB encoded
#pragma once

#include <cstdint>

#include "render/frame_graph.h"
#include "scene/scene.h"

namespace isolux::render {

namespace pass {
inline constexpr const char *blocks = "blocks", *segments = "segments", *cast = "cast", *refine = "refine",
                            *gradient = "gradient", *shade = "shade", *resolve = "resolve";
}
namespace image {
inline constexpr const char *activeBlocks = "active blocks", *faces = "block faces",
                            *segments = "ray segments", *bracket = "brackets", *surface = "surface points",
                            *gradient = "gradients", *color = "colour", *picture = "picture";
}

// `volumeHash` identifies the voxels (0: none).
std::vector<PassDeclaration> declarePasses(const scene::Scene& scene, const FrameRequest& request,
                                           std::uint64_t volumeHash);
// The images a request reads in the end.
std::vector<std::string> wantedImages(const FrameRequest& request);

}  // namespace isolux::render
