#include "scene/rules/relevance.h"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/words.h"
#include "scene/looks.h"
#include "scene/rules/environment.h"
#include "scene/rules/gi_choice.h"
#include "scene/settings/scene_list.h"
#include "scene/settings/settings.h"
#include "scene/shown_surfaces.h"

namespace isolux::scene {

namespace {

bool hasLocalLight(const Scene& s) {
  return shadingOf(s) != Shading::unlit && !usesGi(s);
}

// Tone shading goes from toneCool to toneWarm: brightness and colour of the light do not enter.
bool hasBrightness(const Scene& s) {
  return hasLocalLight(s) && shadingOf(s) != Shading::tone;
}

// The surface's own colour is seen unless a colour map takes its place.
bool showsAlbedo(const Scene& s) {
  return !isPlain(s) && !isMeasure(s.look.mode);
}

bool drawsContours(const Scene& s) {
  return contoursOf(s) > 0.0 || s.look.suggestiveContours > 0.0;
}

bool drawsRidges(const Scene& s) {
  return !isPlain(s) && s.look.ridges > 0.0;
}

bool hasGhosts(const Scene& s) {
  return std::ranges::any_of(s.surfaces, [](const Surface& of) { return of.shown && of.ghost > 0.0; });
}

bool isMesh(const Scene& s) {
  const std::string path = base::lowerCase(s.source.path);
  return path.ends_with(".stl") || path.ends_with(".obj") || path.ends_with(".ply") || path.ends_with(".vtp");
}

struct Rule {
  std::string_view paths;  // patterns of covers(), with spaces between
  bool (*acts)(const Scene&);
  std::string_view otherwise;  // why they do not act
};

// Of an item of a list: `item` is its position in Scene::surfaces or Scene::lamps.
struct ItemRule {
  std::string_view paths;
  bool (*acts)(const Scene&, std::size_t item);
  std::string_view otherwise;
};

bool coversAny(std::string_view patterns, std::string_view path) {
  while (!patterns.empty()) {
    const std::size_t end = std::min(patterns.find(' '), patterns.size());
    if (covers(patterns.substr(0, end), path)) return true;
    patterns.remove_prefix(std::min(end + 1, patterns.size()));
  }
  return false;
}

constexpr auto storesLight = [](const Scene& s) { return giChoiceOf(s).wanted; };
constexpr auto storesIrradiance = [](const Scene& s) {
  const GiChoice choice = giChoiceOf(s);
  return choice.lamps || (choice.sky != GiMode::off && choice.sky != GiMode::transfer);
};
constexpr auto hasFile = [](const Scene& s) { return !s.light.environment.file.empty(); };
constexpr auto hasProbe = [](const Scene& s) { return !hasOneColor(s.light.environment); };
constexpr auto hasAlbedoMap = [](const Scene& s) { return s.isosurface.albedoSource == AlbedoSource::map; };
constexpr auto isCombined = [](const Scene& s) { return s.source.csg != Csg::none; };

// All rules that cover a path must hold; the first that fails says why.
constexpr Rule rules[] = {
    {"source.labels source.smoothing source.label_names",
     [](const Scene& s) { return s.source.kind == DataKind::automatic || s.source.kind == DataKind::labels; },
     "the data are no labels"},
    {"source.mesh_voxels", isMesh, "the source is not a triangle mesh"},
    {"source.csg_path source.csg_value source.csg_weight", isCombined,
     "no second volume is combined with the first"},
    {"source.csg_weight", [](const Scene& s) { return s.source.csg == Csg::blend; },
     "source.csg is not blend"},

    {"isosurface.suggestion", [](const Scene& s) { return !s.surfaces.front().value; },
     "the isovalue is set"},
    {"camera.frames", [](const Scene& s) { return !s.camera.eye; }, "camera.eye is set"},
    {"isosurface.inside",
     [](const Scene& s) { return needsGradient(s) || s.pieces != Pieces{} || showsCutFaces(s); },
     "depth does not depend on the side"},
    {"isosurface.albedo_map isosurface.albedo_low isosurface.albedo_high", hasAlbedoMap,
     "each isosurface has its own colour"},
    {"isosurface.albedo_source isosurface.albedo_map isosurface.albedo_low "
     "isosurface.albedo_high surfaces.#.albedo look.inner_tint",
     showsAlbedo, "this look does not show the surface's own colour"},
    {"surfaces.#.albedo", [](const Scene& s) { return s.isosurface.albedoSource == AlbedoSource::color; },
     "the albedo comes from a colour map"},
    {"surfaces.#.specular surfaces.#.roughness", usesGi, "the shading is not global illumination"},
    {"surfaces.#.specular surfaces.#.roughness", [](const Scene& s) { return !isMeasure(s.look.mode); },
     "colours show numbers"},
    {"isosurface.layers", [](const Scene& s) { return isTransparent(s) || hasGhosts(s); },
     "every isosurface is opaque"},
    {"isosurface.ghost_opacity", hasGhosts, "no uncertainty surfaces are drawn"},

    {"pieces.", [](const Scene& s) { return !visibleSurfaces(s).empty(); }, "no isosurface is shown"},
    {"pieces.depth", [](const Scene& s) { return s.pieces.within.has_value(); },
     "connected components are shown everywhere"},
    {"surfaces.#.clipped clip.cap", [](const Scene& s) { return hasCuts(s.clip); },
     "no clip plane or clip box is set"},
    {"clip.box_rotation", [](const Scene& s) { return !s.clip.box.empty(); }, "no clip box is set"},

    {"slice.slab_mode", [](const Scene& s) { return s.slice.slab > 0.0; }, "the slab thickness is 0"},

    {"hit.rate hit.near_factor hit.near_threshold hit.refinements",
     [](const Scene& s) { return s.hit.method == HitMethod::sampled; }, "hits are exact"},
    {"hit.near_threshold", [](const Scene& s) { return s.hit.nearFactor > 1.0; }, "hit.near_factor is 1"},

    {"picture.rest_hits", [](const Scene& s) { return s.hit.method == HitMethod::exact; },
     "hits are sampled"},
    {"picture.rest_hits", [](const Scene& s) { return s.hit.field == Field::trilinear; },
     "hit.field is already a spline"},
    {"picture.rest_hits", [](const Scene& s) { return !usesGi(s); },
     "light is baked on the surface of hit.field"},

    {"picture.pixel_ratio",
     [](const Scene& s) {
       return showsFlow(s) || drawsRidges(s) || s.color.isolines > 0.0 || (!isPlain(s) && drawsContours(s));
     },
     "no lines or streaks sized in pixels are drawn"},

    {"derivatives.", needsGradient, "this look needs no derivatives"},
    {"derivatives.fetch", [](const Scene& s) { return s.derivatives.field != Field::trilinear; },
     "this setting affects cubic derivatives only"},
    {"derivatives.fetch", readsUnscaled, "derivatives at a scale σ > 0 read single voxels"},
    {"derivatives.noise derivatives.scale", needsSecondDerivatives, "this look needs no curvature"},
    {"edge.", needsEdge, "this look shows no edges"},
    {"derivatives.scale derivatives.normal_scale",
     [](const Scene& s) { return s.derivatives.field != Field::trilinear; },
     "trilinear derivatives have no scale"},

    {"look.shading", [](const Scene& s) { return isColored(s.look.mode); },
     "this look is a shading itself, or shows a raw quantity"},
    {"look.ambient look.ambient_variation look.shadow look.occlusion look.occlusion_radius light.setup "
     "light.space light.direction light.color light.intensity light.fill light.rim light.headlight",
     hasLocalLight, "only local shading uses this light"},
    {"look.ambient look.ambient_variation look.occlusion look.occlusion_radius light.setup light.color "
     "light.intensity light.fill light.rim light.headlight",
     hasBrightness, "this shading ignores the brightness of the key light"},
    {"look.occlusion light.fill light.rim",
     [](const Scene& s) { return s.light.setup == LightSetup::three_point; },
     "the key light is the only light"},
    {"look.occlusion_radius", showsOcclusion, "occlusion is off"},
    {"look.specular look.shininess", [](const Scene& s) { return shadingOf(s) == Shading::blinn_phong; },
     "only Blinn-Phong shading has a highlight"},
    {"look.shininess", [](const Scene& s) { return s.look.specular > 0.0; },
     "the strength of the highlight is 0"},
    {"look.tone_cool look.tone_warm", [](const Scene& s) { return shadingOf(s) == Shading::tone; },
     "the shading is not tone"},
    {"look.texture look.texture_scale", showsAlbedo, "this look does not show the surface's own colour"},
    {"look.texture_scale", [](const Scene& s) { return s.look.texture != SolidTexture::none; },
     "there is no texture"},
    {"look.shadow", keyLightActs, "the key light has no effect"},
    {"look.fog look.fog_color look.accessibility look.accessibility_points look.overlay look.ridges "
     "look.contours look.suggestive_contours "
     "flow.strength",
     [](const Scene& s) { return !isPlain(s); }, "this look shows a raw quantity without overlays"},
    {"look.fog_color", [](const Scene& s) { return s.look.fog > 0.0; }, "there is no fog"},

    {"look.colormap look.colormap_points",
     [](const Scene& s) { return lookInfo(s.look.mode).kind == LookKind::measure; },
     "this look does not show a single quantity in colour"},
    {"look.colormap", [](const Scene& s) { return !s.look.colormapPoints; },
     "control points are set (look.colormap_points)"},
    {"look.range_low look.range_high", [](const Scene& s) { return isMeasure(s.look.mode); },
     "this look shows no quantity in colour"},
    {"look.legend look.legend_corner",
     [](const Scene& s) { return isMeasure(s.look.mode) || showsSecondVolume(s); },
     "this look shows no quantity in colour"},
    {"color.", showsAlbedo, "this look does not show the surface's own colour"},
    {"color.raw color.component color.time_step color.field color.map color.low color.high color.below "
     "color.strength color.fade color.isolines color.isoline_width",
     [](const Scene& s) { return !s.color.volume.empty(); }, "there is no second volume"},
    {"color.field color.low color.high color.below", showsSecondVolume, "the second volume is not visible"},
    {"color.map color.fade", [](const Scene& s) { return s.color.strength > 0.0; },
     "the strength of the second volume's colours is 0"},
    {"color.isoline_width", [](const Scene& s) { return s.color.isolines > 0.0; }, "no isolines are drawn"},
    {"look.legend_corner", [](const Scene& s) { return s.look.legend; }, "no legend is drawn"},
    {"look.curvature_points", [](const Scene& s) { return lookInfo(s.look.mode).kind == LookKind::square; },
     "the look is not curvature 2D"},

    {"look.accessibility", [](const Scene& s) { return s.look.mode != LookMode::accessibility; },
     "the look shows crevice shading at full strength"},
    {"look.accessibility_points",
     [](const Scene& s) { return s.look.mode == LookMode::accessibility || s.look.accessibility > 0.0; },
     "crevice shading is off"},
    {"look.ridge_threshold look.ridge_width look.ridge_width_unit look.ridge_length look.ridge_color "
     "look.valley_color",
     drawsRidges, "the strength of ridge and valley lines is 0"},
    {"look.contour_width look.contour_color", [](const Scene& s) { return !isPlain(s) && drawsContours(s); },
     "the strength of contours is 0"},

    {"flow.strength", [](const Scene& s) { return s.look.mode != LookMode::flow; },
     "the look shows flow at full strength"},
    {"flow.direction flow.length flow.grain flow.animate flow.speed flow.time", showsFlow,
     "no flow is drawn: the look is not flow and flow.strength is 0"},

    {"light.environment. lamps. gi. picture.exposure picture.metering", usesGi,
     "the shading is not global illumination"},
    {"picture.metering", [](const Scene& s) { return !s.picture.exposure; }, "the exposure is set"},
    {"light.environment.constant light.environment.builtin", [](const Scene& s) { return !hasFile(s); },
     "an environment map is set"},
    {"light.environment.builtin", hasProbe, "a constant environment is set"},
    {"light.environment.azimuth light.environment.elevation light.environment.rotation", hasProbe,
     "a constant environment looks the same in every rotation"},
    {"light.environment.moves", hasProbe, "a constant environment can change without a new bake"},
    {"light.environment.moves", [](const Scene& s) { return s.gi.mode == GiMode::automatic; },
     "gi.mode sets what is baked"},

    {"gi.extent gi.band gi.texels gi.samples gi.lattice_scale gi.interpolation gi.ground", storesLight,
     "no light is baked"},
    {"gi.sequence light.environment.shadows", [](const Scene& s) { return giChoiceOf(s).traced; },
     "no light is baked"},
    {"lamps.#.shadows", storesLight, "no light is baked"},
    {"gi.band", [](const Scene& s) { return s.gi.extent == GiExtent::band; },
     "texels are not chosen by isovalue"},
    {"gi.texels", litAlone, "several isosurfaces are lit"},
    {"gi.bounces",
     [](const Scene& s) { return s.gi.mode != GiMode::vicinity && s.gi.mode != GiMode::shadow; },
     "gi.mode has direct light only"},
    {"gi.bounces", [](const Scene& s) { return s.gi.mode != GiMode::off; }, "no light is baked"},
    {"gi.roulette_depth", [](const Scene& s) { return giChoiceOf(s).bounces > 0; }, "no bounces are traced"},
    {"gi.roulette_depth", [](const Scene& s) { return s.gi.rouletteDepth < s.gi.bounces; },
     "paths end before that bounce"},
    {"gi.environment_share gi.precision", storesIrradiance, "no irradiance is baked"},
    {"gi.environment_share", hasProbe, "a constant environment has no bright areas"},
    {"gi.sh_order gi.sh_window gi.components gi.component_bits",
     [](const Scene& s) { return giChoiceOf(s).sky == GiMode::transfer; }, "no transfer is baked"},
};

constexpr ItemRule itemRules[] = {
    {"surfaces.#.name surfaces.#.value surfaces.#.albedo surfaces.#.specular surfaces.#.roughness "
     "surfaces.#.opacity surfaces.#.facing_opacity surfaces.#.ghost surfaces.#.clipped",
     [](const Scene& s, std::size_t item) { return item == 0 || s.surfaces[item].shown; },
     "that isosurface is not shown"},
    {"surfaces.#.labels surfaces.#.smoothing surfaces.#.label_colors",
     [](const Scene& s, std::size_t) { return s.source.kind == DataKind::labels; }, "the data are no labels"},
    {"surfaces.#.labels surfaces.#.smoothing surfaces.#.label_colors",
     [](const Scene& s, std::size_t) { return s.source.labels != kLabelsAsValues; },
     "source.labels draws the values of the labels"},
    {"surfaces.#.smoothing surfaces.#.label_colors",
     [](const Scene& s, std::size_t item) { return s.surfaces[item].shown; }, "that surface is not shown"},
    {"surfaces.#.albedo surfaces.#.opacity surfaces.#.clipped surfaces.#.ghost",
     [](const Scene& s, std::size_t item) { return s.surfaces[item].shown; }, "that isosurface is not shown"},
    {"surfaces.#.facing_opacity surfaces.#.specular surfaces.#.roughness",
     [](const Scene& s, std::size_t item) {
       return s.surfaces[item].shown && s.surfaces[item].opacity > 0.0;
     },
     "the opacity of the surface is 0"},
    {"surfaces.#.roughness", [](const Scene& s, std::size_t item) { return s.surfaces[item].specular > 0.0; },
     "the surface is matt"},
    {"lamps.#.kind lamps.#.position lamps.#.direction lamps.#.radius lamps.#.angle lamps.#.color "
     "lamps.#.intensity lamps.#.shadows",
     [](const Scene& s, std::size_t item) { return s.lamps[item].shown; }, "that light source is off"},
    {"lamps.#.position",
     [](const Scene& s, std::size_t item) { return s.lamps[item].kind != LampKind::directional; },
     "the light source is distant"},
    {"lamps.#.direction",
     [](const Scene& s, std::size_t item) { return s.lamps[item].kind == LampKind::directional; },
     "the light source has a position"},
    {"lamps.#.radius",
     [](const Scene& s, std::size_t item) { return s.lamps[item].kind == LampKind::sphere; },
     "the light source is not a sphere"},
    {"lamps.#.angle",
     [](const Scene& s, std::size_t item) { return s.lamps[item].kind == LampKind::directional; },
     "the light source is not distant"},
};

struct RulesOfPath {
  std::vector<const Rule*> rules;
  std::vector<const ItemRule*> ofItem;
};

std::map<std::string, RulesOfPath, std::less<>> indexed() {
  std::map<std::string, RulesOfPath, std::less<>> index;
  const auto add = [&index](const std::string& path) {
    RulesOfPath& of = index[path];
    for (const Rule& rule : rules)
      if (coversAny(rule.paths, path)) of.rules.push_back(&rule);
    for (const ItemRule& rule : itemRules)
      if (coversAny(rule.paths, path)) of.ofItem.push_back(&rule);
  };
  for (const Setting& setting : settings()) add(setting.path);
  for (const SceneList& list : sceneLists())
    for (const SettingInfo& field : list.fields) add(patternOf(field.path));
  return index;
}

}  // namespace

std::string_view whyInactive(std::string_view path, const Scene& scene) {
  static const auto index = indexed();
  const auto found = index.find(patternOf(path));
  if (found == index.end()) return {};
  for (const Rule* rule : found->second.rules)
    if (!rule->acts(scene)) return rule->otherwise;
  if (found->second.ofItem.empty()) return {};
  const std::optional<std::size_t> item = positionOf(scene, path);
  if (!item) return "there is no such item";
  for (const ItemRule* rule : found->second.ofItem)
    if (!rule->acts(scene, *item)) return rule->otherwise;
  return {};
}

std::vector<std::string_view> inactiveReasons() {
  std::vector<std::string_view> list;
  for (const Rule& rule : rules) list.push_back(rule.otherwise);
  for (const ItemRule& rule : itemRules) list.push_back(rule.otherwise);
  list.emplace_back("there is no such item");
  return list;
}

}  // namespace isolux::scene
