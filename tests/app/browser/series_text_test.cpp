#include "app/browser/series_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/browser/index_job.h"

namespace isolux::app {
namespace {

using testing::ElementsAre;

volume::DicomSeries bone() {
  volume::DicomSeries series;
  series.patient = {"DOE^JANE^A", "ID4711", "19600102"};
  series.series = "1.1";
  series.description = "Axial Bone";
  series.studyDate = series.date = "20240131";
  series.modality = "CT";
  series.columns = 512;
  series.rows = 400;
  series.slices = 120;
  series.spacingMm = {0.75, 0.75, 2.0};
  return series;
}

TEST(SeriesText, SaysThingsAsPeopleDo) {
  EXPECT_EQ(personText("DOE^JANE^A"), "DOE, JANE A");
  EXPECT_EQ(personText("DOE^^A^"), "DOE, A");
  EXPECT_EQ(personText("Rex the dog"), "Rex the dog");
  EXPECT_EQ(dateText("20240131"), "2024-01-31");
  EXPECT_EQ(dateText("2024.01."), "2024.01.");
  EXPECT_EQ(sizeText(bone()), "512 × 400");
  EXPECT_EQ(spacingText(bone()), "0.75 × 0.75 × 2 mm");
  EXPECT_EQ(spacingText({}), "");
  EXPECT_EQ(slicesText(bone()), "120");
  volume::DicomSeries beating = bone();
  beating.timeSteps = 4;
  EXPECT_EQ(slicesText(beating), "4 × 120");
  volume::DicomSeries nameless;
  EXPECT_EQ(titleOf(nameless), "series");
  nameless.number = "3";
  EXPECT_EQ(titleOf(nameless), "series 3");
}

TEST(SeriesText, WarningsInAWordOrTwo) {
  volume::DicomSeries series = bone();
  series.warnings = {"gantry tilt of 18.5 degrees: the slices are sheared against each other; kept so",
                     "slice distances are uneven (1 to 2 mm): resampled from 5 onto 9 slices every 1 mm",
                     "slices are missing in 13 places; these are interpolated",
                     "1 of 5 slices differ from the rest (orientation, size) and are left out",
                     "instance numbers and temporal position order repeated slices differently",
                     "something new"};
  EXPECT_THAT(shortWarnings(series), ElementsAre("gantry tilt", "uneven spacing", "missing slices",
                                                 "mixed slices", "uncertain time steps", "something new"));
  series.problem = "the slices are not on one line";
  EXPECT_EQ(shortWarnings(series).front(), "cannot be opened");
}

TEST(SeriesText, ASearchFindsAllItsWordsWhateverTheCase) {
  for (const char* search : {"", "bone", "AXIAL ct", "doe", "jane", "id4711", "2024-01-31", "20240131", "120",
                             "0.75", "1960-01-02", "  bone  "})
    EXPECT_TRUE(matches(bone(), search, false)) << search;
  for (const char* search : {"lung", "bone mr", "anonymous"})
    EXPECT_FALSE(matches(bone(), search, false)) << search;
  for (const char* search : {"doe", "jane", "id4711", "1960-01-02"})
    EXPECT_FALSE(matches(bone(), search, true)) << "hidden: " << search;
  EXPECT_TRUE(matches(bone(), "anonymous bone", true));
}

TEST(SeriesText, OfASeriesTheNewestHolds) {
  std::vector<volume::DicomSeries> all;
  addSeries(all, bone());
  volume::DicomSeries other = bone();
  other.series = "1.2";
  addSeries(all, other);
  volume::DicomSeries more = bone();
  more.slices = 200;
  addSeries(all, more);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all.front().slices, 200);
}

}  // namespace
}  // namespace isolux::app
