#include "render/passes/pass_declarations.h"

#include <algorithm>

#include "base/hash.h"
#include "render/passes/cut_faces_pass.h"
#include "render/passes/gloss_passes.h"
#include "render/passes/light_passes.h"
#include "render/passes/passes.h"
#include "render/passes/second_volume_pass.h"
#include "scene/rules/needs.h"

namespace isolux::render {

namespace {

template <class... Passes>
PassList listOf() {
  PassList list;
  (list.push_back(std::make_unique<Passes>()), ...);
  return list;
}

// Return whether the AOV depends on derivatives or describes them; readsHessian(): on second derivatives.
bool readsHessian(Aov aov) {
  return aov == Aov::hessian || aov == Aov::kappa || aov == Aov::direction1 || aov == Aov::direction2 ||
         aov == Aov::flowline_curvature || aov == Aov::curvature_confidence;
}

bool readsEdge(Aov aov) {
  return aov == Aov::edge_offset || aov == Aov::edge_strength;
}

bool readsDerivatives(Aov aov) {
  return aov == Aov::normal || aov == Aov::gradient || aov == Aov::irradiance || aov == Aov::scale ||
         readsHessian(aov) || readsEdge(aov) || aov == Aov::color_value;
}

// Where bricks at the hits may have been replaced, what reads voxels there needs its rays cast again: the
// cast depends on all that those passes depend on.
void bringBricksBack(const PassList& passes, const Asked& asked, std::vector<PassDeclaration>& declared) {
  if (!asked.bricks.mayReplace) return;
  const auto cast = std::find_if(declared.begin(), declared.end(),
                                 [](const PassDeclaration& one) { return one.name == pass::cast; });
  const std::vector<bool> used = usedPasses(declared, wantedImages(asked.request, asked.scene));
  std::vector<Parameter> more;
  base::Hasher which;
  for (std::size_t i = 0; i < passes.size(); ++i) {
    if (!passes[i]->kind.atHits) continue;
    which.add(static_cast<bool>(used[i]));
    if (!used[i]) continue;
    for (const Parameter& parameter : declared[i].parameters)
      more.push_back({parameter.name + " at the hits", parameter.hash});
  }
  more.push_back({"what reads voxels at the hits", which});
  cast->parameters.insert(cast->parameters.end(), more.begin(), more.end());
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

std::vector<PassDeclaration> declarePasses(const PassList& passes, const Asked& asked) {
  std::vector<PassDeclaration> declared;
  for (const auto& pass : passes) {
    Declaring d(asked, passes, declared, pass->name);
    pass->declare(d);
    declared.push_back(std::move(d.declared));
  }
  bringBricksBack(passes, asked, declared);
  return declared;
}

std::vector<PassDeclaration> declarePasses(const scene::Scene& scene, const FrameRequest& request,
                                           const VolumeState& volume, const BrickState& bricks,
                                           const LightState& light) {
  return declarePasses(makePasses(), Asked(scene, request, volume, bricks, light));
}

bool readsDerivatives(const scene::Scene& scene, const FrameRequest& request) {
  return (request.color && scene::needsGradient(scene)) ||
         std::any_of(request.aovs.begin(), request.aovs.end(), [](Aov aov) { return readsDerivatives(aov); });
}

bool readsHessian(const scene::Scene& scene, const FrameRequest& request) {
  return (request.color && scene::needsCurvature(scene)) ||
         std::any_of(request.aovs.begin(), request.aovs.end(), [](Aov aov) { return readsHessian(aov); });
}

bool readsEdge(const scene::Scene& scene, const FrameRequest& request) {
  return (request.color && scene::needsEdge(scene)) ||
         std::any_of(request.aovs.begin(), request.aovs.end(), [](Aov aov) { return readsEdge(aov); });
}

bool readsSecond(const scene::Scene& scene, const FrameRequest& request) {
  return (request.color && scene::showsSecondVolume(scene)) || request.asksFor(Aov::color_value);
}

bool sharesGradient(const scene::Scene& scene) {
  return scene::derivativesScale(scene) == scene::normalScale(scene);
}

std::vector<std::string> wantedImages(const FrameRequest& request, const scene::Scene& scene) {
  std::vector<std::string> wanted;
  if (request.color) wanted.emplace_back(image::picture);
  if (!request.aovs.empty()) wanted.emplace_back(image::surface);  // where they are
  for (const Aov aov : request.aovs) {
    if (aov == Aov::irradiance)
      wanted.emplace_back(image::irradiance);
    else if (aov == Aov::normal)
      wanted.emplace_back(image::gradient);
    else if (aov == Aov::gradient)
      wanted.emplace_back(sharesGradient(scene) ? image::gradient : image::tangents);
    else if (aov == Aov::hessian)
      wanted.emplace_back(image::hessian);
    else if (readsHessian(aov)) {
      wanted.emplace_back(image::curvature);
      if (aov == Aov::direction2) wanted.emplace_back(image::tangents);
    } else if (readsEdge(aov)) {
      wanted.emplace_back(image::edge);
    } else if (aov == Aov::color_value) {
      wanted.emplace_back(image::second);
    } else if (aov == Aov::piece) {
      wanted.emplace_back(image::piece);
    }
  }
  return wanted;
}

}  // namespace isolux::render
