#include "render/passes/light_passes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "gi/ground/ground_shadow.h"
#include "render/passes/passes.h"
#include "scene/camera.h"
#include "scene/opacity.h"
#include "scene/rules/needs.h"
#include "scene/shown_surfaces.h"

namespace isolux::render {

namespace {

constexpr GLuint kFactorsBinding = 3;  // light_lattice.glsl
constexpr std::size_t kMostLamps = 3;  // local_light.glsl
constexpr double kPi = std::numbers::pi;

// Y_i without its polynomial, in the order of local_light.glsl: gi/harmonics/spherical_harmonics.h, orders 1
// to 3.
const std::array<float, 9> kHarmonics = {0.2820948f, 0.4886025f, 0.4886025f, 0.4886025f, 1.0925484f,
                                         1.0925484f, 0.3153916f, 1.0925484f, 0.5462742f};

// Until anyone says what the light is: white, and brighter from above.
std::array<glm::vec3, 9> neutralSky() {
  std::array<glm::vec3, 9> sky{};
  sky[0] = glm::vec3(0.75 * kPi / kHarmonics[0]);
  sky[2] = glm::vec3(0.25 * kPi / kHarmonics[2]);
  return sky;
}

struct LocalLamp {
  glm::vec4 place, power;
};

LocalLamp localLamp(const gi::LampLight& lamp, const glm::dvec3& originMm) {
  const glm::dvec4 at(lamp.positionMm - originMm, 1.0);
  switch (lamp.kind) {
    case scene::LampKind::point:
      break;
    case scene::LampKind::sphere:
      return {at, glm::dvec4(kPi * lamp.radiusMm * lamp.radiusMm * lamp.power, lamp.radiusMm)};
    case scene::LampKind::directional: {
      const double sineSquared = 1.0 - lamp.cosHalfAngle * lamp.cosHalfAngle;
      const double of = lamp.cosHalfAngle >= 1.0 ? 1.0 : kPi * sineSquared;
      return {glm::dvec4(lamp.toward, 0.0),
              glm::dvec4(of * lamp.power, std::sqrt(std::max(sineSquared, 0.0)))};
    }
  }
  return {at, glm::dvec4(lamp.power, 0.0)};
}

std::size_t lampCount(const gi::PictureLight* light) {
  return light ? std::min(light->lampLights.size(), kMostLamps) : 0;
}

// Light behind transparent surfaces in units of that before them: of each surface, behind the others that
// enclose it, and behind itself.
struct LightThrough {
  std::vector<glm::vec3> others, itself;
};

// False without a volume.
bool knowsIsovalues(const scene::Scene& scene) {
  return std::ranges::all_of(scene::shownSurfaces(scene), [](const auto& s) { return s.value.has_value(); });
}

// Isosurfaces are nested: each encloses those further inside. One that is cut open lets all light in.
LightThrough lightThroughOf(const scene::Scene& scene, const std::vector<Surface>& surfaces) {
  const bool cut = scene::hasCuts(scene.clip);
  const double inward = scene.isosurface.inside == scene::Inside::above ? 1.0 : -1.0;
  const std::vector<glm::vec3> all(placesOf(surfaces.size()), glm::vec3(1.0f));
  LightThrough light{all, all};
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const Surface& shell = surfaces[i];
    if (shell.opaque() || (cut && shell.clipped)) continue;
    const double opacity = scene::meanOpacity(shell.opacity, shell.facingOpacity);
    for (int c = 0; c < 3; ++c)
      light.itself[i][c] = static_cast<float>(scene::lightThrough(opacity, shell.albedo[c]));
    for (std::size_t k = 0; k < surfaces.size(); ++k)
      if (inward * (surfaces[k].value - shell.value) > 0.0) light.others[k] *= light.itself[i];
  }
  return light;
}

// CODE_FIELDS is a list of what FIELD(component, word, shift, mask) makes of each component.
std::string codeDefines(const LightTexelLayout& layout) {
  std::string defines = "#define CODE_WORDS " + std::to_string(layout.codeWords) + "\n#define CODE_COUNT " +
                        std::to_string(layout.fields.size()) + "\n#define CODE_FIELDS";
  for (std::size_t k = 0; k < layout.fields.size(); ++k) {
    const gi::TransferBasis::Field& field = layout.fields[k];
    defines += " FIELD(" + std::to_string(k) + ", " + std::to_string(field.word) + ", " +
               std::to_string(field.shift) + ", " + std::to_string((1u << field.bits) - 1u) + "u)";
  }
  return defines + "\n";
}

}  // namespace

float exposureOf(const scene::Scene& scene, const gi::PictureLight* light) {
  const double automatic = light ? static_cast<double>(light->automaticExposure) : 0.0;
  return static_cast<float>(std::exp2(scene.picture.exposure.value_or(automatic)));
}

void addExposure(Declaring& d) {
  const bool automatic = !d.asked.scene.picture.exposure && d.asked.acts("picture.exposure");
  d.settings({"picture.exposure"});
  d.input("automatic exposure", automatic ? d.asked.light.automaticExposure : 0.0f);
}

FrameLight::FrameLight(const GlPtr& gl) : atlas_(gl), factors_(gl) {}

void FrameLight::prepare(FrameState& frame, std::size_t budgetBytes) {
  const scene::GiInterpolation interpolation = frame.scene->gi.interpolation;
  LightAtlas::Source source;
  if (frame.readsLight) source.light = frame.light;
  source.precision = frame.scene->gi.precision;
  source.isovalues = interpolation == scene::GiInterpolation::closest_isovalue;
  source.filtered = interpolation == scene::GiInterpolation::weighted;
  if (frame.prepared) source.grid = frame.prepared->volume.grid;
  if (frame.light && frame.light->grid) source.grid = frame.light->grid;
  if (!source.grid) source.isovalues = source.filtered = false;
  source.budgetBytes = budgetBytes;
  // A look that reads no stored light leaves what there is for the next that does; that of another volume
  // goes.
  if (!frame.readsLight && (!atlas_.stores() || atlas_.grid() == source.grid)) return;
  if (atlas_.setSource(source)) ++storage_;
}

LightState FrameLight::state(const FrameState& frame) const {
  LightState state;
  const gi::PictureLight* const light = frame.light.get();
  state.stored = frame.readsLight && atlas_.stores();
  state.storage = storage_;
  state.version = light ? light->version + 1 : 0;
  const auto revisionOf = [](const std::shared_ptr<const gi::LightLattice>& lattice) {
    return lattice ? lattice->revision() : 0;
  };
  if (light) {
    state.inner = state.stored && atlas_.hasInner();
    state.skyRevision = revisionOf(light->sky);
    state.lampsRevision = revisionOf(light->lamps);
    state.innerSkyRevision = revisionOf(light->inner.sky);
    state.innerLampsRevision = revisionOf(light->inner.lamps);
  }
  state.unfinished = unfinished_;
  state.automaticExposure = light ? light->automaticExposure : 0.0f;
  state.background = light && light->background;
  state.gloss = light && light->gloss;
  state.ground = light && light->ground ? light->ground->key : 0;
  return state;
}

void FrameLight::upload(std::size_t limitBytes) {
  atlas_.update(limitBytes);
  if (atlas_.pending()) ++unfinished_;
}

std::size_t FrameLight::bytes() const {
  return atlas_.bytes() + factors_.bytes() + background_.bytes() + ground_.bytes();
}

void FrameLight::report(LightReport& out) const {
  out = {atlas_.stores(),      atlas_.resident(), atlas_.uploaded(),
         atlas_.withoutRoom(), atlas_.bytes(),    atlas_.pending()};
}

std::string FrameLight::lampDefines(const FrameState& frame) const {
  return "#define LAMP_COUNT " + std::to_string(lampCount(frame.light.get())) + "\n";
}

std::string FrameLight::defines(const FrameState& frame) const {
  const LightTexelLayout& layout = atlas_.layout();
  const auto number = [](const char* name, auto value) {
    return "#define " + std::string(name) + " " + std::to_string(static_cast<int>(value)) + "\n";
  };
  const std::string lamps = lampDefines(frame);
  if (!layout.stores()) return lamps;
  return lamps + "#define STORED\n" + number("SKY", layout.sky) + number("LAMPS", layout.lamps) +
         number("WORDS", layout.words()) + codeDefines(layout) +
         number("INTERPOLATION", frame.scene->gi.interpolation) +
         (atlas_.holdsPartsOfOpenSky() ? "#define PARTS_OF_OPEN_SKY\n" : "");
}

void FrameLight::setLocalLight(const FrameState& frame, Program& p) const {
  const std::array<glm::vec3, 9> sky = frame.light ? frame.light->irradianceSh : neutralSky();
  for (std::size_t i = 0; i < sky.size(); ++i)
    p.set(("uLocalSky[" + std::to_string(i) + "]").c_str(), kHarmonics[i] * sky[i]);
  const std::size_t lamps = lampCount(frame.light.get());
  const glm::dvec3 origin(frame.volume->grid().geometry().worldFromVoxel[3]);
  for (std::size_t i = 0; i < lamps; ++i) {
    const LocalLamp lamp = localLamp(frame.light->lampLights[i], origin);
    const std::string name = "uLamps[" + std::to_string(i) + "].";
    p.set((name + "place").c_str(), lamp.place);
    p.set((name + "power").c_str(), lamp.power);
  }
}

glm::vec3 FrameLight::texelsPerVoxel() const {
  const gi::LatticeGeometry& geometry = atlas_.geometry();
  glm::vec3 texels(0.0f);
  for (int axis = 0; axis < 3; ++axis)
    if (geometry.volumeDims[axis] > 1)
      texels[axis] =
          static_cast<float>(geometry.dims[axis] - 1) / static_cast<float>(geometry.volumeDims[axis] - 1);
  return texels;
}

void FrameLight::setLattice(const FrameState& frame, Program& p) {
  atlas_.bind(p, 3);
  const gi::LatticeGeometry& geometry = atlas_.geometry();
  p.set("uLatticeDims", geometry.dims);
  p.set("uLatticeBlocks", geometry.blockDims());
  p.set("uTexelsPerVoxel", texelsPerVoxel());
  p.set("uSkyScale", frame.light->skyScale * atlas_.layout().skyUnit);
  p.set("uLampsUnit", atlas_.layout().lampsUnit);
  if (atlas_.holdsPartsOfOpenSky()) p.set("uPerMeanSky", atlas_.openSky().perMean());
  const auto isovalue = [&](const Surface& s) { return frame.volume->grid().storedIsovalue(s.value); };
  frame.setOfSurfaces(p, "uStoredIsovalues", isovalue);
  frame.setOfSurfaces(
      p, "uShadowShown", [](const Surface& s) { return scene::shadowShown(s); }, 1.0f);
  const LightTexelLayout& layout = atlas_.layout();
  if (layout.sky != LightPacking::codes) return;
  const gi::TransferBasis::Lighting lighting = frame.light->basis->under(frame.light->environment);
  p.set("uTransferOffset", lighting.offset);
  if (factorsOf_ != frame.light) {
    std::vector<glm::vec4> factors(1, glm::vec4(0.0f));  // a buffer is never empty
    for (const glm::vec3& factor : lighting.factors) factors.emplace_back(factor, 0.0f);
    factors_.setData(factors.data(), factors.size() * sizeof(glm::vec4));
    factorsOf_ = frame.light;
  }
  frame.gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, kFactorsBinding, factors_.id());
}

void FrameLight::setLightThrough(const FrameState& frame, Program& p) {
  const LightThrough through = lightThroughOf(*frame.scene, frame.surfaces);
  for (std::size_t i = 0; i < through.others.size(); ++i) {
    const std::string at = "[" + std::to_string(i) + "]";
    p.set(("uBehindOthers" + at).c_str(), through.others[i]);
    p.set(("uBehindItself" + at).c_str(), through.itself[i]);
  }
}

void FrameLight::bind(FrameState& frame, Program& p) {
  setLocalLight(frame, p);
  setLightThrough(frame, p);
  if (atlas_.stores()) setLattice(frame, p);
}

void FrameLight::setBackground(FrameState& frame, Program& p, int unit) {
  const gi::PictureLight& light = *frame.light;
  if (backgroundOf_ != light.background) {
    background_ = Texture();  // before its successor is made: both need not fit
    background_ =
        Texture::make2D(frame.gl, GL_RGB32F, {light.background->width(), light.background->height()});
    background_.write(GL_RGB, GL_FLOAT, light.background->pixels().data());
    background_.setFilter(GL_LINEAR);
    frame.gl->TextureParameteri(background_.id(), GL_TEXTURE_WRAP_S, GL_REPEAT);
    backgroundOf_ = light.background;
  }
  p.setTexture("uEnvironment", unit, background_);
  p.set("uEnvironmentFromWorld", light.environmentFromWorld);
  p.set("uEnvironmentScale", light.backgroundScale * exposureOf(*frame.scene, &light));
  p.set("uRightWorld", glm::vec3(frame.view->rightWorld));
  p.set("uUpWorld", glm::vec3(frame.view->upWorld));
  p.set("uForwardWorld", glm::vec3(frame.view->forwardWorld));
  // An orthographic view sees as much of it as a perspective one of the same target.
  glm::dvec2 extent = frame.view->halfExtent;
  if (frame.view->orthographic) extent /= scene::frameOf(frame.scene->camera).distance;
  p.set("uViewExtent", glm::vec2(extent));
}

void FrameLight::setGround(FrameState& frame, Program& p, int unit) {
  const gi::GroundShadow& ground = *frame.light->ground;
  if (groundOf_ != ground.key) {
    ground_ = Texture::make2D(frame.gl, GL_R32F, glm::ivec2(gi::GroundShadow::kPoints));
    ground_.setFilter(GL_LINEAR);
    ground_.write(GL_RED, GL_FLOAT, ground.light.data());
    groundOf_ = ground.key;
  }
  const double aspect = static_cast<double>(frame.request.size.x) / frame.request.size.y;
  // From below, no ray meets it.
  const auto places = ground.placesOf(scene::frameOf(frame.scene->camera), aspect);
  p.setTexture("uGround", unit, ground_);
  p.set("uGroundPlaces", glm::mat3(places.value_or(glm::dmat3(0.0))));
  p.set("uGroundCrowding", static_cast<float>(gi::GroundShadow::kCrowding));
}

namespace {

void declareLight(Declaring& d) {
  const LightState& light = d.asked.light;
  d.writes(image::light).notNeeded("no look reads baked light");
  d.input("lattice", light.storage).input("stored light", light.skyRevision, light.lampsRevision);
  d.input("stored light of inner sides", light.innerSkyRevision, light.innerLampsRevision);
  d.input("uploads left over", light.unfinished);
}

void uploadLight(FrameState& frame) {
  frame.lighting->upload(frame.request.lightUploadBytes);
}

std::size_t bytesOfLight(const FrameState& frame) {
  return frame.lighting->atlasBytes();
}

void declareIrradiance(Declaring& d) {
  const LightState& light = d.asked.light;
  d.reads(image::surface).reads(image::gradient).writes(image::irradiance, 16);
  d.notNeeded("no look reads light of the surface points");
  d.settings({"camera."}).input("light", light.version);
  base::Hasher through, shadows;
  if (scene::isTransparent(d.asked.scene) && knowsIsovalues(d.asked.scene)) {
    const std::vector<Surface> surfaces = surfacesOf(d.asked.scene);
    const LightThrough light = lightThroughOf(d.asked.scene, surfaces);
    for (std::size_t i = 0; i < light.others.size(); ++i)
      for (const int c : {0, 1, 2}) through.add(light.others[i][c]).add(light.itself[i][c]);
    for (const Surface& surface : surfaces) shadows.add(scene::shadowShown(surface));
  }
  d.input("light through surfaces", static_cast<std::uint64_t>(through));
  if (!light.stored) return;
  d.input("shadows shown", static_cast<std::uint64_t>(shadows));
  d.settings({"isosurface.inside"});  // light is stored of one side, or of each
  d.reads(image::light).input("lattice", light.storage);
  d.input("gi.interpolation", d.asked.scene.gi.interpolation);  // wherever light is stored, planned or not
}

void drawIrradiance(FrameState& frame) {
  Target& target = frame.target(image::irradiance, {GL_RGBA32F});
  if (frame.clearIfEmpty(target, {kZero})) return;
  Program& p = frame.program("irradiance.frag.glsl", frame.surfaceDefines() + frame.lighting->defines(frame));
  frame.setView(p);
  frame.setPoint(p, 0);
  frame.lighting->bind(frame, p);
  frame.drawHits(target, p);
}

}  // namespace

PassList lightPasses() {
  const LookInput irradiance{image::irradiance, "", {"uIrradiance"}, scene::usesGi};  // by SHADING
  return {
      // Uploads baked lighting that changed since the last frame.
      {.name = "light", .declare = declareLight, .run = uploadLight, .bytes = bytesOfLight},
      // Looks up baked lighting at the surface points, or unshadowed light where nothing is baked.
      {pass::irradiance, declareIrradiance, drawIrradiance, irradiance, {.ofCrossing = true}},
      reflectionsPass(),
  };
}

}  // namespace isolux::render
