#include "render/passes/pass_declarations.h"

#include <algorithm>

#include "base/hash.h"
#include "render/passes/passes.h"
#include "scene/rules/needs.h"

namespace isolux::render {

namespace {

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
    if (!passes[i].kind.atHits) continue;
    which.add(static_cast<bool>(used[i]));
    if (!used[i]) continue;
    for (const Parameter& parameter : declared[i].parameters)
      more.push_back({parameter.name + " at the hits", parameter.hash});
  }
  more.push_back({"what reads voxels at the hits", which});
  cast->parameters.insert(cast->parameters.end(), more.begin(), more.end());
}

}  // namespace

PassList makePasses() {
  PassList list;
  for (PassList (*const passes)() :
       {hitPasses, derivativePasses, effectPasses, linePasses, lightPasses, lookPasses, resolvePasses})
    std::ranges::move(passes(), std::back_inserter(list));
  return list;
}

std::vector<PassDeclaration> declarePasses(const PassList& passes, const Asked& asked) {
  std::vector<PassDeclaration> declared;
  for (const Pass& pass : passes) {
    Declaring d(asked, passes, declared, pass.name);
    pass.declare(d);
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
    } else if (aov == Aov::label) {
      wanted.emplace_back(image::label);
    } else if (aov == Aov::piece) {
      wanted.emplace_back(image::piece);
    }
  }
  return wanted;
}

}  // namespace isolux::render
