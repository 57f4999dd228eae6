#include "render/graph/pass_declarations.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>

#include "render/passes/curvature_ranges.h"
#include "scene/rules/relevance.h"

namespace isolux::render {

namespace {

// FNV-1a over the bytes of plain values.
class Hasher {
 public:
  template <class T>
  Hasher& add(const T& value) {
    static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
    unsigned char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    for (const unsigned char byte : bytes) hash_ = (hash_ ^ byte) * 0x100000001b3ull;
    return *this;
  }
  Hasher& add(const glm::dvec3& v) { return add(v.x).add(v.y).add(v.z); }
  template <class T>
  Hasher& add(const std::optional<T>& v) {
    return v ? add(true).add(*v) : add(false);
  }
  operator std::uint64_t() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325ull;
};

}  // namespace

bool isTransparent(const scene::Scene& scene) {
  const auto between = [](double opacity) { return opacity > 0.0 && opacity < 1.0; };
  const auto transparent = [&](const scene::ExtraIsosurface& extra) {
    return extra.shown && between(extra.opacity);
  };
  return between(scene.isosurface.opacity) || transparent(scene.isosurface2) ||
         transparent(scene.isosurface3) || transparent(scene.isosurface4);
}

namespace {

bool isPlain(const scene::Scene& scene) {  // shows a raw quantity, with nothing laid over it
  return scene.look.mode == scene::LookMode::normal || scene.look.mode == scene::LookMode::depth;
}

bool needsCurvature(const scene::Scene& scene) {
  using scene::LookMode;
  const scene::Look& look = scene.look;
  if (isPlain(scene)) return false;
  return (look.mode >= LookMode::kappa1 && look.mode <= LookMode::accessibility) ||
         look.accessibility > 0.0 || look.ridges > 0.0 || look.contours > 0.0 ||
         look.suggestiveContours > 0.0 || scene::showsFlow(scene);
}

}  // namespace

bool isMeasure(scene::LookMode mode) {
  return mode >= scene::LookMode::kappa1 && mode <= scene::LookMode::curvature_2d;
}

bool showsLegend(const scene::Scene& scene) {
  return scene.look.legend && isMeasure(scene.look.mode);
}

LookNeeds needsOf(const scene::Scene& scene) {
  LookNeeds needs;
  needs.gradient = scene.look.mode != scene::LookMode::depth;
  needs.curvature = needsCurvature(scene);
  needs.ranges = readsCurvatureRanges(scene);
  const scene::Shading shading = scene::shadingOf(scene);
  needs.light = shading == scene::Shading::gi;
  needs.shadow = scene.look.shadow > 0.0 && scene::keyLightActs(scene);
  needs.flow = scene::showsFlow(scene);
  return needs;
}

double flowPhase(const scene::Flow& flow) {
  const double passes = flow.time * flow.speed;
  return passes - std::floor(passes);
}

namespace {

// A setting is a parameter only where it acts: each group is added where the look has it.
void addLight(Hasher& hash, const scene::Scene& scene) {
  const scene::Look& look = scene.look;
  const scene::Light& light = scene.light;
  const scene::Shading shading = scene::shadingOf(scene);
  hash.add(shading);
  if (shading == scene::Shading::unlit || shading == scene::Shading::gi) return;
  hash.add(light.space).add(light.direction).add(scene::keyLightActs(scene) ? look.shadow : 0.0);
  if (shading == scene::Shading::tone) {
    hash.add(look.toneCool).add(look.toneWarm);
    return;
  }
  hash.add(look.ambient)
      .add(look.ambientVariation)
      .add(light.color)
      .add(light.intensity)
      .add(light.headlight);
  if (shading == scene::Shading::blinn_phong) hash.add(look.specular).add(look.shininess);
}

void addMeasure(Hasher& hash, const scene::Look& look) {
  if (!isMeasure(look.mode)) return;
  hash.add(look.rangeLow).add(look.rangeHigh);
  if (look.mode != scene::LookMode::curvature_2d) {
    hash.add(look.colormap);
    return;
  }
  for (const scene::CurvaturePoint& point : look.curvaturePoints)
    hash.add(point.kappa1).add(point.kappa2).add(point.color);
}

void addLines(Hasher& hash, const scene::Look& look, double pixelRatio) {
  hash.add(look.accessibility).add(look.ridges).add(look.contours).add(look.suggestiveContours);
  if (look.ridges > 0.0) hash.add(look.ridgeThreshold).add(look.ridgeColor).add(look.valleyColor);
  if (look.contours > 0.0 || look.suggestiveContours > 0.0)
    hash.add(look.contourWidth).add(pixelRatio).add(look.contourColor);
}

std::uint64_t lookHash(const scene::Scene& scene, double pixelRatio) {
  const scene::Look& look = scene.look;
  Hasher hash;
  hash.add(look.mode);
  if (needsOf(scene).gradient) hash.add(scene.isosurface.inside);
  if (isPlain(scene)) return hash;
  addLight(hash, scene);
  addMeasure(hash, look);
  addLines(hash, look, pixelRatio);
  hash.add(look.texture);
  if (look.texture != scene::SolidTexture::none) hash.add(look.textureScale);
  hash.add(look.fog);
  if (look.fog > 0.0) hash.add(look.fogColor);
  if (look.fog > 0.0 && !look.fogColor) hash.add(look.backgroundTop).add(look.backgroundBottom);
  hash.add(scene.flow.strength);
  return hash;
}

std::uint64_t legendHash(const scene::Scene& scene) {
  Hasher hash;
  hash.add(showsLegend(scene));
  if (!showsLegend(scene)) return hash;
  hash.add(scene.look.mode);
  addMeasure(hash, scene.look);
  return hash;
}

// What the shadow ray depends on but where it starts.
std::uint64_t shadowHash(const scene::Scene& scene) {
  Hasher hash;
  hash.add(scene.light.space).add(scene.light.direction).add(scene.isosurface.opacity >= 1.0);
  for (const scene::ExtraIsosurface* extra : {&scene.isosurface2, &scene.isosurface3, &scene.isosurface4})
    hash.add(extra->opacity >= 1.0);
  return hash;
}

bool readsGradient(Aov aov) {
  return aov == Aov::normal || aov == Aov::gradient || aov == Aov::irradiance;
}

std::uint64_t sizeHash(const FrameRequest& request) {
  Hasher hash;
  hash.add(request.size.x).add(request.size.y).add(request.supersampling);
  if (request.tile)
    hash.add(request.tile->origin.x)
        .add(request.tile->origin.y)
        .add(request.tile->size.x)
        .add(request.tile->size.y);
  return hash;
}

std::uint64_t isovaluesHash(const scene::Scene& scene) {
  Hasher hash;
  hash.add(scene.isosurface.value.value_or(0.0)).add(scene.isosurface.opacity > 0.0);
  for (const scene::ExtraIsosurface* extra : {&scene.isosurface2, &scene.isosurface3, &scene.isosurface4})
    if (extra->shown && extra->opacity > 0.0) hash.add(extra->value.value_or(0.0));
  return hash;
}

// How the surfaces look, apart from where they are.
std::uint64_t surfacesHash(const scene::Scene& scene) {
  Hasher hash;
  const scene::Isosurface& first = scene.isosurface;
  const bool colored = !isPlain(scene) && !isMeasure(scene.look.mode);
  const bool mapped = colored && first.albedoSource == scene::AlbedoSource::map;
  hash.add(first.opacity).add(mapped);
  if (mapped)
    hash.add(first.albedoMap).add(first.albedoLow).add(first.albedoHigh).add(isovaluesHash(scene));
  else if (colored)
    hash.add(first.albedo);
  for (const scene::ExtraIsosurface* extra : {&scene.isosurface2, &scene.isosurface3, &scene.isosurface4}) {
    if (!extra->shown) continue;
    hash.add(extra->opacity);
    if (colored && !mapped) hash.add(extra->albedo);
  }
  return hash;
}

}  // namespace

std::vector<PassDeclaration> declarePasses(const scene::Scene& scene, const FrameRequest& request,
                                           const VolumeState& volumeState, const BrickState& bricks,
                                           const LightState& light) {
  const scene::Look& look = scene.look;
  const Parameter volume{"volume", Hasher().add(volumeState.hash)};
  const Parameter copy{"graphics copy of the volume", Hasher().add(volumeState.made)};
  const Parameter isovalue{"isovalue", Hasher().add(isovaluesHash(scene)).add(volumeState.crossed)};
  const Parameter camera{"camera", Hasher()
                                       .add(scene.camera.eye)
                                       .add(scene.camera.target)
                                       .add(scene.camera.up)
                                       .add(scene.camera.fov)
                                       .add(scene.camera.projection)};
  const Parameter size{"picture size", sizeHash(request)};
  const Parameter method{"hit.method", Hasher().add(scene.hit.method)};
  const Parameter hitField{"hit.field", Hasher().add(scene.hit.field)};
  const bool sampled = scene.hit.method == scene::HitMethod::sampled;
  // A setting is a parameter only where it acts: hit.rate does nothing for exact hits.
  const Parameter rate{
      "hit.rate",
      sampled
          ? Hasher().add(scene.hit.rate).add(scene.hit.nearFactor).add(scene.hit.nearThreshold.value_or(0.0))
          : Hasher()};
  const Parameter refinements{"hit.refinements", Hasher().add(sampled ? scene.hit.refinements : -1)};
  const Parameter field{"derivatives.field", Hasher().add(scene.derivatives.field)};
  const bool cubic = scene.derivatives.field != scene::Field::trilinear;
  const Parameter fetch{"derivatives.fetch",
                        Hasher().add(cubic ? scene.derivatives.fetch : scene::Fetch::exact)};
  const Parameter noise{"derivatives.noise", Hasher().add(scene.derivatives.noise.value_or(0.0))};
  const Parameter inside{"isosurface.inside", Hasher().add(scene.isosurface.inside)};
  const Parameter background{"background", Hasher().add(look.backgroundTop).add(look.backgroundBottom)};
  const Parameter surfaces{"surface colours", surfacesHash(scene)};
  const Parameter lookOf{"look", lookHash(scene, request.pixelRatio)};

  // Where no ray can hit anything, colours read nothing of the surface.
  const bool lit = needsOf(scene).light;
  const LookNeeds needs = volumeState.crossed ? needsOf(scene) : LookNeeds{};
  const bool transparent = isTransparent(scene);
  const bool hessianRead = (request.color && needs.curvature) ||
                           std::any_of(request.aovs.begin(), request.aovs.end(), readsHessian);
  PassDeclaration cast{pass::cast,
                       {image::activeBlocks, image::segments},
                       {sampled ? image::bracket : image::surface},
                       {volume, isovalue, camera, size, method, hitField, rate},
                       ""};
  const bool gradientRead = (request.color && needs.gradient) ||
                            std::any_of(request.aovs.begin(), request.aovs.end(), readsGradient);
  PassDeclaration residence{pass::bricks, {}, {image::bricks}, {volume, copy}, "the volume is one texture"};
  cast.parameters.push_back({"memory.layout", Hasher().add(bricks.inUse)});
  if (bricks.inUse) {
    residence.parameters.push_back({"graphics memory", Hasher().add(bricks.made)});
    residence.parameters.push_back({"what rays ask for", Hasher().add(bricks.asked)});
    cast.reads.emplace_back(image::bricks);
    // Other derivatives need the bricks at the hits again.
    if (bricks.mayReplace)
      cast.parameters.push_back(
          {"derivatives", Hasher()
                              .add(scene.derivatives.field)
                              .add(cubic ? scene.derivatives.fetch : scene::Fetch::exact)
                              .add(gradientRead)
                              .add(hessianRead)});
  }
  PassDeclaration refine{pass::refine,
                         {image::bracket},
                         {image::surface},
                         {volume, isovalue, camera, size, hitField, refinements},
                         ""};
  if (!sampled) refine = {pass::refine, {}, {"refined points"}, {}, "exact hits are solved in their cells"};
  PassDeclaration gradient{pass::gradient, {image::surface}, {image::gradient}, {volume, field, fetch}, ""};
  PassDeclaration hessian{pass::hessian, {image::surface}, {image::hessian}, {volume, field, fetch}, ""};
  if (hessianRead) {
    gradient.writes = {"gradients alone"};
    gradient.notNeeded = "the hessian pass writes gradients too";
    hessian.writes.emplace_back(image::gradient);
  }
  PassDeclaration shade{pass::shade,
                        {image::surface},
                        {transparent ? image::front : image::color},
                        {camera, lookOf, surfaces},
                        ""};
  if (needs.gradient) shade.reads.emplace_back(image::gradient);
  if (needs.curvature) shade.reads.emplace_back(image::curvature);
  if (needs.ranges) shade.reads.emplace_back(image::ranges);
  if (needs.shadow) shade.reads.emplace_back(image::shadow);
  if (needs.flow) shade.reads.emplace_back(image::flow);
  const Parameter exposure{
      "exposure", lit ? Hasher().add(scene.picture.exposure.value_or(light.automaticExposure)) : Hasher()};
  const Parameter lightOf{"light", Hasher().add(light.version)};
  const Parameter interpolation{
      "gi.interpolation", light.stored ? Hasher().add(light.storage).add(scene.gi.interpolation) : Hasher()};
  PassDeclaration storedLight{pass::light,
                              {},
                              {image::light},
                              {{"lattice", Hasher().add(light.storage)},
                               {"stored light", Hasher().add(light.skyRevision).add(light.lampsRevision)},
                               {"uploads left over", Hasher().add(light.unfinished)}},
                              "no look reads stored light"};
  PassDeclaration irradiance{pass::irradiance,
                             {image::surface, image::gradient},
                             {image::irradiance},
                             {camera, inside, lightOf, interpolation},
                             "no look reads light of the surface points"};
  if (light.stored) irradiance.reads.emplace_back(image::light);
  if (needs.light) {
    shade.reads.emplace_back(image::irradiance);
    shade.parameters.push_back(exposure);
  }
  const Parameter splineOf{"derivatives.field",
                           Hasher().add(scene.derivatives.field == scene::Field::cubic_interpolating)};
  const Parameter keyLight{"key light", needs.shadow ? shadowHash(scene) : Hasher()};
  const scene::Flow& flow = scene.flow;
  const Parameter streaks{
      "flow field",
      needs.flow ? Hasher().add(flow.direction).add(flow.grain).add(request.pixelRatio) : Hasher()};
  const Parameter pattern{
      "flow", needs.flow
                  ? Hasher().add(flow.length).add(flow.grain).add(request.pixelRatio).add(flowPhase(flow))
                  : Hasher()};
  PassDeclaration layers{pass::layers,
                         {image::front, image::surface, image::activeBlocks, image::segments},
                         {transparent ? image::color : "layers"},
                         {volume,
                          isovalue,
                          camera,
                          size,
                          method,
                          hitField,
                          rate,
                          refinements,
                          field,
                          fetch,
                          noise,
                          lookOf,
                          surfaces,
                          keyLight,
                          streaks,
                          pattern,
                          {"isosurface.layers", Hasher().add(scene.isosurface.layers)}},
                         "every surface is opaque"};
  if (needs.ranges) layers.reads.emplace_back(image::ranges);
  if (needs.light) {
    layers.parameters.insert(layers.parameters.end(), {exposure, lightOf, interpolation});
    if (light.stored) layers.reads.emplace_back(image::light);
  }
  if (!transparent) layers.reads = {image::surface};
  PassDeclaration resolve{
      pass::resolve,
      {image::color},
      {image::picture},
      {size, background, {"legend", legendHash(scene)}, {"linear picture", Hasher().add(request.linear)}},
      ""};
  if (lit && light.background)
    resolve.parameters.insert(resolve.parameters.end(), {exposure, lightOf, camera});
  if (showsLegend(scene) && needs.ranges) resolve.reads.emplace_back(image::ranges);

  return {
      {pass::blocks, {}, {image::activeBlocks, image::faces}, {volume, copy, isovalue, hitField}, ""},
      {pass::segments, {image::activeBlocks, image::faces}, {image::segments}, {camera, size}, ""},
      residence,
      cast,
      refine,
      gradient,
      hessian,
      {pass::curvature, {image::gradient, image::hessian}, {image::curvature}, {inside, noise}, ""},
      {pass::ranges, {}, {image::ranges}, {volume, isovalue, splineOf, inside}, ""},
      {pass::shadow,
       {image::surface, image::gradient, image::activeBlocks},
       {image::shadow},
       {camera, method, hitField, inside, keyLight},
       ""},
      {pass::flowField,
       {image::surface, image::gradient, image::curvature},
       {image::flowField},
       {camera, size, inside, streaks},
       ""},
      {pass::flow, {image::flowField}, {image::flow}, {size, pattern}, ""},
      storedLight,
      irradiance,
      shade,
      layers,
      resolve,
  };
}

bool readsHessian(Aov aov) {
  return aov == Aov::hessian || aov == Aov::kappa || aov == Aov::direction1 || aov == Aov::direction2 ||
         aov == Aov::curvature_confidence;
}

std::vector<std::string> wantedImages(const FrameRequest& request) {
  std::vector<std::string> wanted;
  if (request.color) wanted.emplace_back(image::picture);
  for (const Aov aov : request.aovs) {
    if (aov == Aov::irradiance)
      wanted.emplace_back(image::irradiance);
    else if (readsGradient(aov))
      wanted.emplace_back(image::gradient);
    else if (aov == Aov::hessian)
      wanted.emplace_back(image::hessian);
    else if (readsHessian(aov)) {
      wanted.emplace_back(image::curvature);
      if (aov == Aov::direction2) wanted.emplace_back(image::gradient);
    } else {
      wanted.emplace_back(image::surface);
    }
  }
  return wanted;
}

}  // namespace isolux::render
