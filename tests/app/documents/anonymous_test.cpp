#include "app/documents/anonymous.h"

#include <gtest/gtest.h>

namespace isolux::app {
namespace {

const volume::Patient jane{"DOE^JANE LI", "ID4711", "19600102"};

TEST(Anonymous, HidesNameIdAndBirthDateAsTheyAreWritten) {
  EXPECT_EQ(withoutPatient("DOE^JANE LI", jane), "anonymous");
  EXPECT_EQ(withoutPatient("doe_jane, 2024.nii", jane), "anonymous, 2024.nii");
  EXPECT_EQ(withoutPatient("Scan of Jane (id4711)", jane), "Scan of anonymous (anonymous)");
  EXPECT_EQ(withoutPatient("born 1960-01-02, 02.01.1960 or 19600102", jane), "born anonymous or anonymous");
  EXPECT_EQ(withoutPatient("janes_head", jane), "anonymouss_head") << "four letters stand anywhere";
}

TEST(Anonymous, LeavesWhatIsNoneOfThem) {
  for (const char* text : {"", "axial bone", "doehead", "lipid", "1960", "phantom:head:64", "Ärzte"})
    EXPECT_EQ(withoutPatient(text, jane), text);
  EXPECT_EQ(withoutPatient("LI 3", jane), "anonymous 3") << "short words are hidden where they stand alone";
  EXPECT_EQ(withoutPatient("DOE", volume::Patient{}), "DOE");
  EXPECT_EQ(withoutPatient("a b 12", volume::Patient{"A^B", "12", "1960"}), "a b 12")
      << "what is too short would hide everything";
}

TEST(Anonymous, HidesNamesBeyondAscii) {
  const volume::Patient patient{"MÜLLER^ÖZGE", "", ""};
  EXPECT_EQ(withoutPatient("MÜLLER_ÖZGE_ct", patient), "anonymous_ct");
}

TEST(Anonymous, NamesOfMarksAreHiddenAndPathsStay) {
  scene::Scene scene;
  scene.source.path = "/scans/DOE/ct";
  scene.marks.push_back({.name = "Doe: left", .points = {{1, 2, 3}}});
  const scene::Scene hidden = withoutPatient(scene, jane);
  EXPECT_EQ(hidden.marks.front().name, "anonymous: left");
  EXPECT_EQ(hidden.source.path, scene.source.path);
}

}  // namespace
}  // namespace isolux::app
