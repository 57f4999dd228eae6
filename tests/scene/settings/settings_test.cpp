#include "scene/settings/settings.h"
#include "scene/settings/assignment.h"
#include "scene/settings/scene_list.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/error.h"

namespace isolux::scene {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::AnyOf;
using testing::HasSubstr;

// The message of the Error that `body` throws, with its kind checked; fails the test when it throws none.
template <class Body>
std::string usageMessage(Body body) {
  try {
    body();
  } catch (const base::Error& error) {
    EXPECT_EQ(error.kind(), base::ErrorKind::usage);
    return error.what();
  }
  ADD_FAILURE() << "no base::Error was thrown";
  return {};
}

// A value other than the default, allowed by the setting.
json otherValue(const Setting& s) {
  const double third = s.minimum + (s.maximum - s.minimum) / 3.0;
  switch (s.type) {
    case SettingType::number:
      return third;
    case SettingType::integer:
      return std::floor(third) == s.defaultValue() ? std::floor(third) + 1 : std::floor(third);
    case SettingType::text:
      return "other text";
    case SettingType::choice:
      return s.defaultValue() == s.choices.back() ? s.choices.front() : s.choices.back();
    case SettingType::pair:
      return {s.minimum, third};
    case SettingType::vector:
      return {s.minimum, third, s.maximum};
    case SettingType::quaternion:
      return {s.minimum, third, s.maximum, third};
    case SettingType::toggle:
      return !s.defaultValue().get<bool>();
    case SettingType::positions:
      return json::array({{1.0, -2.5, 3.0}, {4.0, 5.0, 6.0}});
    case SettingType::planes:
      return json::array({{1.0, -2.5, 3.0, 0.0, 0.6, -0.8}});
    case SettingType::marks:
      return json::array({{{"kind", "distance"},
                           {"name", "a"},
                           {"points", {{1.0, -2.5, 3.0}, {4.0, 5.0, 6.0}}},
                           {"color", {0.25, 0.5, 1.0}},
                           {"shown", false}}});
    case SettingType::points:
      return json::array({{0.5, -0.5, 0.25, 0.5, 1.0}});
    case SettingType::color_points:
      return json::array({{0.0, 0.25, 0.5, 1.0}, {1.0, 1.0, 0.5, 0.25}});
    case SettingType::item:
    case SettingType::ids:
      break;  // not in settings(): scene_list_test.cpp
  }
  return {};
}

TEST(Settings, SurfacesAreMattUnlessAsked) {
  const Scene scene;
  EXPECT_EQ(scene.surfaces.front().specular, 0.0);
  for (std::size_t place = 1; place < kSurfaces; ++place) {
    EXPECT_EQ(newSurface(place).specular, 0.0);
    EXPECT_EQ(newSurface(place).roughness, scene.surfaces.front().roughness);
    EXPECT_NE(newSurface(place).albedo, Surface().albedo);
  }
}

TEST(Settings, CoversEveryMemberOfScene) {
  // A new member of a struct does not compile here until it is counted; then the list must grow with it.
  const Scene scene;
  const auto& [source, surfaces, isosurface, pieces, clip, slice, marks, hit, derivatives, edge, colorVolume,
               look, flow, light, lamps, gi, camera, picture] = scene;
  [[maybe_unused]] const auto& [path, raw, series, component, timeStep, kindOfData, volumeLevel, aroundDamage,
                                meshVoxels, labels, smoothing, labelNames, csg, csgPath, csgValue,
                                csgWeight] = source;
  [[maybe_unused]] const auto& [suggestion, inside, albedoSource, albedoMap, albedoLow, albedoHigh, layers,
                                ghostOpacity] = isosurface;
  [[maybe_unused]] const auto& [id, name, shown, value, albedo, specularity, roughness, opacity, facing,
                                clipped, ghost, ownLabels, ownSmoothing, labelColors] = surfaces.front();
  [[maybe_unused]] const auto& [method, hitField, rate, nearFactor, nearThreshold, refinements] = hit;
  [[maybe_unused]] const auto& [field, fetch, noise, scale, normalScale] = derivatives;
  [[maybe_unused]] const auto& [keep, smallest, hidden, only, within, depth] = pieces;
  [[maybe_unused]] const auto& [planes, box, boxRotation, removed, cap] = clip;
  [[maybe_unused]] const auto& [level, width, sliceMap, sliceField, slab, slabMode, convention, sliceContours,
                                noiseBand, slicePosition] = slice;
  [[maybe_unused]] const auto& [search, contrast] = edge;
  [[maybe_unused]] const auto& [colorPath, colorRaw, colorComponent, colorTimeStep, colorField, colorMap,
                                colorLow, colorHigh, below, colorStrength, fade, isolines, isolineWidth] =
      colorVolume;
  [[maybe_unused]] const auto& [mode, shading, ambient, ambientVariation, specular, shininess, innerTint,
                                cool, warm, texture, textureScale, shadow, occlusion, occlusionRadius, fog,
                                fogColor, colormap, mapPoints, low, high, points, legend, legendCorner,
                                accessibility, accessibilityPoints, overlay, ridges, ridgeThreshold,
                                ridgeWidth, ridgeWidthUnit, ridgeLength, ridgeColor, valleyColor, contours,
                                suggestive, contourWidth, contourColor, top, bottom] = look;
  [[maybe_unused]] const auto& [strength, flowDirection, length, grain, animate, speed, time] = flow;
  [[maybe_unused]] const auto& [setup, space, direction, color, intensity, fill, rim, headlight,
                                environment] = light;
  [[maybe_unused]] const auto& [file, constant, builtIn, azimuth, elevation, rotation, exposure, moves,
                                visible, skyShadows] = environment;
  [[maybe_unused]] const auto& [lampId, lampName, lampShown, kind, position, toward, radius, angle, lampColor,
                                lampIntensity, lampShadows] = scene::Lamp{};
  [[maybe_unused]] const auto& [giMode, extent, band, texels, samples, sequence, bounces, rouletteDepth,
                                environmentShare, latticeScale, interpolation, precision, shOrder, shWindow,
                                components, componentBits, ground] = gi;
  [[maybe_unused]] const auto& [eye, target, up, frames, fov, projection] = camera;
  [[maybe_unused]] const auto& [supersampling, restHits, pictureExposure, metering, curve, letters, scaleBar,
                                isovalue, caveats, transparent, pixelRatio] = picture;
  EXPECT_EQ(settings().size(), 16u + 8 + 6 + 5 + 10 + 1 + 6 + 5 + 2 + 13 + 39 + 7 + 8 + 10 + 17 + 6 + 11);
  ASSERT_EQ(sceneLists().size(), 2u);
  EXPECT_EQ(sceneLists()[0].fields.size(), 13u);  // all of a surface but its id
  EXPECT_EQ(sceneLists()[1].fields.size(), 10u);  // all of a lamp but its id
}

TEST(Settings, PatternsCoverPathsGroupsAndItemsOfLists) {
  EXPECT_TRUE(covers("camera.fov", "camera.fov"));
  EXPECT_FALSE(covers("camera.fov", "camera.fovy"));
  EXPECT_TRUE(covers("light.", "light.environment.file"));
  EXPECT_FALSE(covers("light.", "lights.file"));
  EXPECT_FALSE(covers("light.", "light."));
  EXPECT_TRUE(covers("lamps.#.kind", "lamps.key.kind"));
  EXPECT_FALSE(covers("lamps.#.kind", "lamps.kind"));
  EXPECT_FALSE(covers("lamps.#.kind", "lamps..kind"));
  EXPECT_FALSE(covers("lamps.#.kind", "lamps.key.kinds"));
  EXPECT_TRUE(covers("surfaces.", "surfaces.main.opacity"));
  EXPECT_FALSE(covers("isosurface.", "isosurface4.opacity"));
}

TEST(Settings, ListsTheContractPaths) {
  for (const char* path : {"source.path",
                           "light.environment.file",
                           "light.environment.constant",
                           "light.environment.builtin",
                           "light.environment.azimuth",
                           "light.environment.elevation",
                           "light.environment.rotation",
                           "light.environment.exposure",
                           "gi.mode",
                           "gi.extent",
                           "gi.band",
                           "gi.texels",
                           "gi.samples",
                           "gi.bounces",
                           "gi.lattice_scale",
                           "gi.interpolation",
                           "gi.sh_order",
                           "source.raw",
                           "source.series",
                           "source.component",
                           "source.time_step",
                           "isosurface.value",
                           "isosurface.inside",
                           "isosurface.albedo",
                           "hit.method",
                           "hit.rate",
                           "hit.refinements",
                           "hit.field",
                           "derivatives.field",
                           "derivatives.fetch",
                           "look.ridges",
                           "look.contours",
                           "look.fog",
                           "look.mode",
                           "look.ambient",
                           "look.specular",
                           "look.shininess",
                           "look.background_top",
                           "look.background_bottom",
                           "light.direction",
                           "light.intensity",
                           "camera.eye",
                           "camera.target",
                           "camera.up",
                           "camera.fov",
                           "camera.projection",
                           "picture.supersampling"})
    EXPECT_EQ(setting(path).path, path);
}

TEST(Settings, PathsAreUniqueAndGrouped) {
  std::set<std::string> paths, closedGroups;
  std::string group;
  for (const Setting& s : settings()) {
    EXPECT_TRUE(paths.insert(s.path).second) << s.path;
    EXPECT_FALSE(s.meaning.empty()) << s.path;
    EXPECT_EQ(s.meaning.back(), '.') << s.path;
    const std::string its = s.path.substr(0, s.path.find('.'));
    if (its == group) continue;
    EXPECT_TRUE(closedGroups.insert(its).second) << s.path << " stands apart from its group";
    group = its;
  }
}

TEST(Settings, EachChangesTheSceneAndOnlyItself) {
  for (const Setting& s : settings()) {
    Scene changed;
    s.set(changed, otherValue(s));
    EXPECT_FALSE(changed == Scene{}) << s.path << " changes nothing";
    EXPECT_EQ(s.get(changed), otherValue(s)) << s.path;
    for (const Setting& other : settings())
      if (other.path != s.path) {
        EXPECT_EQ(other.get(changed), other.defaultValue()) << s.path << " changes " << other.path;
      }
  }
}

TEST(Settings, DefaultsAreAllowedAndDoNothing) {
  for (const Setting& s : settings()) {
    Scene scene;
    EXPECT_NO_THROW(s.set(scene, s.defaultValue())) << s.path;
    EXPECT_TRUE(scene == Scene{}) << s.path;
  }
}

TEST(Settings, RangesAreInclusiveAndEnforced) {
  for (const Setting& s : settings()) {
    if (s.type != SettingType::number && s.type != SettingType::integer && componentsOf(s.type) == 0)
      continue;
    ASSERT_LT(s.minimum, s.maximum) << s.path;
    const auto shaped = [&](double value) {
      json list = json::array({value, s.maximum, s.minimum, 1.0});
      if (s.type == SettingType::pair)
        return value > s.maximum ? json({s.minimum, value}) : json({value, s.maximum});
      if (componentsOf(s.type) > 0) list.get_ref<json::array_t&>().resize(componentsOf(s.type));
      return componentsOf(s.type) > 0 ? list : json(value);
    };
    Scene scene;
    EXPECT_NO_THROW(s.set(scene, shaped(s.minimum))) << s.path;
    EXPECT_NO_THROW(s.set(scene, shaped(s.maximum))) << s.path;
    const Scene before = scene;
    for (const double outside :
         {s.minimum - (1 + std::abs(s.minimum) / 1e9), s.maximum + (1 + s.maximum / 1e9),
          std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
          -std::numeric_limits<double>::infinity()})
      EXPECT_THAT(usageMessage([&] { s.set(scene, shaped(outside)); }),
                  AllOf(HasSubstr(s.path), AnyOf(HasSubstr("; must be "), HasSubstr("; choose "))));
    EXPECT_TRUE(scene == before) << s.path << ": a refused value left a trace";
  }
}

TEST(Settings, TypesAreStrict) {
  const std::vector<json> wrong{nullptr,
                                json::object(),
                                json::array(),
                                json::array({1, 2}),
                                json::array({1, 2, "3"}),
                                json::array({1, 2, 3, 4})};
  for (const Setting& s : settings()) {
    Scene scene;
    const auto expectRefused = [&](const json& value, const std::string& part) {
      EXPECT_THAT(usageMessage([&] { s.set(scene, value); }), AllOf(HasSubstr(s.path), HasSubstr(part)));
    };
    for (const json& value : wrong)
      if (value.size() != componentsOf(s.type) || !value.is_array() ||
          (value.empty() && s.type != SettingType::positions && s.type != SettingType::planes &&
           s.type != SettingType::marks))
        expectRefused(value, s.type == SettingType::choice ? "; choose " : "; must be ");
    if (s.type != SettingType::toggle) expectRefused(true, " value true; ");
    const bool takesWords = s.type == SettingType::text || s.type == SettingType::choice;
    if (s.type != SettingType::text) expectRefused("nonsense", "\"nonsense\"");
    if (takesWords) expectRefused(3, " value 3; ");
    if (s.type == SettingType::integer) expectRefused(s.minimum + 0.5, "whole number");
    EXPECT_TRUE(scene == Scene{}) << s.path;
  }
}

TEST(Settings, AutomaticOnlyWhereAllowed) {
  std::set<std::string> automatic;
  for (const Setting& s : settings()) {
    Scene scene;
    if (s.mayBeAutomatic) {
      automatic.insert(s.path);
      s.set(scene, otherValue(s));
      s.set(scene, "auto");
      EXPECT_TRUE(scene == Scene{}) << s.path;
      EXPECT_EQ(s.defaultValue(), "auto");
    } else if (s.type != SettingType::text &&
               std::find(s.choices.begin(), s.choices.end(), "auto") == s.choices.end()) {
      EXPECT_THROW(s.set(scene, "auto"), base::Error) << s.path;
    }
  }
  EXPECT_EQ(automatic, (std::set<std::string>{"source.csg_value",
                                              "isosurface.albedo_low",
                                              "isosurface.albedo_high",
                                              "gi.band",
                                              "gi.environment_share",
                                              "picture.exposure",
                                              "hit.near_threshold",
                                              "edge.search",
                                              "color.low",
                                              "color.high",
                                              "pieces.within",
                                              "slice.level",
                                              "slice.width",
                                              "slice.position",
                                              "derivatives.noise",
                                              "derivatives.scale",
                                              "derivatives.normal_scale",
                                              "look.texture_scale",
                                              "look.occlusion_radius",
                                              "look.fog_color",
                                              "look.range_low",
                                              "look.range_high",
                                              "look.curvature_points",
                                              "look.colormap_points",
                                              "look.accessibility_points",
                                              "look.ridge_threshold",
                                              "look.ridge_length",
                                              "look.contours",
                                              "camera.eye",
                                              "camera.target",
                                              "camera.up",
                                              "light.environment.constant"}));
}

TEST(Settings, ChoicesNameWhatIsAllowed) {
  Scene scene;
  EXPECT_THAT(
      usageMessage([&] { setting("look.mode").set(scene, "shiny"); }),
      AllOf(HasSubstr("look.mode"), HasSubstr("\"shiny\""), HasSubstr("blinn_phong, lambert, tone, kappa1")));
}

TEST(Settings, DirectionsMustNotBeZero) {
  for (const char* path : {"light.direction", "camera.up"}) {
    Scene scene;
    EXPECT_THAT(usageMessage([&] { setting(path).set(scene, {0, 0, 0}); }), HasSubstr("zero"));
    EXPECT_TRUE(scene == Scene{});
  }
}

TEST(Settings, TextsAreBounded) {
  Scene scene;
  EXPECT_THROW(setting("source.path").set(scene, std::string(5000, 'x')), base::Error);
  EXPECT_THROW(setting("source.path").set(scene, std::string("a\0b", 3)), base::Error);
}

TEST(Settings, AnEmptyListOfPointsIsRefusedAndOneIsTheLeast) {
  Scene scene;
  EXPECT_THAT(usageMessage([&] { setting("look.curvature_points").set(scene, nlohmann::json::array()); }),
              AllOf(HasSubstr("invalid value (a list of 0)"), HasSubstr("a list of 1 to 64 points")));
  setting("look.curvature_points").set(scene, {{0.0, 0.0, 0.5, 0.5, 0.5}});
  EXPECT_EQ(scene.look.curvaturePoints->size(), 1u);
}

TEST(Settings, PositionsAreTypedAsTheyAreRead) {
  const Setting hidden = setting("pieces.hidden");
  Scene scene;
  hidden.set(scene, valueOf(hidden, "pieces.hidden= 1,2.5,-3e-7 ; 4,5,6;"));
  EXPECT_EQ(scene.pieces.hidden, (std::vector{glm::dvec3(1.0, 2.5, -3e-7), glm::dvec3(4.0, 5.0, 6.0)}));
  EXPECT_EQ(positionsOf(textOfPositions(hidden.get(scene))), hidden.get(scene));
  hidden.set(scene, valueOf(hidden, "pieces.hidden=[[7,8,9]]"));
  EXPECT_EQ(scene.pieces.hidden, std::vector{glm::dvec3(7.0, 8.0, 9.0)});
  for (const char* wrong : {"1,2", "1,2,3,4", "1,2,x", "1,2,3;4", "[1,2,3]", "[[1,2]]", "1,2,1e30"}) {
    EXPECT_THAT(
        usageMessage([&] { hidden.set(scene, valueOf(hidden, std::string("pieces.hidden=") + wrong)); }),
        HasSubstr("points x,y,z; x,y,z"))
        << wrong;
  }
  hidden.set(scene, valueOf(hidden, "pieces.hidden="));
  EXPECT_TRUE(scene.pieces.hidden.empty());
}

TEST(Settings, UnknownPathsGetASuggestion) {
  EXPECT_THAT(usageMessage([] { setting("isosurface.valeu"); }),
              AllOf(HasSubstr("isosurface.valeu"), HasSubstr("did you mean isosurface.value?")));
  EXPECT_THAT(usageMessage([] { setting("fov"); }), HasSubstr("camera.fov"));
  EXPECT_THAT(usageMessage([] { setting("view.fov"); }), HasSubstr("camera.fov"));
  EXPECT_THAT(usageMessage([] { setting("quite.another_thing"); }), HasSubstr("isolux settings"));
  EXPECT_THAT(usageMessage([] { setting(std::string(100000, 'x')); }), HasSubstr("unknown"));
}

TEST(Assignment, ReadsEachType) {
  Scene scene;
  applyAssignment(scene, "isosurface.value=-300.5");
  applyAssignment(scene, "hit.refinements=7");
  applyAssignment(scene, "look.mode=normal");
  applyAssignment(scene, "camera.eye= 0, -4e2 ,+1.5");
  applyAssignment(scene, "source.path=a=b, c.nii");
  applyAssignment(scene, " camera.fov = 45 ");
  EXPECT_EQ(scene.surfaces.front().value, -300.5);
  EXPECT_EQ(scene.hit.refinements, 7);
  EXPECT_EQ(scene.look.mode, LookMode::normal);
  EXPECT_EQ(scene.camera.eye, glm::dvec3(0, -400, 1.5));
  EXPECT_EQ(scene.source.path, "a=b, c.nii");
  EXPECT_EQ(scene.camera.fov, 45.0);
  applyAssignment(scene, "isosurface.value=auto");
  EXPECT_FALSE(scene.surfaces.front().value);
  applyAssignment(scene, "source.series=auto");
  EXPECT_EQ(scene.source.series, "auto") << "auto is an ordinary text for a text";
}

TEST(Assignment, RefusesNonsenseWithTheWord) {
  Scene scene;
  for (const char* bad :
       {"isosurface.value=", "isosurface.value=3x", "isosurface.value=nan", "isosurface.value=inf",
        "isosurface.value=1e999", "hit.refinements=2.5", "camera.eye=1,2", "camera.eye=1,2,3,4",
        "camera.eye=1,,3", "camera.eye=1,2,x", "look.mode=", "hit.rate=auto", "hit.rate=1 2"})
    EXPECT_THAT(usageMessage([&] { applyAssignment(scene, bad); }),
                AnyOf(HasSubstr("; must be "), HasSubstr("; choose ")))
        << bad;
  EXPECT_THAT(usageMessage([&] { applyAssignment(scene, "isosurface.value=3x"); }), HasSubstr("\"3x\""));
  EXPECT_THAT(usageMessage([&] { applyAssignment(scene, "isosurface.value"); }), HasSubstr("PATH=VALUE"));
  EXPECT_THAT(usageMessage([&] { applyAssignment(scene, "=3"); }), HasSubstr("unknown setting"));
  EXPECT_TRUE(scene == Scene{});
}

}  // namespace
}  // namespace isolux::scene
