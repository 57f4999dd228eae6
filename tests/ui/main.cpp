// Runs the window's tests in one QApplication, with settings and a state folder of its own instead of the
// user's.
#include <cstdio>
#include <cstdlib>

#include <QSettings>

#include <gtest/gtest.h>

#include "base/destroy_in_background.h"
#include "tests/support/test_data.h"
#include "tests/support/ui/crash_trace.h"
#include "tests/support/ui/time_bound.h"
#include "ui/viewport/canvas_choice.h"
#include "ui/window/application.h"

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (GTEST_FLAG_GET(list_tests)) return RUN_ALL_TESTS();
  if (const auto problem = isolux::ui::displayProblem()) {
    std::fprintf(stderr, "ui_tests: %s; run it with tests/support/ui/with_display.sh\n", problem->c_str());
    return 1;
  }
  isolux::ui::prepareApplication();
  QSettings::setDefaultFormat(QSettings::IniFormat);
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope,
                     QString::fromStdString(isolux::test::temporaryFolder().string()));
  qputenv("XDG_STATE_HOME", QByteArray::fromStdString(isolux::test::temporaryFolder().string()));
  // textures: pictures stay on the graphics card. none: the same is asked of a window system without OpenGL.
  const QByteArray canvas = qgetenv("ISOLUX_TEST_CANVAS");
  if (canvas == "none") qputenv("QT_XCB_GL_INTEGRATION", "none");
  if (!canvas.isEmpty()) isolux::ui::prepareCanvas(isolux::scene::Canvas::textures);
  const isolux::ui::Application application(argc, argv);
  isolux::ui::finishApplication();
  isolux::test::boundEachTest();
  isolux::test::traceCrashes();
  const int exitCode = RUN_ALL_TESTS();
  // As the program: a thread that compiles shaders must not see the driver's statics go.
  constexpr double secondsToEnd = 1.0;
  if (isolux::base::awaitDestroyed(secondsToEnd)) return exitCode;
  std::fflush(nullptr);
  std::_Exit(exitCode);
}
