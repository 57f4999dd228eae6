// Which surfaces pictures at rest take the spline's hits of.
#include "volume/prepared/still_hits.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "volume/phantom/phantom.h"

namespace isolux::volume {
namespace {

StillHits hitsOf(const char* phantom) {
  base::Progress progress;
  auto grid = std::make_shared<const Grid>(makePhantom(parsePhantom(phantom), progress));
  auto blocks = std::make_shared<const MinMaxBlocks>(*grid, 8, progress);
  return {std::move(grid), std::move(blocks)};
}

TEST(StillHits, WiresGainAndResolvedSurfacesDoNot) {
  base::Progress progress;
  const StillHits wires = hitsOf("wires:128"), torus = hitsOf("torus:64"), gyroid = hitsOf("gyroid:96");
  EXPECT_TRUE(wires.gains(wires.measure(500.0, progress)));
  EXPECT_FALSE(torus.gains(torus.measure(0.0, progress)));
  EXPECT_FALSE(gyroid.gains(gyroid.measure(0.0, progress)));
  wires.giveUp();
  EXPECT_FALSE(wires.gains(wires.measure(500.0, progress)));
}

TEST(StillHits, AreMeasuredOnceForEachIsovalue) {
  base::Progress progress;
  const StillHits hits = hitsOf("wires:64");
  EXPECT_FALSE(hits.find(500.0));
  const double share = hits.measure(500.0, progress);
  EXPECT_EQ(hits.find(500.0), share);
  EXPECT_FALSE(hits.find(400.0));
  EXPECT_EQ(hits.measure(1e9, progress), 0.0) << "no surface";
  base::Progress stopped;
  stopped.requestStop();
  EXPECT_EQ(hits.measure(500.0, stopped), share) << "it is there already";
  EXPECT_THROW(hits.measure(300.0, stopped), base::Error);
  EXPECT_FALSE(hits.find(300.0));
}

}  // namespace
}  // namespace isolux::volume
