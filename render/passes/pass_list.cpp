#include "render/passes/pass_list.h"

#include "render/passes/cut_faces_pass.h"
#include "render/passes/derivative_passes.h"
#include "render/passes/effect_passes.h"
#include "render/passes/gloss_passes.h"
#include "render/passes/hit_passes.h"
#include "render/passes/light_passes.h"
#include "render/passes/line_passes.h"
#include "render/passes/look_passes.h"
#include "render/passes/piece_pass.h"
#include "render/passes/resolve_passes.h"
#include "render/passes/second_volume_pass.h"

namespace isolux::render {

namespace {

template <class... Passes>
PassList listOf() {
  PassList list;
  (list.push_back(std::make_unique<Passes>()), ...);
  return list;
}

}  // namespace

// clang-format off
PassList makePasses() {
  return listOf<
      BlocksPass,      // active blocks of the isovalues, and the faces around them
      SegmentsPass,    // where each ray enters them
      BricksPass,      // uploads of what the rays of the frame before asked for
      CutFacesPass,    // where rays meet what cuts lay open
      CastPass,        // the first crossing on each ray
      RefinePass,      // the surface point of a sampled hit
      GradientPass,    // world gradient at the surface point
      HessianPass,     // the same with the world Hessian
      CurvaturePass,   // principal curvatures, first direction, confidence
      EdgePass,        // how far the edge of the object lies from it
      SecondVolumePass,  // values of the volume that colours the surface
      PiecePass,       // which connected piece each surface point is of
      RangesPass,      // the surface's curvature as a whole
      ShadowPass,      // a second ray to the key light
      OpennessPass,    // how much of the directions around is free, by a part of them
      OcclusionPass,   // by all
      FlowFieldPass,   // direction on screen and noise on the surface
      FlowPass,        // streaks along it
      ExtremaPass,     // how principal curvatures change along their directions
      LineFieldPass,   // where lines of curvature run
      LinesPass,       // what is drawn of them
      LightPass,       // uploads of stored light
      IrradiancePass,  // light at the surface points
      ReflectionsPass,  // what glossy surfaces reflect, at some points
      ShadePass,       // the look, linear colour, of the first crossing
      LayersPass,      // the crossings behind transparent surfaces
      BackgroundPass,  // the picture of nothing
      ResolvePass      // background, supersamples averaged, sRGB, legend
      >();
}
// clang-format on

}  // namespace isolux::render
