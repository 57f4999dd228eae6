// A shown main window with helpers to wait, drag and compare pictures: what the window's tests share.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include <QImage>
#include <QPoint>
#include <QString>
#include <QWidget>

#include <gtest/gtest.h>

#include "ui/window/main_window.h"

namespace isolux::test {

// Runs the event loop until `condition` holds; false after the time-out, which guards against waiting for
// ever.
bool waitUntil(const std::function<bool()>& condition, int milliseconds = 120000);

// Runs the event loop until `value` has stayed the same for a second: the only way to see that threads which
// end what they have begun have ended it. False when it has not come to rest after two minutes.
bool comesToRest(const std::function<std::uint64_t()>& value);

// Presses at `from`, moves in `steps` to `to`, releases; the event loop runs between.
void drag(QWidget* widget, QPoint from, QPoint to, Qt::MouseButton button = Qt::LeftButton,
          Qt::KeyboardModifiers modifiers = Qt::NoModifier, int steps = 5);
void wheel(QWidget* widget, QPoint position, int notches, Qt::KeyboardModifiers modifiers = Qt::NoModifier);

// Fraction of pixels with a channel that differs by more than `tolerance`; 1 when the sizes differ.
double differingPixels(const QImage& a, const QImage& b, int tolerance = 1);

// A MetaImage of the distance to a centre, int16, `size` voxels per axis: a ball at every isovalue below
// size/2.
QString writeBall(int size, glm::dvec3 spacingMm = glm::dvec3(1.0));

class WindowTest : public testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override;

  static std::unique_ptr<ui::MainWindow> makeWindow();
  // Opens and waits for the volume; false when it failed.
  static bool load(ui::MainWindow& window, const QString& path);
  // Waits for the full picture and returns its pixels, without letters and scale.
  static QImage fullPicture(ui::MainWindow& window);
  static QString newFile(const QString& name);

  std::unique_ptr<ui::MainWindow> window_;
};

}  // namespace isolux::test
