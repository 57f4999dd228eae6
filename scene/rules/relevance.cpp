#include "scene/rules/relevance.h"

#include <algorithm>
#include <cctype>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "scene/looks.h"
#include "scene/rules/environment.h"
#include "scene/rules/gi_choice.h"
#include "scene/settings.h"

namespace isolux::scene {

namespace {

bool colorsMeanNumbers(const Scene& s) {
  return isMeasure(s.look.mode);
}

bool isLit(const Scene& s) {
  return shadingOf(s) != Shading::unlit;
}

bool hasLocalLight(const Scene& s) {
  return isLit(s) && !usesGi(s);
}

// Tone shading goes from toneCool to toneWarm: brightness and colour of the light do not enter.
bool hasBrightness(const Scene& s) {
  return hasLocalLight(s) && shadingOf(s) != Shading::tone;
}

bool hasHighlight(const Scene& s) {
  return shadingOf(s) == Shading::blinn_phong;
}

bool usesTone(const Scene& s) {
  return shadingOf(s) == Shading::tone;
}

// The surface's own colour is seen unless a colour map takes its place.
bool showsAlbedo(const Scene& s) {
  return !isPlain(s) && !colorsMeanNumbers(s);
}

bool drawsContours(const Scene& s) {
  return contoursOf(s) > 0.0 || s.look.suggestiveContours > 0.0;
}

bool drawsRidges(const Scene& s) {
  return !isPlain(s) && s.look.ridges > 0.0;
}

bool isMesh(const Scene& s) {
  std::string path = s.source.path;
  std::transform(path.begin(), path.end(), path.begin(), [](unsigned char c) { return std::tolower(c); });
  return path.ends_with(".stl") || path.ends_with(".obj") || path.ends_with(".ply") || path.ends_with(".vtp");
}

bool hasSecondVolume(const Scene& s) {
  return !s.color.volume.empty();
}

bool choosesPieces(const Scene& s) {
  return !(s.pieces == Pieces{});
}

bool showsSurface(const Scene& s) {
  return s.isosurface.opacity > 0.0 ||
         std::any_of(s.extraIsosurfaces.begin(), s.extraIsosurfaces.end(),
                     [](const ExtraIsosurface& extra) { return extra.shown && extra.opacity > 0.0; });
}

struct Rule {
  std::string_view paths;  // patterns of covers(), with spaces between
  bool (*acts)(const Scene&);
  std::string_view otherwise;  // why they do not act
};

// Of an item of a list: `item` is its place in Scene::lamps, Scene::extraIsosurfaces.
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
    {"source.mesh_voxels", isMesh, "the source is not a triangle mesh"},
    {"source.csg_path source.csg_value", isCombined, "no second volume is combined with the first"},

    {"isosurface.suggestion", [](const Scene& s) { return !s.isosurface.value; }, "the isovalue is given"},
    {"camera.frames", [](const Scene& s) { return !s.camera.eye; }, "the camera is given"},
    {"isosurface.inside",
     [](const Scene& s) { return needsGradient(s) || choosesPieces(s) || showsCutFaces(s); },
     "depth is the same from either side"},
    {"isosurface.albedo_map isosurface.albedo_low isosurface.albedo_high", hasAlbedoMap,
     "isosurfaces have the reflectances given"},
    {"isosurface.albedo isosurface.albedo_source isosurface.albedo_map isosurface.albedo_low "
     "isosurface.albedo_high isosurface#.albedo look.inner_tint",
     showsAlbedo, "this look does not show the surface's own colour"},
    {"isosurface.albedo isosurface#.albedo",
     [](const Scene& s) { return s.isosurface.albedoSource == AlbedoSource::color; },
     "the albedo comes from a colour map"},
    {"isosurface.layers", [](const Scene& s) { return isTransparent(s) || s.isosurface.ghost > 0.0; },
     "every isosurface is opaque"},
    {"isosurface.facing_opacity", [](const Scene& s) { return s.isosurface.opacity > 0.0; },
     "the surface has no opacity"},
    {"isosurface.ghost_opacity", [](const Scene& s) { return s.isosurface.ghost > 0.0; },
     "there are no ghosts"},

    {"pieces.", showsSurface, "no isosurface is shown"},
    {"pieces.depth", [](const Scene& s) { return s.pieces.within.has_value(); },
     "pieces are shown wherever they lie"},
    {"isosurface.clipped isosurface#.clipped clip.cap", [](const Scene& s) { return hasCuts(s.clip); },
     "nothing is cut away"},
    {"clip.box_rotation", [](const Scene& s) { return !s.clip.box.empty(); }, "no box cuts anything"},

    {"slice.slab_mode", [](const Scene& s) { return s.slice.slab > 0.0; }, "slices have no thickness"},

    {"hit.rate hit.near_factor hit.near_threshold hit.refinements",
     [](const Scene& s) { return s.hit.method == HitMethod::sampled; }, "hits are exact"},
    {"hit.near_threshold", [](const Scene& s) { return s.hit.nearFactor > 1.0; },
     "the samples near the isovalue are no denser than the others"},

    {"picture.rest_hits", [](const Scene& s) { return s.hit.method == HitMethod::exact; },
     "hits are sampled"},
    {"picture.rest_hits", [](const Scene& s) { return s.hit.field == Field::trilinear; },
     "hits are those of a spline already"},
    {"picture.rest_hits", [](const Scene& s) { return !usesGi(s); },
     "light is stored on the surface that hit.field shows"},

    {"picture.pixel_ratio",
     [](const Scene& s) {
       return showsFlow(s) || drawsRidges(s) || s.color.isolines > 0.0 || (!isPlain(s) && drawsContours(s));
     },
     "nothing is drawn whose width is stated in pixels"},

    {"derivatives.", needsGradient, "this look needs no derivatives"},
    {"derivatives.fetch", [](const Scene& s) { return s.derivatives.field != Field::trilinear; },
     "trilinear derivatives are read in one way only"},
    {"derivatives.fetch", readsUnscaled, "derivatives at a scale are read by single voxels"},
    {"derivatives.noise derivatives.scale", needsSecondDerivatives, "this look needs no curvature"},
    {"edge.", needsEdge, "this look shows no edges"},
    {"derivatives.scale derivatives.normal_scale",
     [](const Scene& s) { return s.derivatives.field != Field::trilinear; },
     "trilinear derivatives have no scale"},

    {"look.shading", [](const Scene& s) { return isColored(s.look.mode); },
     "this look is a shading itself, or shows a raw quantity"},
    {"look.ambient look.ambient_variation look.shadow look.occlusion look.occlusion_radius light.setup "
     "light.space light.direction light.color light.intensity light.fill light.rim light.headlight",
     hasLocalLight, "only local shading has this light"},
    {"look.ambient look.ambient_variation look.occlusion look.occlusion_radius light.setup light.color "
     "light.intensity light.fill light.rim light.headlight",
     hasBrightness, "this shading does not take its brightness from the key light"},
    {"look.occlusion light.fill light.rim",
     [](const Scene& s) { return s.light.setup == LightSetup::three_point; }, "the key light stands alone"},
    {"look.occlusion_radius", showsOcclusion, "nothing keeps light away"},
    {"look.specular look.shininess", hasHighlight, "only Blinn-Phong shading has a highlight"},
    {"look.shininess", [](const Scene& s) { return s.look.specular > 0.0; }, "the highlight has no strength"},
    {"look.tone_cool look.tone_warm", usesTone, "the shading is not tone"},
    {"look.texture look.texture_scale", showsAlbedo, "this look does not show the surface's own colour"},
    {"look.texture_scale", [](const Scene& s) { return s.look.texture != SolidTexture::none; },
     "there is no texture"},
    {"look.shadow", keyLightActs, "the key light brightens nothing"},
    {"look.fog look.fog_color look.accessibility look.ridges look.contours look.suggestive_contours "
     "flow.strength",
     [](const Scene& s) { return !isPlain(s); }, "this look shows a raw quantity, with nothing laid over it"},
    {"look.fog_color", [](const Scene& s) { return s.look.fog > 0.0; }, "there is no fog"},

    {"look.colormap", [](const Scene& s) { return lookInfo(s.look.mode).kind == LookKind::measure; },
     "this look does not show one number in colour"},
    {"look.range_low look.range_high", colorsMeanNumbers, "colours do not stand for numbers in this look"},
    {"look.legend look.legend_corner",
     [](const Scene& s) { return colorsMeanNumbers(s) || showsSecondVolume(s); },
     "colours do not stand for numbers in this look"},
    {"color.", showsAlbedo, "this look does not show the surface's own colour"},
    {"color.raw color.component color.time_step color.field color.map color.low color.high color.below "
     "color.strength color.fade color.isolines color.isoline_width",
     hasSecondVolume, "there is no second volume"},
    {"color.field color.low color.high color.below", showsSecondVolume,
     "nothing is shown of the second volume"},
    {"color.map color.fade", [](const Scene& s) { return s.color.strength > 0.0; },
     "the second volume's colours have no strength"},
    {"color.isoline_width", [](const Scene& s) { return s.color.isolines > 0.0; }, "no isolines are drawn"},
    {"look.legend_corner", [](const Scene& s) { return s.look.legend; }, "no legend is drawn"},
    {"look.curvature_points", [](const Scene& s) { return lookInfo(s.look.mode).kind == LookKind::square; },
     "the look is not curvature 2D"},

    {"look.accessibility", [](const Scene& s) { return s.look.mode != LookMode::accessibility; },
     "the look shows accessibility at full strength"},
    {"look.ridge_threshold look.ridge_width look.ridge_width_unit look.ridge_length look.ridge_color "
     "look.valley_color",
     drawsRidges, "ridge and valley lines have no strength"},
    {"look.contour_width look.contour_color", [](const Scene& s) { return !isPlain(s) && drawsContours(s); },
     "contours have no strength"},

    {"flow.strength", [](const Scene& s) { return s.look.mode != LookMode::flow; },
     "the look shows flow at full strength"},
    {"flow.direction flow.length flow.grain flow.animate flow.speed flow.time", showsFlow,
     "no flow is drawn: the look is not flow and flow.strength is 0"},

    {"light.environment. lamp#. gi. picture.exposure picture.metering", usesGi,
     "the shading is not global illumination"},
    {"picture.metering", [](const Scene& s) { return !s.picture.exposure; }, "the exposure is set"},
    {"light.environment.constant light.environment.builtin", [](const Scene& s) { return !hasFile(s); },
     "there is a light probe"},
    {"light.environment.builtin", hasProbe, "there is a sky of one colour"},
    {"light.environment.azimuth light.environment.elevation light.environment.rotation", hasProbe,
     "a sky of one colour looks the same however it is turned"},
    {"light.environment.moves", hasProbe, "a sky of one colour may change anyway"},
    {"light.environment.moves", [](const Scene& s) { return s.gi.mode == GiMode::automatic; },
     "gi.mode says what is stored"},

    {"gi.extent gi.band gi.texels gi.samples gi.sequence gi.lattice_scale gi.interpolation", storesLight,
     "no light is stored"},
    {"gi.band", [](const Scene& s) { return s.gi.extent == GiExtent::band; },
     "texels are not chosen by isovalue"},
    {"gi.texels", showsOneIsosurface, "several isosurfaces are shown"},
    {"gi.bounces",
     [](const Scene& s) { return s.gi.mode != GiMode::vicinity && s.gi.mode != GiMode::shadow; },
     "gi.mode is direct light only"},
    {"gi.bounces", [](const Scene& s) { return s.gi.mode != GiMode::off; }, "no light is stored"},
    {"gi.roulette_depth", [](const Scene& s) { return giChoiceOf(s).bounces > 0; }, "no bounces are traced"},
    {"gi.roulette_depth", [](const Scene& s) { return s.gi.rouletteDepth < s.gi.bounces; },
     "paths end before that bounce"},
    {"gi.environment_share gi.precision", storesIrradiance, "no irradiance is stored"},
    {"gi.environment_share", hasProbe, "a sky of one colour has no bright places"},
    {"gi.sh_order gi.sh_window gi.components gi.component_bits",
     [](const Scene& s) { return giChoiceOf(s).sky == GiMode::transfer; }, "no transfer is stored"},
};

constexpr ItemRule itemRules[] = {
    {"isosurface#.name isosurface#.value isosurface#.albedo isosurface#.opacity isosurface#.facing_opacity "
     "isosurface#.clipped",
     [](const Scene& s, std::size_t item) { return s.extraIsosurfaces[item].shown; },
     "that isosurface is not shown"},
    {"isosurface#.facing_opacity",
     [](const Scene& s, std::size_t item) { return s.extraIsosurfaces[item].opacity > 0.0; },
     "that surface has no opacity"},
    {"lamp#.kind lamp#.position lamp#.direction lamp#.radius lamp#.angle lamp#.color lamp#.intensity",
     [](const Scene& s, std::size_t item) { return s.lamps[item].shown; }, "that lamp is off"},
    {"lamp#.position",
     [](const Scene& s, std::size_t item) { return s.lamps[item].kind != LampKind::directional; },
     "the lamp is distant"},
    {"lamp#.direction",
     [](const Scene& s, std::size_t item) { return s.lamps[item].kind == LampKind::directional; },
     "the lamp has a position"},
    {"lamp#.radius", [](const Scene& s, std::size_t item) { return s.lamps[item].kind == LampKind::sphere; },
     "the lamp is no sphere"},
    {"lamp#.angle",
     [](const Scene& s, std::size_t item) { return s.lamps[item].kind == LampKind::directional; },
     "the lamp is not distant"},
};

// Of "lamp2.kind", "isosurface3.value": the number in paths less that of the first item.
std::size_t itemOf(std::string_view path) {
  const int first = path.starts_with("lamp") ? 1 : 2;
  return static_cast<std::size_t>(path[path.find('.') - 1] - '0' - first);
}

struct RulesOfPath {
  std::vector<const Rule*> rules;
  std::vector<const ItemRule*> ofItem;
};

std::map<std::string, RulesOfPath, std::less<>> indexed() {
  std::map<std::string, RulesOfPath, std::less<>> index;
  for (const Setting& setting : settings()) {
    RulesOfPath& of = index[setting.path];
    for (const Rule& rule : rules)
      if (coversAny(rule.paths, setting.path)) of.rules.push_back(&rule);
    for (const ItemRule& rule : itemRules)
      if (coversAny(rule.paths, setting.path)) of.ofItem.push_back(&rule);
  }
  return index;
}

}  // namespace

std::string_view whyInactive(std::string_view path, const Scene& scene) {
  static const auto index = indexed();
  const auto found = index.find(path);
  if (found == index.end()) return {};
  for (const Rule* rule : found->second.rules)
    if (!rule->acts(scene)) return rule->otherwise;
  for (const ItemRule* rule : found->second.ofItem)
    if (!rule->acts(scene, itemOf(path))) return rule->otherwise;
  return {};
}

std::vector<std::string_view> inactiveReasons() {
  std::vector<std::string_view> list;
  for (const Rule& rule : rules) list.push_back(rule.otherwise);
  for (const ItemRule& rule : itemRules) list.push_back(rule.otherwise);
  return list;
}

}  // namespace isolux::scene
