// The frame graph and the declared passes: no GL.
#include "render/graph/frame_graph.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "render/passes/pass_declarations.h"
#include "scene/settings/settings.h"
#include "tests/support/surfaces.h"

namespace isolux::render {
namespace {

using ::testing::ElementsAre;

std::vector<std::string> namesOf(const std::vector<PassDeclaration>& passes,
                                 const std::vector<PlannedPass>& plan, PassState state) {
  std::vector<std::string> names;
  for (const PlannedPass& planned : plan)
    if (planned.state == state) names.push_back(passes[planned.index].name);
  return names;
}

class FrameGraphTest : public ::testing::Test {
 protected:
  std::vector<PlannedPass> frame(const std::vector<PassDeclaration>& passes,
                                 const std::vector<std::string>& wanted) {
    const auto plan = graph_.plan(passes, wanted);
    for (const PlannedPass& planned : plan)
      if (planned.state == PassState::ran) graph_.completed(passes[planned.index]);
    return plan;
  }
  // The passes that run when `scene` follows what was drawn before, lit by the key light alone.
  std::vector<std::string> ran(scene::Scene scene, const FrameRequest& request, const VolumeState& volume = 1,
                               const OnProcessor& onProcessor = {}) {
    if (!occludes_) scene.light.setup = scene::LightSetup::key;
    const auto passes = declarePasses(makePasses(), Asked(scene, request, volume, {}, {}, onProcessor));
    return namesOf(passes, frame(passes, wantedImages(request, scene)), PassState::ran);
  }
  FrameGraph graph_;
  bool occludes_ = false;  // as the scene says
};

// Shadows are found where hits and gradients are.
TEST_F(FrameGraphTest, ShadowsFollowTheExecutor) {
  scene::Scene scene;
  scene.look.shadow = 1.0;
  ran(scene, {}, 1, {true, true});
  EXPECT_THAT(ran(scene, {}, 1, {true, false}), ElementsAre("gradient", "shadow", "shade", "resolve"));
}

// Block faces are not rasterised, and another executor finds the hits anew.
TEST_F(FrameGraphTest, TheProcessorNeedsNoSegments) {
  const scene::Scene scene;
  const OnProcessor all{true, true};
  EXPECT_THAT(ran(scene, {}, 1, all),
              ElementsAre("blocks", "cast", "gradient", "shade", "background", "resolve"));
  EXPECT_THAT(ran(scene, {}, 1, all), ElementsAre());
  EXPECT_THAT(ran(scene, {}, 1), ElementsAre("segments", "cast", "gradient", "shade", "resolve"));
  EXPECT_THAT(ran(scene, {}, 1, {true, false}), ElementsAre("cast", "gradient", "shade", "resolve"));
  EXPECT_THAT(ran(scene, {}, 1, all), ElementsAre("gradient", "shade", "resolve"));
  // What lies behind depends on who casts and on who derives, which need not be the same.
  scene::Scene transparent;
  transparent.surfaces.front().opacity = 0.5;
  EXPECT_THAT(ran(transparent, {}, 1, {true, false}), ElementsAre("gradient", "shade", "layers", "resolve"));
}

// Curvature and normals at one scale share a pass; at two each has its own.
TEST_F(FrameGraphTest, NormalsAtAScaleOfTheirOwnHaveAPassOfTheirOwn) {
  scene::Scene scene;
  scene.look.mode = scene::LookMode::kappa1;
  scene.derivatives.scale = scene.derivatives.normalScale = 1.0;
  EXPECT_THAT(ran(scene, {}), ElementsAre("blocks", "segments", "cast", "hessian", "curvature", "ranges",
                                          "shade", "background", "resolve"));
  scene.derivatives.normalScale = 0.0;
  EXPECT_THAT(ran(scene, {}), ElementsAre("gradient", "shade", "resolve"));
  scene.derivatives.scale = 2.0;
  EXPECT_THAT(ran(scene, {}), ElementsAre("hessian", "curvature", "ranges", "shade", "resolve"));
  scene.derivatives.normalScale = 2.0;
  EXPECT_THAT(ran(scene, {}), ElementsAre("shade", "resolve"));
  scene.look.mode = scene::LookMode::lambert;  // reads no second derivatives
  EXPECT_THAT(ran(scene, {}), ElementsAre("gradient", "shade", "resolve"));
  scene.derivatives.scale = 3.0;
  EXPECT_THAT(ran(scene, {}), ElementsAre());
  scene.derivatives.normalScale = 1.0;
  EXPECT_THAT(ran(scene, {}), ElementsAre("gradient", "shade", "resolve"));
  // Deferred images: gradients are those of curvature, normals those of shading.
  FrameRequest request;
  request.color = false;
  request.aovs = std::vector{Aov::normal};
  EXPECT_THAT(ran(scene, request), ElementsAre());
  request.aovs = std::vector{Aov::gradient};
  EXPECT_THAT(ran(scene, request), ElementsAre("hessian"));
  request.aovs = {Aov::gradient, Aov::normal};
  EXPECT_THAT(ran(scene, request), ElementsAre());
  // The trilinear field has no scale.
  scene.derivatives.field = scene::Field::trilinear;
  request.aovs = {Aov::normal, Aov::kappa};
  EXPECT_THAT(ran(scene, request), ElementsAre("hessian", "curvature"));
}

TEST_F(FrameGraphTest, SkipsWhatNobodyReads) {
  const std::vector<PassDeclaration> passes = {
      {"a", {}, {"A"}, {}}, {"b", {"A"}, {"B"}, {}}, {"c", {"A"}, {"C"}, {}}, {"d", {"C"}, {"D"}, {}}};
  const auto plan = frame(passes, {"B"});
  EXPECT_THAT(namesOf(passes, plan, PassState::ran), ElementsAre("a", "b"));
  EXPECT_THAT(namesOf(passes, plan, PassState::skipped), ElementsAre("c", "d"));
  EXPECT_EQ(plan[3].reason, "nothing reads its D");
}

TEST_F(FrameGraphTest, RunsAgainOnlyBehindAChange) {
  std::vector<PassDeclaration> passes = {
      {"a", {}, {"A"}, {{"x", 1}}}, {"b", {}, {"B"}, {{"y", 1}}}, {"c", {"A", "B"}, {"C"}, {{"z", 1}}}};
  frame(passes, {"C"});
  EXPECT_THAT(namesOf(passes, frame(passes, {"C"}), PassState::cached), ElementsAre("a", "b", "c"));
  passes[1].parameters[0].hash = 2;
  const auto plan = frame(passes, {"C"});
  EXPECT_THAT(namesOf(passes, plan, PassState::ran), ElementsAre("b", "c"));
  EXPECT_EQ(plan[1].reason, "y changed");
  EXPECT_EQ(plan[2].reason, "B drawn anew");
}

TEST_F(FrameGraphTest, APassSkippedForAWhileSeesWhatItMissed) {
  std::vector<PassDeclaration> passes = {{"a", {}, {"A"}, {{"x", 1}}}, {"b", {"A"}, {"B"}, {}}};
  frame(passes, {"A", "B"});
  passes[0].parameters[0].hash = 2;
  EXPECT_THAT(namesOf(passes, frame(passes, {"A"}), PassState::ran), ElementsAre("a"));
  const auto plan = frame(passes, {"B"});
  EXPECT_THAT(namesOf(passes, plan, PassState::ran), ElementsAre("b"));
  EXPECT_EQ(plan[1].reason, "A drawn anew");
}

TEST_F(FrameGraphTest, InvalidateRunsEverything) {
  const std::vector<PassDeclaration> passes = {{"a", {}, {"A"}, {}}};
  frame(passes, {"A"});
  graph_.invalidate();
  EXPECT_EQ(frame(passes, {"A"})[0].state, PassState::ran);
}

// Which passes each change of the scene costs.
TEST_F(FrameGraphTest, EachChangeRunsExactlyThePassesBehindIt) {
  FrameRequest request;
  scene::Scene scene;
  scene.surfaces.front().value = 1.0;
  scene.camera.eye = glm::dvec3(0.0, -400.0, 0.0);
  EXPECT_THAT(ran(scene, request),
              ElementsAre("blocks", "segments", "cast", "gradient", "shade", "background", "resolve"));
  EXPECT_THAT(ran(scene, request), ElementsAre());  // a still picture costs nothing
  scene.surfaces.front().albedo.x = 0.5;
  EXPECT_THAT(ran(scene, request), ElementsAre("shade", "resolve"));
  scene.camera.eye->x = 10.0;  // orbiting does not rebuild blocks
  EXPECT_THAT(ran(scene, request), ElementsAre("segments", "cast", "gradient", "shade", "resolve"));
  scene.surfaces.front().value = 2.0;
  EXPECT_THAT(ran(scene, request), ElementsAre("blocks", "segments", "cast", "gradient", "shade", "resolve"));
  scene.derivatives.field = scene::Field::trilinear;
  EXPECT_THAT(ran(scene, request), ElementsAre("gradient", "shade", "resolve"));
  scene.hit.rate = 5.0;  // exact hits take no samples
  EXPECT_THAT(ran(scene, request), ElementsAre());
  scene.hit.method = scene::HitMethod::sampled;  // its brackets are refined
  EXPECT_THAT(ran(scene, request), ElementsAre("cast", "refine", "gradient", "shade", "resolve"));
  scene.hit.refinements = 1;
  EXPECT_THAT(ran(scene, request), ElementsAre("refine", "gradient", "shade", "resolve"));
  EXPECT_THAT(ran(scene, request, 2),
              ElementsAre("blocks", "segments", "cast", "refine", "gradient", "shade", "resolve"));
}

// Pieces that are hidden or shown again cost what another isovalue does: what rays meet is another surface.
TEST_F(FrameGraphTest, HiddenPiecesRunThePassesOfAnotherSurface) {
  FrameRequest request;
  scene::Scene scene;
  scene.look.shadow = 1.0;
  VolumeState volume(1);
  ran(scene, request, volume);
  EXPECT_THAT(ran(scene, request, volume), ElementsAre());
  volume.hidden = 7;
  EXPECT_THAT(ran(scene, request, volume),
              ElementsAre("blocks", "segments", "cast", "gradient", "shadow", "shade", "resolve"));
  EXPECT_THAT(ran(scene, request, volume), ElementsAre());
  scene.pieces.keep = 3;  // which happen to be the same
  EXPECT_THAT(ran(scene, request, volume), ElementsAre());
}

// Which passes each request needs from nothing.
TEST_F(FrameGraphTest, EachLookAndImageRunsExactlyItsPasses) {
  scene::Scene scene;
  FrameRequest picture;
  for (const auto mode : {scene::LookMode::blinn_phong, scene::LookMode::lambert, scene::LookMode::normal}) {
    scene.look.mode = mode;
    graph_.invalidate();
    EXPECT_THAT(ran(scene, picture),
                ElementsAre("blocks", "segments", "cast", "gradient", "shade", "background", "resolve"));
  }
  scene.look.mode = scene::LookMode::depth;
  graph_.invalidate();
  EXPECT_THAT(ran(scene, picture),
              ElementsAre("blocks", "segments", "cast", "shade", "background", "resolve"));
  FrameRequest depth;
  depth.color = false;
  depth.aovs = std::vector{Aov::depth};
  graph_.invalidate();
  EXPECT_THAT(ran(scene, depth), ElementsAre("blocks", "segments", "cast"));
  depth.aovs = std::vector{Aov::normal};
  EXPECT_THAT(ran(scene, depth), ElementsAre("gradient"));
  depth.aovs = {Aov::normal, Aov::kappa};  // the gradients come with the Hessians
  graph_.invalidate();
  EXPECT_THAT(ran(scene, depth), ElementsAre("blocks", "segments", "cast", "hessian", "curvature"));
  scene.derivatives.noise = 3.0;
  EXPECT_THAT(ran(scene, depth), ElementsAre("curvature"));
  depth.aovs = std::vector{Aov::hessian};
  graph_.invalidate();
  EXPECT_THAT(ran(scene, depth), ElementsAre("blocks", "segments", "cast", "hessian"));
}

TEST_F(FrameGraphTest, OnlyTransparentSurfacesHaveLayersBehindThem) {
  scene::Scene scene;
  FrameRequest picture;
  scene.surfaces.front().opacity = 0.5;
  EXPECT_THAT(ran(scene, picture), ElementsAre("blocks", "segments", "cast", "gradient", "shade", "layers",
                                               "background", "resolve"));
  scene.isosurface.layers = 3;
  EXPECT_THAT(ran(scene, picture), ElementsAre("layers", "resolve"));
  scene.surfaces.front().opacity = 1.0;
  EXPECT_THAT(ran(scene, picture), ElementsAre("shade", "resolve"));
  test::surfaceAt(scene, 1).opacity = 0.25;  // not shown
  EXPECT_THAT(ran(scene, picture), ElementsAre());
  test::surfaceAt(scene, 1).shown = true;
  EXPECT_THAT(ran(scene, picture),
              ElementsAre("blocks", "segments", "cast", "gradient", "shade", "layers", "resolve"));
}

TEST_F(FrameGraphTest, TheFieldOfTheHitsIsThatOfTheBlocks) {
  scene::Scene scene;
  FrameRequest picture;
  ran(scene, picture);
  scene.hit.field = scene::Field::cubic;
  EXPECT_THAT(ran(scene, picture), ElementsAre("blocks", "segments", "cast", "gradient", "shade", "resolve"));
}

// What stands near is looked for where a light is large and soft: under Lambert and Blinn-Phong shading.
TEST_F(FrameGraphTest, OcclusionHasPassesOfItsOwn) {
  occludes_ = true;
  scene::Scene scene;
  EXPECT_THAT(ran(scene, {}), ElementsAre("blocks", "segments", "cast", "gradient", "openness", "occlusion",
                                          "shade", "background", "resolve"));
  scene.light.fill = 0.7;
  EXPECT_THAT(ran(scene, {}), ElementsAre("shade", "resolve"));
  scene.look.occlusionRadius = 3.0;
  EXPECT_THAT(ran(scene, {}), ElementsAre("openness", "occlusion", "shade", "resolve"));
  for (const char* without :
       {"look.occlusion=0", "light.setup=key", "look.mode=gi", "look.mode=tone", "look.mode=normal"}) {
    scene::Scene other = scene;
    scene::applyAssignment(other, without);
    graph_.invalidate();
    EXPECT_THAT(ran(other, {}), ::testing::Not(::testing::Contains("openness"))) << without;
  }
}

// What each look computes from nothing, and what a change of it costs, as a table.
struct LookRow {
  std::vector<std::string> settings;
  std::vector<std::string> passes;  // between cast and background
};

const std::vector<std::string> kShaded = {"gradient", "shade"};
const std::vector<std::string> kCurved = {"hessian", "curvature", "shade"};
const std::vector<std::string> kRanged = {"hessian", "curvature", "ranges", "shade"};
const std::vector<std::string> kLined = {"hessian", "curvature", "line field", "lines", "shade"};
const std::vector<std::string> kShadowed = {"gradient", "shadow", "shade"};
const std::vector<std::string> kLit = {"gradient", "irradiance", "shade"};
const std::vector<std::string> kFlowing = {"hessian", "curvature", "ranges", "flow field", "flow", "shade"};

const std::vector<LookRow> kLooks = {
    {{"look.mode=blinn_phong"}, kShaded},
    {{"look.mode=lambert"}, kShaded},
    {{"look.mode=tone"}, kLined},  // with outlines
    {{"look.mode=tone", "look.contours=0"}, kShaded},
    {{"look.mode=kappa1"}, kRanged},
    {{"look.mode=kappa2"}, kRanged},
    {{"look.mode=mean_curvature"}, kRanged},
    {{"look.mode=gaussian_curvature"}, kRanged},
    {{"look.mode=shape_index"}, kCurved},  // always -1 to 1
    {{"look.mode=curvedness"}, kRanged},
    {{"look.mode=flowline_curvature"}, kRanged},
    {{"look.mode=curvature_2d"}, kRanged},
    {{"look.mode=accessibility"}, kRanged},
    {{"look.mode=edge_offset"}, {"gradient", "edge", "ranges", "shade"}},
    {{"look.mode=edge_offset", "look.range_low=-1", "look.range_high=1"}, {"gradient", "edge", "shade"}},
    {{"color.volume=phantom:ball"}, {"gradient", "second volume", "ranges", "shade"}},
    {{"color.volume=phantom:ball", "color.low=0", "color.high=1"}, {"gradient", "second volume", "shade"}},
    {{"color.volume=phantom:ball", "look.mode=shape_index"}, kCurved},  // of colours of its own
    {{"color.volume=phantom:ball", "color.strength=0"}, kShaded},
    {{"look.mode=flow"}, kFlowing},
    {{"look.mode=gi"}, kLit},
    {{"look.mode=shape_index", "look.shading=gi"}, {"hessian", "curvature", "irradiance", "shade"}},
    {{"look.mode=gi", "look.shadow=1"}, kLit},  // shadows are in the light
    {{"look.mode=gi", "isosurface.opacity=0.5"}, {"gradient", "irradiance", "shade", "layers"}},
    {{"look.mode=normal"}, kShaded},
    {{"look.mode=curvature_direction"}, kCurved},
    {{"look.mode=depth"}, {"shade"}},
    // What is fixed is not measured.
    {{"look.mode=kappa1", "look.range_low=-1"}, kRanged},
    {{"look.mode=kappa1", "look.range_low=-1", "look.range_high=1"}, kCurved},
    {{"look.mode=curvature_2d", "look.range_high=1"}, kCurved},
    // What is laid over.
    {{"look.texture=marble"}, kShaded},
    {{"look.fog=1"}, kShaded},
    {{"look.accessibility=1"}, kRanged},
    {{"look.overlay=blocks"}, kShaded},
    {{"look.ridges=1"}, {"hessian", "curvature", "ranges", "extrema", "line field", "lines", "shade"}},
    {{"look.ridges=1", "look.ridge_threshold=0.1"},
     {"hessian", "curvature", "extrema", "line field", "lines", "shade"}},
    {{"look.contours=1"}, kLined},
    {{"look.suggestive_contours=1"}, {"hessian", "curvature", "ranges", "line field", "lines", "shade"}},
    {{"flow.strength=1"}, kFlowing},
    {{"look.shadow=1"}, kShadowed},
    {{"look.shadow=1", "look.mode=tone", "look.contours=0"}, kShadowed},
    {{"look.shadow=1", "look.mode=curvedness"}, {"hessian", "curvature", "ranges", "shadow", "shade"}},
    {{"look.shadow=1", "look.mode=shape_index", "look.shading=unlit"}, kCurved},  // nothing is lit
    // Without a key light, or where it brightens nothing, nobody sees its shadow; tone has only its
    // direction.
    {{"look.shadow=1", "light.intensity=0"}, kShaded},
    {{"look.shadow=1", "light.color=0,0,0"}, kShaded},
    {{"look.shadow=1", "look.ambient=1"}, kShadowed},  // the highlight
    {{"look.shadow=1", "look.ambient=1", "look.specular=0"}, kShaded},
    {{"look.shadow=1", "look.ambient=1", "look.mode=lambert"}, kShaded},
    {{"look.shadow=1", "light.intensity=0", "look.mode=tone", "look.contours=0"}, kShadowed},
    // A surface of opacity 0 is not there, and what is behind it is not behind anything.
    {{"isosurface.opacity=0", "isosurface2.shown=1", "isosurface2.value=3", "isosurface2.opacity=1"},
     kShaded},
    {{"isosurface.opacity=0.5"}, {"gradient", "shade", "layers"}},
    {{"isosurface.opacity=0.5", "look.shadow=1", "look.mode=flow"},
     {"hessian", "curvature", "ranges", "shadow", "flow field", "flow", "shade", "layers"}},
    // Raw quantities: nothing is laid over them.
    {{"look.mode=normal", "look.shadow=1", "look.ridges=1", "look.contours=1", "look.accessibility=1",
      "flow.strength=1", "look.suggestive_contours=1"},
     kShaded},
    {{"look.mode=depth", "look.shadow=1", "look.ridges=1", "flow.strength=1"}, {"shade"}},
};

TEST_F(FrameGraphTest, EachLookFromNothing) {
  for (const LookRow& row : kLooks) {
    scene::Scene scene;
    std::string named;
    for (const std::string& setting : row.settings) {
      scene::applyAssignment(scene, setting);
      named += setting + " ";
    }
    std::vector<std::string> expected = {"blocks", "segments", "cast"};
    expected.insert(expected.end(), row.passes.begin(), row.passes.end());
    expected.insert(expected.end(), {"background", "resolve"});
    graph_.invalidate();
    EXPECT_EQ(ran(scene, {}), expected) << named;
    EXPECT_THAT(ran(scene, {}), ElementsAre()) << named;  // a still picture costs nothing
  }
}

// From a look that is drawn, one setting changes.
struct ChangeRow {
  std::vector<std::string> look;
  std::string change;
  std::vector<std::string> passes;
};

const std::vector<ChangeRow> kChanges = {
    {{}, "light.intensity=2", {"shade", "resolve"}},
    {{}, "light.direction=1,0,0", {"shade", "resolve"}},
    {{}, "look.background_top=1,0,0", {"background", "resolve"}},
    {{"look.fog=1"}, "look.background_top=1,0,0", {"shade", "background", "resolve"}},
    {{"look.fog=1", "look.fog_color=1,1,1"}, "look.background_top=1,0,0", {"background", "resolve"}},
    {{}, "look.colormap=gray", {}},  // no colours stand for numbers
    {{}, "look.tone_warm=1,0,0", {}},
    {{}, "flow.time=3", {}},
    {{}, "look.contour_width=5", {}},
    {{"look.mode=lambert"}, "look.specular=1", {}},
    {{"look.mode=tone"}, "light.intensity=2", {}},
    {{"look.mode=kappa1"}, "look.colormap=gray", {"shade", "resolve"}},
    {{"look.mode=kappa1"}, "look.legend=false", {"resolve"}},
    {{"look.mode=kappa1"}, "look.range_low=-1", {"shade", "resolve"}},
    {{"look.mode=kappa1"}, "isosurface.inside=below", {"curvature", "ranges", "shade", "resolve"}},
    {{"look.mode=kappa1"},
     "isosurface.value=5",
     {"blocks", "segments", "cast", "hessian", "curvature", "ranges", "shade", "resolve"}},
    {{"look.mode=kappa1"},
     "camera.eye=5,-300,0",
     {"segments", "cast", "hessian", "curvature", "shade", "resolve"}},  // ranges know no view
    {{"look.mode=kappa1"}, "derivatives.noise=5", {"curvature", "shade", "resolve"}},
    {{"look.mode=curvature_2d"}, "look.colormap=gray", {}},
    {{"look.mode=kappa1"}, "look.legend_corner=upper_left", {"resolve"}},
    {{"look.ridges=1"}, "look.ridge_color=1,0,0", {"shade", "resolve"}},
    {{"look.ridges=1"}, "look.ridge_width=4", {"lines", "shade", "resolve"}},
    {{"look.ridges=1"}, "look.ridge_length=4", {"lines", "shade", "resolve"}},
    {{"look.ridges=1"}, "look.ridge_threshold=4", {"line field", "lines", "shade", "resolve"}},
    {{"look.contours=1"}, "look.contour_width=5", {"line field", "lines", "shade", "resolve"}},
    {{"look.shadow=1"}, "light.direction=1,0,0", {"shadow", "shade", "resolve"}},
    {{"look.shadow=1"}, "light.intensity=2", {"shade", "resolve"}},
    {{"look.shadow=1"}, "isosurface.albedo=1,0,0", {"shade", "resolve"}},
    {{"look.mode=gi"}, "picture.exposure=2", {"shade", "resolve"}},
    {{"look.mode=gi"}, "light.direction=1,0,0", {}},
    {{"look.mode=gi"}, "isosurface.albedo=1,0,0", {"shade", "resolve"}},
    {{"look.mode=gi"},
     "camera.eye=5,-300,0",
     {"segments", "cast", "gradient", "irradiance", "shade", "resolve"}},
    {{}, "gi.interpolation=nearest", {}},
    {{"look.mode=flow"}, "flow.time=0.25", {"flow", "shade", "resolve"}},
    {{"look.mode=flow"}, "flow.time=1", {}},  // a whole period later
    {{"look.mode=flow"}, "flow.length=9", {"flow", "shade", "resolve"}},
    {{"look.mode=flow"}, "flow.grain=3", {"flow field", "flow", "shade", "resolve"}},
    {{"look.mode=flow"}, "flow.direction=minimum", {"flow field", "flow", "shade", "resolve"}},
    {{"look.mode=flow"}, "light.intensity=2", {"shade", "resolve"}},
    {{"look.mode=flow"},
     "camera.eye=5,-300,0",
     {"segments", "cast", "hessian", "curvature", "flow field", "flow", "shade", "resolve"}},
    {{"isosurface.opacity=0.5"}, "flow.time=3", {}},
    {{"isosurface.opacity=0.5"}, "light.intensity=2", {"shade", "layers", "resolve"}},
    {{"isosurface.opacity=0.5", "look.mode=flow"}, "flow.time=0.25", {"flow", "shade", "layers", "resolve"}},
};

TEST_F(FrameGraphTest, EachChangeOfALook) {
  for (const ChangeRow& row : kChanges) {
    scene::Scene scene;
    scene.surfaces.front().value = 1.0;
    scene.camera.eye = glm::dvec3(0.0, -400.0, 0.0);
    std::string named;
    for (const std::string& setting : row.look) {
      scene::applyAssignment(scene, setting);
      named += setting + " ";
    }
    graph_.invalidate();
    ran(scene, {});
    scene::applyAssignment(scene, row.change);
    EXPECT_EQ(ran(scene, {}), row.passes) << named << "then " << row.change;
  }
}

// What of the light changes costs only the passes behind it, and only where a look reads it.
TEST_F(FrameGraphTest, LightCostsThePassesBehindIt) {
  scene::Scene scene;
  scene.surfaces.front().value = 1.0;
  scene.look.mode = scene::LookMode::gi;
  FrameRequest request;
  LightState light;
  light.stored = true;
  light.version = 1;
  const auto ranUnder = [&] {
    const auto passes = declarePasses(scene, request, 1, {}, light);
    return namesOf(passes, frame(passes, wantedImages(request, scene)), PassState::ran);
  };
  EXPECT_THAT(ranUnder(), ElementsAre("blocks", "segments", "cast", "gradient", "light", "irradiance",
                                      "shade", "background", "resolve"));
  EXPECT_THAT(ranUnder(), ElementsAre());
  for (std::uint64_t* changed : {&light.skyRevision, &light.lampsRevision, &light.innerSkyRevision,
                                 &light.innerLampsRevision, &light.unfinished, &light.storage}) {
    ++*changed;  // more of it is baked, or there is more to upload
    EXPECT_THAT(ranUnder(), ElementsAre("light", "irradiance", "shade", "resolve"));
  }
  ++light.version;  // the environment turned
  EXPECT_THAT(ranUnder(), ElementsAre("irradiance", "shade", "resolve"));
  light.automaticExposure = 1.0f;
  EXPECT_THAT(ranUnder(), ElementsAre("shade", "resolve"));
  scene.gi.interpolation = scene::GiInterpolation::nearest;
  EXPECT_THAT(ranUnder(), ElementsAre("irradiance", "shade", "resolve"));
  scene.camera.eye = glm::dvec3(0.0, -300.0, 0.0);
  EXPECT_THAT(ranUnder(), ElementsAre("segments", "cast", "gradient", "irradiance", "shade", "resolve"));
  light.ground = 1;  // only of a scene with a ground
  EXPECT_THAT(ranUnder(), ElementsAre());
  scene.gi.ground = true;
  EXPECT_THAT(ranUnder(), ElementsAre("resolve"));
  ++light.ground;
  EXPECT_THAT(ranUnder(), ElementsAre("resolve"));
  scene.look.backgroundTop.x = 0.25;
  EXPECT_THAT(ranUnder(), ElementsAre("resolve"));
  scene.gi.ground = false;
  EXPECT_THAT(ranUnder(), ElementsAre("background", "resolve"));
  light.background = true;  // it stands behind the surface in place of the other
  EXPECT_THAT(ranUnder(), ElementsAre("resolve"));
  scene.look.backgroundTop.x = 0.5;
  EXPECT_THAT(ranUnder(), ElementsAre());
  ++light.version;
  EXPECT_THAT(ranUnder(), ElementsAre("irradiance", "shade", "resolve"));
  scene.surfaces.front().opacity = 0.5;  // its inner side has what light comes through
  EXPECT_THAT(ranUnder(), ElementsAre("irradiance", "shade", "layers", "resolve"));
  ++light.skyRevision;
  EXPECT_THAT(ranUnder(), ElementsAre("light", "irradiance", "shade", "layers", "resolve"));
  scene.surfaces.front().opacity = 0.25;
  EXPECT_THAT(ranUnder(), ElementsAre("irradiance", "shade", "layers", "resolve"));
  scene.look.mode = scene::LookMode::lambert;
  light.stored = false;
  ranUnder();
  ++light.version;
  ++light.skyRevision;
  EXPECT_THAT(ranUnder(), ElementsAre());
  request.color = false;
  request.aovs = std::vector{Aov::irradiance};
  light.stored = true;
  EXPECT_THAT(ranUnder(), ElementsAre("light", "irradiance"));
}

// Nothing can be hit: nothing of a surface is computed for the picture.
TEST_F(FrameGraphTest, AnIsovalueWithoutASurfaceCostsNoDerivatives) {
  for (const char* look : {"curvature_2d", "flow", "gi", "lambert"}) {
    scene::Scene scene;
    scene::applyAssignment(scene, std::string("look.mode=") + look);
    VolumeState nothing{1, 1};
    nothing.crossed = false;
    graph_.invalidate();
    const auto passes = declarePasses(scene, {}, nothing);
    EXPECT_THAT(namesOf(passes, frame(passes, wantedImages({}, scene)), PassState::ran),
                ElementsAre("blocks", "segments", "cast", "shade", "background", "resolve"))
        << look;
  }
}

// A new copy of equal voxels on the GPU has no active blocks and no resident bricks yet.
TEST_F(FrameGraphTest, WhatLivesInTheGpusCopyIsMadeAnewWithIt) {
  scene::Scene scene;
  scene.light.setup = scene::LightSetup::key;
  VolumeState volume{7, 1};
  const auto ranWith = [&](const BrickState& bricks) {
    const auto passes = declarePasses(scene, {}, volume, bricks);
    return namesOf(passes, frame(passes, wantedImages({}, scene)), PassState::ran);
  };
  ranWith({});
  ++volume.made;
  EXPECT_THAT(ranWith({}), ElementsAre("blocks", "segments", "cast", "gradient", "shade", "resolve"));
  EXPECT_THAT(ranWith({}), ElementsAre());
  const BrickState bricks{true, false, 1, 0};
  ranWith(bricks);
  ++volume.made;
  EXPECT_THAT(ranWith(bricks),
              ElementsAre("blocks", "segments", "bricks", "cast", "gradient", "shade", "resolve"));
}

// In bricks: uploads only where rays asked, and nothing of it in a volume of one texture.
TEST_F(FrameGraphTest, BricksRunWhereRaysAskForThem) {
  scene::Scene scene;
  scene.light.setup = scene::LightSetup::key;
  const FrameRequest request;
  BrickState bricks{true, false, 1, 0};
  const auto ranIn = [&] {
    const auto passes = declarePasses(scene, request, 1, bricks);
    return namesOf(passes, frame(passes, wantedImages(request, scene)), PassState::ran);
  };
  EXPECT_THAT(ranIn(), ElementsAre("blocks", "segments", "bricks", "cast", "gradient", "shade", "background",
                                   "resolve"));
  EXPECT_THAT(ranIn(), ElementsAre());
  ++bricks.asked;
  EXPECT_THAT(ranIn(), ElementsAre("bricks", "cast", "gradient", "shade", "resolve"));
  scene.camera.fov += 1.0;
  EXPECT_THAT(ranIn(), ElementsAre("segments", "cast", "gradient", "shade", "resolve"));
  ++bricks.made;
  EXPECT_THAT(ranIn(), ElementsAre("bricks", "cast", "gradient", "shade", "resolve"));
  // Derivatives need the bricks at the hits, which may have been replaced.
  const auto derivatives = [&] {
    scene.derivatives.fetch =
        scene.derivatives.fetch == scene::Fetch::fast ? scene::Fetch::exact : scene::Fetch::fast;
    return ranIn();
  };
  EXPECT_THAT(derivatives(), ElementsAre("gradient", "shade", "resolve"));
  bricks.mayReplace = true;
  ranIn();
  EXPECT_THAT(derivatives(), ElementsAre("cast", "gradient", "shade", "resolve"));
  bricks = {};
  EXPECT_THAT(ranIn(), ElementsAre("cast", "gradient", "shade", "resolve"));
  const auto passes = declarePasses(scene, request, 1, bricks);
  for (const PlannedPass& planned : graph_.plan(passes, wantedImages(request, scene)))
    if (passes[planned.index].name == pass::bricks) {
      EXPECT_EQ(planned.state, PassState::skipped);
      EXPECT_EQ(planned.reason, "the volume is one texture");
    }
}

// An image may be freed behind its last reader; a wanted one, and one whose other name is read, lasts longer.
TEST_F(FrameGraphTest, ImagesLastUntilTheirLastReader) {
  const std::vector<PassDeclaration> passes = {
      {"a", {}, {"one", "two", "second"}, {}, {}, {4, 8, PassDeclaration::kSameImage}},
      {"b", {"one"}, {"three"}, {}, {}, {16}},
      {"c", {"second", "three"}, {"four"}, {}, {}, {2}},
      {"unused", {"one"}, {"five"}, {}, {}, {100}},
      {"d", {"four"}, {"last"}, {}, {}, {1}}};
  const auto plan = graph_.plan(passes, {"last"});
  EXPECT_EQ(lastUses(passes, plan, {"last"}),
            (std::map<std::string, std::size_t>{
                {"one", 1}, {"two", 2}, {"second", 2}, {"three", 2}, {"four", 4}, {"last", 5}}));
  EXPECT_EQ(peakBytesPerRay(passes, {"last"}), 4 + 8 + 16);
  EXPECT_EQ(peakBytesPerRay(passes, {"last", "one"}), 4 + 8 + 16 + 2);
}

// What a pass wrote comes back only for passes that run, and is the same: others stay cached.
TEST_F(FrameGraphTest, FreedImagesAreMadeAgainForThoseThatReadThem) {
  const auto passes = [](std::uint64_t ofLast, std::uint64_t ofOther) {
    return std::vector<PassDeclaration>{{"first", {}, {"a"}, {}},
                                        {"second", {"a"}, {"b"}, {}},
                                        {"other", {"a"}, {"c"}, {{"x", ofOther}}},
                                        {"last", {"b", "c"}, {"d"}, {{"y", ofLast}}}};
  };
  const auto ran = [&](const std::vector<PassDeclaration>& declared) {
    return namesOf(declared, frame(declared, {"d"}), PassState::ran);
  };
  ran(passes(0, 0));
  graph_.freed("first");
  graph_.freed("second");
  EXPECT_THAT(ran(passes(0, 0)), ElementsAre());
  EXPECT_THAT(ran(passes(0, 1)), ElementsAre("first", "second", "other", "last"));
  EXPECT_THAT(ran(passes(0, 1)), ElementsAre());
  graph_.freed("first");
  EXPECT_THAT(ran(passes(1, 1)), ElementsAre("last"));  // what it reads is there
  EXPECT_THAT(ran(passes(1, 2)), ElementsAre("first", "other", "last"));
  graph_.freed("last");
  EXPECT_THAT(ran(passes(1, 2)), ElementsAre("last"));  // wanted
}

}  // namespace
}  // namespace isolux::render
