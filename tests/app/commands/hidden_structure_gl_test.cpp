// isolux render at a coarser level: what it says that the level hides, where it marks it, and what that
// needs.
#include <algorithm>
#include <filesystem>
#include <fstream>

#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app/commands/run_isolux.h"
#include "tests/support/test_data.h"

namespace isolux::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

// Rings of wire, 1.4 voxels wide: level 2, of voxels 4 wide, shows nothing of them.
class HiddenStructureGl : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(callIsolux({"phantom", "wires", "--size", "96", "--out", "wires.nrrd"}, folder_).exitCode, 0);
  }
  void makeIndex() { ASSERT_EQ(callIsolux({"index", "wires.nrrd"}, folder_).exitCode, 0); }
  RunResult render(const std::string& level, const std::string& out,
                   const std::vector<std::string>& more = {}) {
    std::vector<std::string> all{"render",  "wires.nrrd", "--isovalue", "500",   "--size",
                                 "160x120", "--out",      out,          "--set", "source.level=" + level};
    all.insert(all.end(), more.begin(), more.end());
    return callIsolux(all, folder_);
  }
  json levelOf(const std::string& stats) const {
    return json::parse(std::ifstream(folder_ / stats))["level"];
  }
  std::vector<float> channel(const std::string& file, const std::string& name) const {
    const auto in = OIIO::ImageInput::open((folder_ / file).string());
    if (!in) return {};
    const auto& names = in->spec().channelnames;
    const auto found = std::find(names.begin(), names.end(), name);
    EXPECT_NE(found, names.end()) << name;
    if (found == names.end()) return {};
    const auto at = static_cast<int>(found - names.begin());
    std::vector<float> values(static_cast<std::size_t>(in->spec().width) *
                              static_cast<std::size_t>(in->spec().height));
    EXPECT_TRUE(in->read_image(0, 0, at, at + 1, OIIO::TypeDesc::FLOAT, values.data()));
    return values;
  }

  fs::path folder_ = temporaryFolder();
};

// Where level 0 has hits and level 2 has none, pixels are marked: with one camera for both.
TEST_F(HiddenStructureGl, PixelsOfWhatTheLevelHidesAreMarked) {
  makeIndex();
  const std::vector<std::string> camera{"--set", "camera.eye=150,120,90", "--set", "camera.target=0,0,0"};
  auto fineOptions = camera, coarseOptions = camera;
  fineOptions.insert(fineOptions.end(), {"--aov", "hit,hidden_structure", "--stats", "fine.json"});
  coarseOptions.insert(coarseOptions.end(),
                       {"--aov", "hidden_structure,hit", "--stats", "coarse.json", "--explain"});
  const RunResult fine = render("0", "fine.exr", fineOptions),
                  coarse = render("2", "coarse.exr", coarseOptions);
  ASSERT_EQ(fine.exitCode, 0) << fine.err;
  ASSERT_EQ(coarse.exitCode, 0) << coarse.err;
  const std::vector<float> hits = channel("fine.exr", "hit"), coarseHits = channel("coarse.exr", "hit"),
                           hidden = channel("coarse.exr", "hidden_structure"),
                           none = channel("fine.exr", "hidden_structure");
  ASSERT_EQ(hits.size(), hidden.size());
  std::size_t lost = 0, unmarked = 0, marked = 0;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    marked += hidden[i] == 1.0F;
    if (hits[i] != 1.0F || coarseHits[i] == 1.0F) continue;
    ++lost;
    unmarked += hidden[i] != 1.0F;
  }
  EXPECT_GT(lost, 300U);
  EXPECT_LE(unmarked, lost / 100);
  EXPECT_LT(marked, hits.size() * 3 / 4);
  EXPECT_EQ(*std::max_element(none.begin(), none.end()), 0.0F);

  const json level = levelOf("coarse.json");
  EXPECT_EQ(level["level"], 2);
  EXPECT_GT(level["hides"]["blocks"], 20);
  EXPECT_DOUBLE_EQ(level["hides"]["share"], static_cast<double>(marked) / static_cast<double>(hits.size()));
  EXPECT_TRUE(levelOf("fine.json").is_null());
  EXPECT_THAT(coarse.err, HasSubstr("may hide structure thinner than "));
  EXPECT_THAT(coarse.out, HasSubstr("may hide structure thinner than "));
  EXPECT_THAT(fine.err, Not(HasSubstr("may hide")));
}

TEST_F(HiddenStructureGl, TheOverlayHatchesThem) {
  makeIndex();
  ASSERT_EQ(render("2", "plain.png").exitCode, 0);
  const RunResult marked = render("2", "marked.png", {"--error-overlay", "structure"});
  ASSERT_EQ(marked.exitCode, 0) << marked.err;
  EXPECT_NE(contentOf(folder_ / "plain.png"), contentOf(folder_ / "marked.png"));
  ASSERT_EQ(render("0", "fine.png").exitCode, 0);
  ASSERT_EQ(render("0", "fine_marked.png", {"--error-overlay", "structure"}).exitCode, 0);
  EXPECT_EQ(contentOf(folder_ / "fine.png"), contentOf(folder_ / "fine_marked.png"))
      << "level 0 hides nothing";
}

// What is cut away hides nothing.
TEST_F(HiddenStructureGl, CutsCount) {
  makeIndex();
  ASSERT_EQ(render("2", "all.png", {"--stats", "all.json"}).exitCode, 0);
  const RunResult cut =
      render("2", "cut.png", {"--stats", "cut.json", "--set", "clip.planes=0,0,-1000 0,0,1"});
  ASSERT_EQ(cut.exitCode, 0) << cut.err;
  EXPECT_GT(levelOf("all.json")["hides"]["share"], 0.02);
  EXPECT_EQ(levelOf("cut.json")["hides"]["share"], 0.0);
}

TEST_F(HiddenStructureGl, WithoutAnIndexItIsNotKnown) {
  ASSERT_EQ(render("2", "a.png", {"--stats", "a.json"}).exitCode, 0);
  EXPECT_TRUE(levelOf("a.json")["hides"].is_null());
  EXPECT_GT(levelOf("a.json")["may_hide_thinner_than_mm"], 0.0);
  for (const std::vector<std::string>& asks :
       {std::vector<std::string>{"--error-overlay", "structure"}, {"--aov", "hidden_structure"}}) {
    const std::string out = asks.front() == "--aov" ? "b.exr" : "b.png";
    const RunResult refused = render("2", out, asks);
    EXPECT_EQ(refused.exitCode, 2) << refused.err;
    EXPECT_TRUE(refused.isOneErrorLine()) << refused.err;
    EXPECT_THAT(refused.err, HasSubstr("isolux index"));
    EXPECT_FALSE(fs::exists(folder_ / out));
  }
}

}  // namespace
}  // namespace isolux::test
