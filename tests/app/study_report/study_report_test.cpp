#include "app/study_report/study_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/volumes.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::app {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(StudyMarkdown, WordsOfAFileAreText) {
  StudySubject subject;
  auto named = std::make_shared<volume::PreparedVolume>(*test::phantom("ball", 8));
  named->volume.name = "a<img src=x onerror=f()>|[b](c)\n# d";
  subject.volume = named;
  subject.scene.surfaces.front().value = 0.5;
  const std::string text = studyMarkdown(subject, {}, {}, true);
  EXPECT_THAT(text, HasSubstr("\\<img src=x onerror=f()\\>\\|\\[b\\](c)"));
  EXPECT_THAT(text, Not(HasSubstr("\n# d")));
}

}  // namespace
}  // namespace isolux::app
