#include "scene/rules/relevance.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

#include "scene/rules/gi_choice.h"

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
  return s.look.contours > 0.0 || s.look.suggestiveContours > 0.0;
}

bool isMesh(const Scene& s) {
  std::string path = s.source.path;
  std::transform(path.begin(), path.end(), path.begin(), [](unsigned char c) { return std::tolower(c); });
  return path.ends_with(".stl") || path.ends_with(".obj") || path.ends_with(".ply") || path.ends_with(".vtp");
}

struct Rule {
  std::string_view path;  // of a setting, or "group." for all settings of a group
  bool (*acts)(const Scene&);
  std::string_view otherwise;  // why it does not act
};

bool covers(const Rule& rule, std::string_view path) {
  return rule.path.ends_with('.') ? path.starts_with(rule.path) : path == rule.path;
}

constexpr std::string_view plain = "this look shows a raw quantity, with nothing laid over it";
constexpr std::string_view notLocal = "only local shading has this light";
constexpr std::string_view noGi = "the shading is not global illumination";
constexpr std::string_view nothingStored = "no light is stored";
constexpr std::string_view noTransfer = "no transfer is stored";
constexpr std::string_view noLamp = "that lamp is off";
constexpr std::string_view noAlbedoMap = "isosurfaces have the reflectances given";
constexpr std::string_view toneOnly = "this shading does not take its brightness from the key light";
constexpr std::string_view noAlbedo = "this look does not show the surface's own colour";
constexpr std::string_view noHighlight = "only Blinn-Phong shading has a highlight";
constexpr std::string_view noTone = "the shading is not tone";
constexpr std::string_view noNumbers = "colours do not stand for numbers in this look";
constexpr std::string_view noRidges = "ridge and valley lines have no strength";
constexpr std::string_view noContours = "contours have no strength";
constexpr std::string_view exactHits = "hits are exact";
constexpr std::string_view hidden = "that isosurface is not shown";
constexpr std::string_view noFlow = "no flow is drawn: the look is not flow and flow.strength is 0";
constexpr std::string_view oneVolume = "no second volume is combined with the first";

constexpr auto isShown2 = [](const Scene& s) { return s.isosurface2.shown; };
constexpr auto isShown3 = [](const Scene& s) { return s.isosurface3.shown; };
constexpr auto isShown4 = [](const Scene& s) { return s.isosurface4.shown; };
constexpr auto isSampled = [](const Scene& s) { return s.hit.method == HitMethod::sampled; };
constexpr auto isNotPlain = [](const Scene& s) { return !isPlain(s); };
constexpr auto hasRidges = [](const Scene& s) { return !isPlain(s) && s.look.ridges > 0.0; };
constexpr auto hasContours = [](const Scene& s) { return !isPlain(s) && drawsContours(s); };
constexpr auto storesLight = [](const Scene& s) { return giChoiceOf(s).wanted; };
constexpr auto storesTransfer = [](const Scene& s) { return giChoiceOf(s).sky == GiMode::transfer; };
constexpr auto storesIrradiance = [](const Scene& s) {
  const GiChoice choice = giChoiceOf(s);
  return choice.lamps || (choice.sky != GiMode::off && choice.sky != GiMode::transfer);
};
constexpr auto hasProbe = [](const Scene& s) { return !s.light.environment.file.empty(); };
constexpr auto traces = [](const Scene& s) { return giChoiceOf(s).bounces > 0; };
constexpr auto hasAlbedoMap = [](const Scene& s) { return s.isosurface.albedoSource == AlbedoSource::map; };
constexpr auto hasOwnAlbedo = [](const Scene& s) { return s.isosurface.albedoSource == AlbedoSource::color; };
constexpr auto isCombined = [](const Scene& s) { return s.source.csg != Csg::none; };

#define ISOLUX_LAMP_RULES(n)                                                                               \
  Rule{"lamp" #n ".kind", [](const Scene& s) { return s.lamp##n.shown; }, noLamp},                         \
      Rule{"lamp" #n ".position", [](const Scene& s) { return s.lamp##n.shown; }, noLamp},                 \
      Rule{"lamp" #n ".position", [](const Scene& s) { return s.lamp##n.kind != LampKind::directional; },  \
           "the lamp is distant"},                                                                         \
      Rule{"lamp" #n ".direction", [](const Scene& s) { return s.lamp##n.shown; }, noLamp},                \
      Rule{"lamp" #n ".direction", [](const Scene& s) { return s.lamp##n.kind == LampKind::directional; }, \
           "the lamp has a position"},                                                                     \
      Rule{"lamp" #n ".radius", [](const Scene& s) { return s.lamp##n.shown; }, noLamp},                   \
      Rule{"lamp" #n ".radius", [](const Scene& s) { return s.lamp##n.kind == LampKind::sphere; },         \
           "the lamp is no sphere"},                                                                       \
      Rule{"lamp" #n ".angle", [](const Scene& s) { return s.lamp##n.shown; }, noLamp},                    \
      Rule{"lamp" #n ".angle", [](const Scene& s) { return s.lamp##n.kind == LampKind::directional; },     \
           "the lamp is not distant"},                                                                     \
      Rule{"lamp" #n ".color", [](const Scene& s) { return s.lamp##n.shown; }, noLamp}, Rule {             \
    "lamp" #n ".intensity", [](const Scene& s) { return s.lamp##n.shown; }, noLamp                         \
  }

// All rules that cover a path must hold; the first that fails says why.
const std::array rules = {
    Rule{"source.mesh_voxels", isMesh, "the source is not a triangle mesh"},
    Rule{"source.csg_path", isCombined, oneVolume},
    Rule{"source.csg_value", isCombined, oneVolume},

    Rule{"isosurface.inside", needsGradient, "depth is the same from either side"},
    Rule{"isosurface.albedo", showsAlbedo, noAlbedo},
    Rule{"isosurface.albedo", hasOwnAlbedo, "the albedo comes from a colour map"},
    Rule{"isosurface.albedo_source", showsAlbedo, noAlbedo},
    Rule{"isosurface.albedo_map", hasAlbedoMap, noAlbedoMap},
    Rule{"isosurface.albedo_map", showsAlbedo, noAlbedo},
    Rule{"isosurface.albedo_low", hasAlbedoMap, noAlbedoMap},
    Rule{"isosurface.albedo_low", showsAlbedo, noAlbedo},
    Rule{"isosurface.albedo_high", hasAlbedoMap, noAlbedoMap},
    Rule{"isosurface.albedo_high", showsAlbedo, noAlbedo},
    Rule{"isosurface.layers", isTransparent, "every isosurface is opaque"},
    Rule{"isosurface2.value", isShown2, hidden},
    Rule{"isosurface2.albedo", isShown2, hidden},
    Rule{"isosurface2.albedo", showsAlbedo, noAlbedo},
    Rule{"isosurface2.albedo", hasOwnAlbedo, "the albedo comes from a colour map"},
    Rule{"isosurface2.opacity", isShown2, hidden},
    Rule{"isosurface3.value", isShown3, hidden},
    Rule{"isosurface3.albedo", isShown3, hidden},
    Rule{"isosurface3.albedo", showsAlbedo, noAlbedo},
    Rule{"isosurface3.albedo", hasOwnAlbedo, "the albedo comes from a colour map"},
    Rule{"isosurface3.opacity", isShown3, hidden},
    Rule{"isosurface4.value", isShown4, hidden},
    Rule{"isosurface4.albedo", isShown4, hidden},
    Rule{"isosurface4.albedo", showsAlbedo, noAlbedo},
    Rule{"isosurface4.albedo", hasOwnAlbedo, "the albedo comes from a colour map"},
    Rule{"isosurface4.opacity", isShown4, hidden},

    Rule{"hit.rate", isSampled, exactHits},
    Rule{"hit.near_factor", isSampled, exactHits},
    Rule{"hit.near_threshold", isSampled, exactHits},
    Rule{"hit.refinements", isSampled, exactHits},
    Rule{"hit.near_threshold", [](const Scene& s) { return s.hit.nearFactor > 1.0; },
         "the samples near the isovalue are no denser than the others"},

    Rule{"derivatives.", needsGradient, "this look needs no derivatives"},
    Rule{"derivatives.fetch", [](const Scene& s) { return s.derivatives.field != Field::trilinear; },
         "trilinear derivatives are read in one way only"},
    Rule{"derivatives.noise", needsCurvature, "this look needs no curvature"},

    Rule{"look.shading", [](const Scene& s) { return isColored(s.look.mode); },
         "this look is a shading itself, or shows a raw quantity"},
    Rule{"look.ambient", hasLocalLight, notLocal},
    Rule{"look.ambient", hasBrightness, toneOnly},
    Rule{"look.ambient_variation", hasLocalLight, notLocal},
    Rule{"look.ambient_variation", hasBrightness, toneOnly},
    Rule{"look.specular", hasHighlight, noHighlight},
    Rule{"look.shininess", hasHighlight, noHighlight},
    Rule{"look.shininess", [](const Scene& s) { return s.look.specular > 0.0; },
         "the highlight has no strength"},
    Rule{"look.tone_cool", usesTone, noTone},
    Rule{"look.tone_warm", usesTone, noTone},
    Rule{"look.texture", showsAlbedo, noAlbedo},
    Rule{"look.texture_scale", showsAlbedo, noAlbedo},
    Rule{"look.texture_scale", [](const Scene& s) { return s.look.texture != SolidTexture::none; },
         "there is no texture"},
    Rule{"look.shadow", hasLocalLight, notLocal},
    Rule{"look.shadow", keyLightActs, "the key light brightens nothing"},
    Rule{"look.fog", isNotPlain, plain},
    Rule{"look.fog_color", isNotPlain, plain},
    Rule{"look.fog_color", [](const Scene& s) { return s.look.fog > 0.0; }, "there is no fog"},

    Rule{"look.colormap",
         [](const Scene& s) { return isMeasure(s.look.mode) && s.look.mode != LookMode::curvature_2d; },
         "this look does not show one number in colour"},
    Rule{"look.range_low", colorsMeanNumbers, noNumbers},
    Rule{"look.range_high", colorsMeanNumbers, noNumbers},
    Rule{"look.curvature_points", [](const Scene& s) { return s.look.mode == LookMode::curvature_2d; },
         "the look is not curvature 2D"},
    Rule{"look.legend", colorsMeanNumbers, noNumbers},

    Rule{"look.accessibility", isNotPlain, plain},
    Rule{"look.accessibility", [](const Scene& s) { return s.look.mode != LookMode::accessibility; },
         "the look shows accessibility at full strength"},
    Rule{"look.ridges", isNotPlain, plain},
    Rule{"look.ridge_threshold", hasRidges, noRidges},
    Rule{"look.ridge_color", hasRidges, noRidges},
    Rule{"look.valley_color", hasRidges, noRidges},
    Rule{"look.contours", isNotPlain, plain},
    Rule{"look.suggestive_contours", isNotPlain, plain},
    Rule{"look.contour_width", hasContours, noContours},
    Rule{"look.contour_color", hasContours, noContours},

    Rule{"flow.strength", isNotPlain, plain},
    Rule{"flow.strength", [](const Scene& s) { return s.look.mode != LookMode::flow; },
         "the look shows flow at full strength"},
    Rule{"flow.direction", showsFlow, noFlow},
    Rule{"flow.length", showsFlow, noFlow},
    Rule{"flow.grain", showsFlow, noFlow},
    Rule{"flow.animate", showsFlow, noFlow},
    Rule{"flow.speed", showsFlow, noFlow},
    Rule{"flow.time", showsFlow, noFlow},

    Rule{"light.space", hasLocalLight, notLocal},
    Rule{"light.direction", hasLocalLight, notLocal},
    Rule{"light.color", hasLocalLight, notLocal},
    Rule{"light.color", hasBrightness, toneOnly},
    Rule{"light.intensity", hasLocalLight, notLocal},
    Rule{"light.intensity", hasBrightness, toneOnly},
    Rule{"light.headlight", hasLocalLight, notLocal},
    Rule{"light.headlight", hasBrightness, toneOnly},

    Rule{"light.environment.", usesGi, noGi},
    Rule{"light.environment.constant", [](const Scene& s) { return !hasProbe(s); }, "there is a light probe"},
    Rule{"light.environment.rotation", hasProbe, "a sky of one colour looks the same however it is turned"},
    Rule{"light.environment.moves", hasProbe, "a sky of one colour may change anyway"},
    Rule{"light.environment.moves", [](const Scene& s) { return s.gi.mode == GiMode::automatic; },
         "gi.mode says what is stored"},

    Rule{"lamp1.", usesGi, noGi},
    Rule{"lamp2.", usesGi, noGi},
    Rule{"lamp3.", usesGi, noGi},
    ISOLUX_LAMP_RULES(1),
    ISOLUX_LAMP_RULES(2),
    ISOLUX_LAMP_RULES(3),

    Rule{"gi.", usesGi, noGi},
    Rule{"gi.extent", storesLight, nothingStored},
    Rule{"gi.band", storesLight, nothingStored},
    Rule{"gi.band", [](const Scene& s) { return s.gi.extent == GiExtent::band; },
         "texels are not chosen by isovalue"},
    Rule{"gi.samples", storesLight, nothingStored},
    Rule{"gi.sequence", storesLight, nothingStored},
    Rule{"gi.bounces",
         [](const Scene& s) { return s.gi.mode != GiMode::vicinity && s.gi.mode != GiMode::shadow; },
         "gi.mode is direct light only"},
    Rule{"gi.bounces", [](const Scene& s) { return s.gi.mode != GiMode::off; }, nothingStored},
    Rule{"gi.roulette_depth", traces, "no bounces are traced"},
    Rule{"gi.roulette_depth", [](const Scene& s) { return s.gi.rouletteDepth < s.gi.bounces; },
         "paths end before that bounce"},
    Rule{"gi.environment_share", storesIrradiance, "no irradiance is stored"},
    Rule{"gi.environment_share", hasProbe, "a sky of one colour has no bright places"},
    Rule{"gi.lattice_scale", storesLight, nothingStored},
    Rule{"gi.interpolation", storesLight, nothingStored},
    Rule{"gi.precision", storesIrradiance, "no irradiance is stored"},
    Rule{"gi.sh_order", storesTransfer, noTransfer},
    Rule{"gi.sh_window", storesTransfer, noTransfer},
    Rule{"gi.components", storesTransfer, noTransfer},
    Rule{"gi.component_bits", storesTransfer, noTransfer},
    Rule{"gi.threads", storesLight, nothingStored},

    Rule{"picture.exposure", usesGi, noGi},
    Rule{"picture.motion_target", [](const Scene& s) { return s.picture.adaptive; },
         "pictures in motion are not reduced"},
    Rule{"memory.gpu_budget_mb",
         [](const Scene& s) { return s.memory.layout != MemoryLayout::whole || storesLight(s); },
         "the volume is kept whole"},
};

}  // namespace

std::string_view whyInactive(std::string_view path, const Scene& scene) {
  for (const Rule& rule : rules)
    if (covers(rule, path) && !rule.acts(scene)) return rule.otherwise;
  return {};
}

}  // namespace isolux::scene
