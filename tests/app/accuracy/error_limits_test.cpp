#include "app/accuracy/error_limits.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"

namespace isolux::app {
namespace {

using testing::HasSubstr;

std::string refusalOf(const std::string& text, bool time = false) {
  try {
    if (time)
      parseTimeTarget(text);
    else
      parseErrorTarget(text);
  } catch (const base::Error& error) {
    EXPECT_EQ(error.kind(), base::ErrorKind::usage);
    return error.what();
  }
  return "";
}

TEST(Target, ReadsEveryQuantityInItsUnits) {
  const std::vector<Limit> expected{{Quantity::depthMm, 0.01},
                                    {Quantity::missed, 0.001},
                                    {Quantity::normal, 0.5},
                                    {Quantity::curvature, 0.05},
                                    {Quantity::light, 0.02}};
  EXPECT_EQ(parseErrorTarget("depth=0.01mm,missed=0.001,normal=0.5deg,curvature=5%,light=2%"), expected);
  EXPECT_EQ(parseErrorTarget("depth=1e-3vox"), (std::vector<Limit>{{Quantity::depthVoxels, 1e-3}}));
  EXPECT_EQ(parseErrorTarget("missed=25%"), (std::vector<Limit>{{Quantity::missed, 0.25}}));
  EXPECT_EQ(parseErrorTarget("missed=0"), (std::vector<Limit>{{Quantity::missed, 0.0}}));
  EXPECT_EQ(parseTimeTarget("100ms"), 100.0);
  EXPECT_EQ(parseTimeTarget("0.25s"), 250.0);
}

TEST(Target, RefusesWhatMakesNoSenseAndSaysWhatWould) {
  EXPECT_THAT(refusalOf("dept=1mm"), HasSubstr("did you mean depth?"));
  EXPECT_THAT(refusalOf("colour=1%"), HasSubstr("there are depth missed normal curvature light"));
  EXPECT_THAT(refusalOf("depth=1"), HasSubstr("mm or vox"));
  EXPECT_THAT(refusalOf("depth=1cm"), HasSubstr("not in \"cm\""));
  EXPECT_THAT(refusalOf("light=2"), HasSubstr("light is stated in %"));
  EXPECT_THAT(refusalOf("light=%"), HasSubstr("no number"));
  EXPECT_THAT(refusalOf("light"), HasSubstr("QUANTITY=VALUE"));
  EXPECT_THAT(refusalOf("light=nan%"), HasSubstr("no number"));
  EXPECT_THAT(refusalOf("normal=0deg"), HasSubstr("above 0"));
  EXPECT_THAT(refusalOf("missed=2"), HasSubstr("between 0 and 100 %"));
  EXPECT_THAT(refusalOf("depth=1mm,depth=1vox"), HasSubstr("twice"));
  EXPECT_THAT(refusalOf(","), HasSubstr("unknown error"));
  EXPECT_THAT(refusalOf(""), HasSubstr("contains no error"));
  for (const char* text : {"100", "-1ms", "0s", "ms", "infs", "1min"})
    EXPECT_THAT(refusalOf(text, true), HasSubstr("100ms")) << text;
}

TEST(Target, SaysLimitsInTheirUnits) {
  EXPECT_EQ(limitsText(parseErrorTarget("depth=0.01mm,missed=0.001,normal=0.5deg,light=2%")),
            "depth at most 0.01 mm, missed at most 0.1 %, normal at most 0.5 degrees, light at most 2 %");
  EXPECT_EQ(errorText(Quantity::depthVoxels, 0.1), "0.1 voxels");
}

}  // namespace
}  // namespace isolux::app
