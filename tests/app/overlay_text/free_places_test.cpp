// Places for texts: as wanted where that is free, else moved along the edge, clear of boxes and lines.
#include "app/overlay_text/free_places.h"

#include <gtest/gtest.h>

namespace isolux::test {
namespace {

using app::FreePlaces;
using app::TextBox;

constexpr TextBox picture{{0.0, 0.0}, {200.0, 100.0}};
constexpr TextBox wanted{{90.0, 4.0}, {20.0, 10.0}};

TEST(FreePlacesTest, AreAsWantedWhereNothingStands) {
  FreePlaces places(picture, 3.0);
  EXPECT_EQ(places.place(wanted, 0)->low, wanted.low);
  const TextBox second = places.place(wanted, 0).value();
  EXPECT_EQ(second.low.y, wanted.low.y);
  EXPECT_EQ(std::abs(second.low.x - wanted.low.x), 23.0) << "beside the first";
}

TEST(FreePlacesTest, AreMovedOffBoxesAndLines) {
  FreePlaces places(picture, 3.0);
  places.take(TextBox{{60.0, 0.0}, {45.0, 30.0}});
  places.takeLine({115.0, -50.0}, {115.0, 300.0});  // passes through, with both ends outside
  const TextBox found = places.place(wanted, 0).value();
  EXPECT_EQ(found.low, glm::dvec2(122.0, 4.0));
}

TEST(FreePlacesTest, WithoutRoomLinesAreCrossedBeforeBoxes) {
  FreePlaces places(picture, 3.0);
  places.takeLine({0.0, 9.0}, {200.0, 9.0});
  EXPECT_EQ(places.place(wanted, 0)->low, wanted.low);
  FreePlaces full(picture, 3.0);
  full.take(picture);
  EXPECT_FALSE(full.place(wanted, 0));
}

}  // namespace
}  // namespace isolux::test
