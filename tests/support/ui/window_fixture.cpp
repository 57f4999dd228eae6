#include "tests/support/ui/window_fixture.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <vector>

#include <QCoreApplication>
#include <QDeadlineTimer>
#include <QElapsedTimer>
#include <QSettings>
#include <QTest>
#include <QThread>
#include <QWheelEvent>

#include "tests/support/test_data.h"
#include "ui/document/preferences.h"
#include "ui/viewport/viewport.h"

namespace isolux::test {

bool waitUntil(const std::function<bool()>& condition, int milliseconds) {
  const QDeadlineTimer deadline(milliseconds);
  while (!condition()) {
    if (deadline.hasExpired()) return false;
    QCoreApplication::processEvents(QEventLoop::AllEvents, 20);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    QThread::msleep(1);
  }
  return true;
}

bool comesToRest(const std::function<std::uint64_t()>& value) {
  std::uint64_t last = value();
  QElapsedTimer unchanged;
  unchanged.start();
  return waitUntil([&] {
    if (const std::uint64_t now = value(); now != last) {
      last = now;
      unchanged.restart();
    }
    return unchanged.elapsed() >= 1000;
  });
}

void drag(QWidget* widget, QPoint from, QPoint to, Qt::MouseButton button, Qt::KeyboardModifiers modifiers,
          int steps) {
  QTest::mousePress(widget, button, modifiers, from);
  for (int i = 1; i <= steps; ++i) {
    const QPointF position = QPointF(from) + QPointF(to - from) * i / steps;
    QMouseEvent move(QEvent::MouseMove, position, widget->mapToGlobal(position), Qt::NoButton, button,
                     modifiers);
    QCoreApplication::sendEvent(widget, &move);
    QCoreApplication::processEvents();
  }
  QTest::mouseRelease(widget, button, modifiers, to);
  QCoreApplication::processEvents();
}

void wheel(QWidget* widget, QPoint position, int notches, Qt::KeyboardModifiers modifiers) {
  QWheelEvent event(position, widget->mapToGlobal(QPointF(position)), {}, {0, 120 * notches}, Qt::NoButton,
                    modifiers, Qt::NoScrollPhase, false);
  QCoreApplication::sendEvent(widget, &event);
  QCoreApplication::processEvents();
}

double differingPixels(const QImage& a, const QImage& b, int tolerance) {
  if (a.size() != b.size() || a.isNull()) return 1.0;
  const QImage left = a.convertToFormat(QImage::Format_RGB32),
               right = b.convertToFormat(QImage::Format_RGB32);
  std::size_t differing = 0;
  for (int y = 0; y < left.height(); ++y) {
    for (int x = 0; x < left.width(); ++x) {
      const QRgb p = left.pixel(x, y), q = right.pixel(x, y);
      const int most = std::max(
          {std::abs(qRed(p) - qRed(q)), std::abs(qGreen(p) - qGreen(q)), std::abs(qBlue(p) - qBlue(q))});
      if (most > tolerance) ++differing;
    }
  }
  return static_cast<double>(differing) / (static_cast<double>(left.width()) * left.height());
}

QString writeBall(int size, glm::dvec3 spacingMm) {
  const std::filesystem::path folder = temporaryFolder();
  std::vector<std::int16_t> voxels;
  const double centre = 0.5 * (size - 1);
  for (int z = 0; z < size; ++z) {
    for (int y = 0; y < size; ++y) {
      for (int x = 0; x < size; ++x) {
        const double r = std::sqrt((x - centre) * (x - centre) + (y - centre) * (y - centre) +
                                   (z - centre) * (z - centre));
        voxels.push_back(static_cast<std::int16_t>(std::lround(1000.0 - 40.0 * r)));
      }
    }
  }
  std::ofstream data(folder / "ball.raw", std::ios::binary);
  data.write(reinterpret_cast<const char*>(voxels.data()), static_cast<std::streamsize>(voxels.size() * 2));
  std::ofstream header(folder / "ball.mhd");
  header << "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
         << "ElementSpacing = " << spacingMm.x << ' ' << spacingMm.y << ' ' << spacingMm.z << '\n'
         << "DimSize = " << size << ' ' << size << ' ' << size << '\n'
         << "ElementType = MET_SHORT\nElementDataFile = ball.raw\n";
  return QString::fromStdString((folder / "ball.mhd").string());
}

void WindowTest::SetUp() {
  QSettings().clear();
  // ISOLUX_TEST_CANVAS=textures (tests/ui/main.cpp): the same tests with pictures on the graphics card.
  if (QCoreApplication::testAttribute(Qt::AA_ShareOpenGLContexts))
    ui::saveHostSettings({}, {.canvas = scene::Canvas::textures});
  window_ = makeWindow();
}

void WindowTest::TearDown() {
  window_.reset();
}

std::unique_ptr<ui::MainWindow> WindowTest::makeWindow() {
  auto window = std::make_unique<ui::MainWindow>();
  QObject::connect(window->viewport(), &ui::Viewport::reported, [](const render::FrameReport& report) {
    for (const std::string& error : report.glErrors) ADD_FAILURE() << "OpenGL: " << error;
  });
  window->resize(900, 640);
  window->show();
  if (!QTest::qWaitForWindowExposed(window.get(), 120000)) ADD_FAILURE() << "the window was not shown";
  window->activateWindow();  // shortcuts reach the active window only
  if (!QTest::qWaitForWindowActive(window.get(), 120000)) ADD_FAILURE() << "the window did not become active";
  return window;
}

bool WindowTest::load(ui::MainWindow& window, const QString& path) {
  bool ended = false, success = false;
  const auto connection = QObject::connect(window.document(), &ui::Document::loadEnded, [&](bool good) {
    ended = true;
    success = good;
  });
  window.openPath(path);
  waitUntil([&] { return ended; });
  QObject::disconnect(connection);
  return success;
}

QImage WindowTest::fullPicture(ui::MainWindow& window) {
  if (!waitUntil([&] { return window.viewport()->complete(); })) ADD_FAILURE() << "no full picture in time";
  return window.viewport()->shown();
}

QString WindowTest::newFile(const QString& name) {
  return QString::fromStdString(temporaryFolder().string()) + '/' + name;
}

}  // namespace isolux::test
