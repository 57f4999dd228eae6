// The notes of a volume's reader, the gravest first.
#include "app/documents/import_notes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace isolux::app {
namespace {

using testing::ElementsAre;

TEST(ImportNotes, MissingDataComeBeforeWhatIsMadeOfThemAndThatBeforeTheRest) {
  const std::vector<std::string> warnings{
      "2 time steps, step 0 is shown; source.time_step chooses another",
      "slice distances are uneven (1.08 to 7 mm): resampled linearly from 28 onto 37 slices every 4 mm",
      "gantry tilt of 18.5 degrees: the slices are sheared against each other; kept so, the grid is oblique",
      "slices are missing in 13 places; these are interpolated"};
  const ImportNotes sorted = importNotes(warnings);
  EXPECT_THAT(sorted.notes, ElementsAre(warnings[3], warnings[1], warnings[2], warnings[0]));
  EXPECT_EQ(sorted.grave, 3u);
}

TEST(ImportNotes, EachGraveOneIsKnown) {
  for (const char* note :
       {"slices are missing in 2 places; these are interpolated",
        "3 of 8 voxels are NaN or infinite and count as missing", "ElementSpacing is missing; 1 mm assumed",
        "no usable orientation (sform, qform); left and right are not certain", "12 boundary edges in 1 loop",
        "the surface has only one side: its inside is a guess",
        "the compressed data are cut off: all voxels are there, the checksum at the end is missing",
        "a slice is 2 mm off the line of the others",
        "the field \"endian\" is missing; little endian assumed"})
    EXPECT_EQ(importNotes(std::vector<std::string>{note}).grave, 1u) << note;
  for (const char* note : {"2 components per voxel, 0 is shown", "a mesh: turned into its signed distance"})
    EXPECT_EQ(importNotes(std::vector<std::string>{note}).grave, 0u) << note;
  EXPECT_TRUE(importNotes({}).notes.empty());
}

}  // namespace
}  // namespace isolux::app
