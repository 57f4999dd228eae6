// Pictures and sessions of earlier programs open to the pictures that those drew, and so they do with other
// threads and in drivers that use other instructions.
#include <iostream>

#include <gtest/gtest.h>

#include "app/documents/session.h"
#include "tests/app/commands/run_isolux.h"
#include "tests/app/same_picture/distance.h"
#include "tests/support/paths.h"
#include "tests/support/png_reader.h"
#include "tests/support/test_data.h"

namespace isolux::test {
namespace {

namespace fs = std::filesystem;

// Draws the session in that picture by the program, in a process of its own.
render::ColorImage openedBy(const std::string& picture, const std::vector<std::string>& options,
                            const std::vector<std::string>& environment = {}) {
  const fs::path folder = temporaryFolder();
  const fs::path file =
      fs::path(ISOLUX_SOURCE_DIR) / "tests/app/same_picture/pictures_0_1_0" / (picture + ".png");
  std::vector<std::string> arguments{"render", file.string(), "--context", "software", "--out", "a.png"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const RunResult result = runIsolux(arguments, {.folder = folder, .environment = environment});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  return test::readPng(folder / "a.png");
}

void expectKept(const std::string& what, const render::ColorImage& a, const render::ColorImage& b,
                const WayBound& bound) {
  ASSERT_EQ(a.size, b.size);
  const WayDistance distance = distanceOf(a, b);
  std::cout << what << ": " << distance << '\n';
  EXPECT_TRUE(keeps(distance, bound)) << what << ": " << distance;
}

class OldPictureGlTest : public testing::TestWithParam<const char*> {};

TEST_P(OldPictureGlTest, OpensToItself) {
  const fs::path file = fs::path(ISOLUX_SOURCE_DIR) / "tests/app/same_picture/pictures_0_1_0" /
                        (std::string(GetParam()) + ".png");
  expectKept(GetParam(), test::readPng(file), openedBy(GetParam(), {"--executor", "cpu"}), kOtherOrder);
}

// Not "lines": 0.1.0 followed them over pixels, so that they changed with the size of the picture.
INSTANTIATE_TEST_SUITE_P(Pictures, OldPictureGlTest,
                         testing::Values("cubic", "curvature", "cuts", "flow", "layers", "light"),
                         [](const auto& one) { return std::string(one.param); });

class SameProgramGlTest : public testing::TestWithParam<const char*> {};

TEST_P(SameProgramGlTest, WithAnyThreadsAndInstructionsOfTheDriver) {
  const auto draw = [](const std::vector<std::string>& environment, const char* threads) {
    return openedBy(GetParam(), {"--executor", "gpu", "--threads", threads}, environment);
  };
  const render::ColorImage reference = draw({}, "2");
  EXPECT_EQ(draw({}, "1").rgba, reference.rgba);
  EXPECT_EQ(draw({"LP_NUM_THREADS=0"}, "2").rgba, reference.rgba);
  expectKept("vectors of 128 bits", draw({"LP_NATIVE_VECTOR_WIDTH=128"}, "2"), reference, kOtherOrder);
  expectKept("SSE4.1", draw({"GALLIUM_OVERRIDE_CPU_CAPS=sse4.1"}, "2"), reference, kOtherDriver);
}

INSTANTIATE_TEST_SUITE_P(Pictures, SameProgramGlTest, testing::Values("layers", "light", "lines"),
                         [](const auto& one) { return std::string(one.param); });

// Sessions as earlier versions of the format were written, and what they meant, said in settings of today.
struct OldSession {
  const char* name;
  const char* text;
  PictureScene today;
};
void PrintTo(const OldSession& session, std::ostream* out) {
  *out << session.name;
}

const OldSession kOldSessions[] = {
    {"version1",
     R"({"isolux_session": 1, "program": "0.0.9", "settings": {"source.path": "phantom:head:64",
         "isosurface.value": 300, "look.mode": "mean_curvature", "camera.eye": [90, -480, 50]}})",
     {"",
      "head",
      64,
      {"isosurface.value=300", "look.mode=mean_curvature", "camera.eye=90,-480,50", "derivatives.scale=0",
       "derivatives.normal_scale=0", "picture.rest_hits=same", "light.setup=key",
       "light.direction=-0.5,0.7,0.9", "look.ambient_variation=0"}}},
    {"version3",
     R"({"isolux_session": 3, "scene": {"source": {"path": "phantom:head:48"}, "isosurface": {"value": 300},
         "look": {"mode": "gi"}, "gi": {"samples": 16}, "camera": {"eye": [90, -480, 50]},
         "lamp1": {"shown": true, "kind": "sphere"}}})",
     {"",
      "head",
      48,
      {"isosurface.value=300", "look.mode=gi", "gi.samples=16", "camera.eye=90,-480,50", "lamp1.shown=1",
       "lamp1.kind=sphere", "light.environment.constant=1,1,1", "picture.metering=lights",
       "derivatives.scale=0", "derivatives.normal_scale=0", "picture.rest_hits=same", "light.setup=key",
       "light.direction=-0.5,0.7,0.9", "look.ambient_variation=0", "picture.curve=linear"}}},
    {"version4",
     R"({"isolux_session": 4, "scene": {"source": {"path": "phantom:head:64"}, "look": {"mode": "lambert",
         "ridges": 0.8, "suggestive_contours": 1}, "camera": {"eye": [90, -480, 50]}}})",
     {"",
      "head",
      64,
      {"look.mode=lambert", "look.ridges=0.8", "look.suggestive_contours=1", "camera.eye=90,-480,50",
       "derivatives.scale=0", "derivatives.normal_scale=0", "picture.rest_hits=same", "light.setup=key",
       "light.direction=-0.5,0.7,0.9", "look.ambient_variation=0"}}},
    {"version7",
     R"({"isolux_session": 7, "scene": {"source": {"path": "phantom:head:48"}, "isosurface": {"value": 300},
         "camera": {"eye": [90, -480, 50], "frames": "volume"}}})",
     {"",
      "head",
      48,
      {"isosurface.value=300", "camera.eye=90,-480,50", "light.setup=key", "light.direction=-0.5,0.7,0.9",
       "look.ambient_variation=0"}}},
};

class OldSessionGlTest : public testing::TestWithParam<OldSession> {};

TEST_P(OldSessionGlTest, OpensToWhatItMeant) {
  const OldSession& old = GetParam();
  const auto context = render::OffscreenContext::create(render::ContextChoice::software);
  const scene::Scene opened = app::parseSession(old.text, "old.isolux", {"/"});
  EXPECT_EQ(opened.source.path,
            "phantom:" + std::string(old.today.volume) + ":" + std::to_string(old.today.voxels));
  const DrawnWay a = drawWay(*context, old.today, opened), b = drawWay(*context, old.today);
  EXPECT_GT(a.hits, 1000);
  EXPECT_TRUE(isIdentical(a, b)) << distanceOf(a, b);
}

INSTANTIATE_TEST_SUITE_P(Versions, OldSessionGlTest, testing::ValuesIn(kOldSessions),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace isolux::test
