// Declares the passes, and what they share with each other. render/passes/pass_declarations.cpp lists them in
// their order.
#pragma once

#include "render/passes/frame_state.h"
#include "render/passes/gloss_passes.h"

namespace isolux::render {

// Return the passes of a kind, in their order.
PassList hitPasses();         // surface points on rays
PassList derivativePasses();  // derivatives, curvature and other values at surface points, once per pixel
PassList effectPasses();      // shadow, occlusion and flow at surface points, once per pixel
PassList linePasses();        // lines that follow the surface's curvature, in image space
PassList lightPasses();       // light at surface points (render/passes/light_passes.h)
PassList lookPasses();        // linear colour from surface points and their derivatives
PassList resolvePasses();     // the final image from linear colour

// Determines the connected component of its isosurface that each surface point belongs to (volume/pieces).
// Writes ids as of volume::Pieces of that isosurface, 0 the largest; -1 if there is no surface. Always runs
// on the CPU. Ids are floats: those of 2^24 and more are rounded.
Pass piecePass();

// Computes automatic numbers from the curvature of the volume's whole surface; independent of the view.
Pass rangesPass();

// Declares that a pass reads an image of each group of surfaces.
void readsOfGroups(Declaring& d, const char* image);

Target& surfaceTarget(FrameState& frame);  // returns the images of image::surface, to draw into
bool anyHit(FrameState& frame);            // returns whether there is any surface point

// Return the defines for shaders that cast rays, and set the inputs of trace.glsl and trace_cubic.glsl: view,
// volume, isovalues, block masks, hidden components. Texture units 0, 1, 3, 14.
std::string traceDefines(const FrameState& frame);
void setTrace(FrameState& frame, Program& program);

// Returns the rays per axis of a cell of occlusion; 1 in the small image before tiles.
int occlusionCell(const FrameRequest& request);
// Returns the image's size in cells.
glm::ivec2 occlusionCells(const FrameRequest& request);

// Returns how many pixels around one decide which lines it shows.
double reachOfLines(const scene::Scene& scene, int heightInRays);

// Holds what the shade pass makes of settings and reuses between frames.
struct LookTextures {
  Texture colors;  // the colour map's samples, and the look they were made from
  scene::Look colorsOf;
  Texture secondColors;  // of the second volume
  scene::ColorMap secondColorsOf = scene::ColorMap::automatic;
  GlossUniforms gloss;
  Texture crevices;  // of look.accessibility_points
  std::optional<std::vector<scene::ColorPoint>> crevicesOf;
};

}  // namespace isolux::render
