// The frame graph and the declared passes: no GL.
#include "render/frame_graph.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "render/passes.h"

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
  // The passes that run when `scene` follows what was drawn before.
  std::vector<std::string> ran(const scene::Scene& scene, const FrameRequest& request,
                               std::uint64_t volume = 1) {
    const auto passes = declarePasses(scene, request, volume);
    return namesOf(passes, frame(passes, wantedImages(request)), PassState::ran);
  }
  FrameGraph graph_;
};

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
  EXPECT_EQ(plan[2].reason, "B is new");
}

TEST_F(FrameGraphTest, APassSkippedForAWhileSeesWhatItMissed) {
  std::vector<PassDeclaration> passes = {{"a", {}, {"A"}, {{"x", 1}}}, {"b", {"A"}, {"B"}, {}}};
  frame(passes, {"A", "B"});
  passes[0].parameters[0].hash = 2;
  EXPECT_THAT(namesOf(passes, frame(passes, {"A"}), PassState::ran), ElementsAre("a"));
  const auto plan = frame(passes, {"B"});
  EXPECT_THAT(namesOf(passes, plan, PassState::ran), ElementsAre("b"));
  EXPECT_EQ(plan[1].reason, "A is new");
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
  scene.isosurface.value = 1.0;
  scene.camera.eye = glm::dvec3(0.0, -400.0, 0.0);
  EXPECT_THAT(ran(scene, request), ElementsAre("blocks", "segments", "cast", "gradient", "shade", "resolve"));
  EXPECT_THAT(ran(scene, request), ElementsAre());  // a still picture costs nothing
  scene.isosurface.albedo.x = 0.5;
  EXPECT_THAT(ran(scene, request), ElementsAre("shade", "resolve"));
  scene.camera.eye->x = 10.0;  // orbiting does not rebuild blocks
  EXPECT_THAT(ran(scene, request), ElementsAre("segments", "cast", "gradient", "shade", "resolve"));
  scene.isosurface.value = 2.0;
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

// Which passes each request needs from nothing.
TEST_F(FrameGraphTest, EachLookAndImageRunsExactlyItsPasses) {
  scene::Scene scene;
  FrameRequest picture;
  for (const auto mode : {scene::LookMode::blinn_phong, scene::LookMode::lambert, scene::LookMode::normal}) {
    scene.look.mode = mode;
    graph_.invalidate();
    EXPECT_THAT(ran(scene, picture),
                ElementsAre("blocks", "segments", "cast", "gradient", "shade", "resolve"));
  }
  scene.look.mode = scene::LookMode::depth;
  graph_.invalidate();
  EXPECT_THAT(ran(scene, picture), ElementsAre("blocks", "segments", "cast", "shade", "resolve"));
  FrameRequest depth;
  depth.color = false;
  depth.aovs = {Aov::depth};
  graph_.invalidate();
  EXPECT_THAT(ran(scene, depth), ElementsAre("blocks", "segments", "cast"));
  depth.aovs = {Aov::normal};
  EXPECT_THAT(ran(scene, depth), ElementsAre("gradient"));
  depth.aovs = {Aov::normal, Aov::kappa};  // the gradients come with the Hessians
  graph_.invalidate();
  EXPECT_THAT(ran(scene, depth), ElementsAre("blocks", "segments", "cast", "hessian", "curvature"));
  scene.derivatives.noise = 3.0;
  EXPECT_THAT(ran(scene, depth), ElementsAre("curvature"));
  depth.aovs = {Aov::hessian};
  graph_.invalidate();
  EXPECT_THAT(ran(scene, depth), ElementsAre("blocks", "segments", "cast", "hessian"));
}

TEST_F(FrameGraphTest, OnlyTransparentSurfacesHaveLayersBehindThem) {
  scene::Scene scene;
  FrameRequest picture;
  scene.isosurface.opacity = 0.5;
  EXPECT_THAT(ran(scene, picture),
              ElementsAre("blocks", "segments", "cast", "gradient", "shade", "layers", "resolve"));
  scene.isosurface.layers = 3;
  EXPECT_THAT(ran(scene, picture), ElementsAre("layers", "resolve"));
  scene.isosurface.opacity = 1.0;
  EXPECT_THAT(ran(scene, picture), ElementsAre("shade", "resolve"));
  scene.isosurface2.opacity = 0.25;  // not shown
  EXPECT_THAT(ran(scene, picture), ElementsAre());
  scene.isosurface2.shown = true;
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

}  // namespace
}  // namespace isolux::render
