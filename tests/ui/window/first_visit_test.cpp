// A first visit by a script: a CT opened from its DICOM folder, a preset, a turned view, marks, a cut,
// slices, a piece, curvature, stored light, a preset of one's own, and the same picture after saving and
// reopening. The window's thread is never busy for long at any step.
//
// ISOLUX_VISIT_PICTURES=FOLDER keeps a screenshot of every step.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>

#include <QAction>
#include <QComboBox>
#include <QInputDialog>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QTest>
#include <QTreeWidget>

#include <glm/geometric.hpp>

#include "tests/support/test_data.h"
#include "tests/support/ui/dialog_answers.h"
#include "tests/support/ui/time_bound.h"
#include "tests/support/ui/watchdog.h"
#include "tests/support/ui/window_fixture.h"
#include "tests/volume/read/dicom_file.h"
#include "ui/document/baked_light.h"
#include "ui/document/mark_reports.h"
#include "ui/panels/pieces_panel.h"
#include "ui/slices/slice_board.h"
#include "ui/viewport/viewport.h"
#include "ui/window/message_bar.h"
#include "volume/read/reader.h"

namespace isolux::test {

namespace {

// Milliseconds of the processor, four times what a turn may take for a window to stay fluent.
constexpr double mostWorkOfAStep = 4.0 * 50.0;

// The voxels of a volume file in HU as the slices of a CT series.
void writeDicomFolder(const std::filesystem::path& volumeFile, const std::filesystem::path& folder) {
  base::Progress progress;
  const volume::Volume volume = volume::readVolume(volumeFile.string(), {}, progress);
  const volume::Grid& grid = *volume.grid;
  const glm::ivec3 dims = grid.dims();
  const glm::dvec3 spacing = grid.geometry().spacingMm();
  std::filesystem::create_directories(folder);
  for (int z = 0; z < dims.z; ++z) {
    DicomSlice slice;
    slice.description = "Head";
    slice.instance = z + 1;
    slice.columns = dims.x;
    slice.rows = dims.y;
    slice.spacing = std::to_string(spacing.y) + '\\' + std::to_string(spacing.x);
    slice.thickness = std::to_string(spacing.z);
    slice.position = "0\\0\\" + std::to_string(z * spacing.z);
    slice.intercept = "0";
    std::vector<std::int16_t> row;
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x)
        row.push_back(static_cast<std::int16_t>(grid.value(x, dims.y - 1 - y, z)));
    slice.pixels.assign(reinterpret_cast<const char*>(row.data()), 2 * row.size());
    std::ofstream file(folder / ("slice" + std::to_string(z) + ".dcm"), std::ios::binary);
    file << dicom(slice);
  }
}

// Answers the next dialog that asks for a text.
class TextAnswer : public QObject {
 public:
  explicit TextAnswer(QString text) : text_(std::move(text)) {
    timer_.setInterval(10);
    connect(&timer_, &QTimer::timeout, this, [this] {
      auto* dialog = qobject_cast<QInputDialog*>(QApplication::activeModalWidget());
      if (dialog == nullptr) return;
      timer_.stop();
      dialog->findChild<QLineEdit*>()->setText(text_);
      dialog->accept();
    });
    timer_.start();
  }

 private:
  QString text_;
  QTimer timer_;
};

class FirstVisitTest : public WindowTest {
 protected:
  void SetUp() override {  // the preset is not kept among the user's
    ::setenv("XDG_CONFIG_HOME", temporaryFolder().c_str(), 1);
    WindowTest::SetUp();
  }
  void TearDown() override {
    WindowTest::TearDown();
    ::unsetenv("XDG_CONFIG_HOME");
  }
  ui::Viewport* viewport() { return window_->viewport(); }
  const scene::Scene& scene() { return window_->document()->scene(); }

  // One step of the visit: what the user does, the picture it ends with, how long the window was busy.
  void step(const char* name, const std::function<void()>& act, const std::function<bool()>& done = {}) {
    restartTimeBound();
    {
      const Watchdog watchdog;
      act();
      EXPECT_TRUE(waitUntil([&] { return viewport()->complete() && (!done || done()); }, 120000)) << name;
      std::printf("%-12s longest turn %5.1f ms of the processor (%.1f ms in all)\n", name,
                  watchdog.longestProcessor(), watchdog.longestWall());
      EXPECT_LE(watchdog.longestProcessor(), mostWorkOfAStep) << name;
    }
    ASSERT_FALSE(viewport()->problem()) << name << ": " << viewport()->problem()->toStdString();
    if (const char* pictures = std::getenv("ISOLUX_VISIT_PICTURES")) {
      const QString file =
          QString("%1/%2_%3.png").arg(pictures).arg(++pictures_, 2, 10, QChar('0')).arg(name);
      EXPECT_TRUE(window_->grab().save(file)) << file.toStdString();
    }
  }
  QAction* action(const QString& text) {
    for (QAction* action : window_->findChildren<QAction*>())
      if (QString(action->text()).remove('&') == text) return action;
    ADD_FAILURE() << "no action " << text.toStdString();
    return nullptr;
  }
  void trigger(const QString& text) {
    QAction* const found = action(text);
    ASSERT_TRUE(found != nullptr && found->isEnabled()) << text.toStdString();
    found->trigger();
  }
  QAction* preset(const QString& title) {
    Q_EMIT window_->presetsMenu()->aboutToShow();
    for (QAction* action : window_->presetsMenu()->actions())
      if (action->text() == title) return action;
    return nullptr;
  }
  void choosePreset(const QString& title) {
    QAction* const found = preset(title);
    ASSERT_TRUE(found != nullptr && found->isEnabled()) << title.toStdString();
    found->trigger();
  }
  QPoint at(double x, double y) {  // from the centre, in parts of half the height
    const QPoint centre = viewport()->rect().center();
    return centre + QPoint(static_cast<int>(x * centre.y()), static_cast<int>(y * centre.y()));
  }
  void chooseLook(const QString& name) {
    const int row = window_->lookChoice()->findText(name);
    ASSERT_GE(row, 0) << name.toStdString();
    window_->lookChoice()->setCurrentIndex(row);
    Q_EMIT window_->lookChoice()->activated(row);
  }
  // The full picture tells what else its rays look up: then a little more is baked, and shown.
  bool lightIsThere() {
    return waitUntil([&] { return viewport()->complete() && !window_->light()->changing(); }, 120000);
  }
  template <class Button>
  Button* button(QWidget* in, const QString& text) {
    for (Button* found : in->findChildren<Button*>())
      if (found->text() == text) return found;
    return nullptr;
  }

 private:
  int pictures_ = 0;
};

}  // namespace

TEST_F(FirstVisitTest, GoesThroughWhatTheWindowIsForAndComesBackToTheSamePicture) {
  ISOLUX_NEEDS_DATA();
  const std::filesystem::path folder = temporaryFolder() / "dicom";
  writeDicomFolder(dataFolder() / "volumes/ct_cranium.mhd", folder);
  window_->resize(1280, 800);

  step("open", [&] {
    DialogAnswers answers(QMessageBox::Discard, QString::fromStdString(folder.string()));
    trigger("Open folder (DICOM)…");
    ASSERT_TRUE(waitUntil([&] { return window_->document()->volume() != nullptr; }));
  });
  ui::Edit fewPaths{scene(), "gi.samples", {}, false};
  fewPaths.scene.gi.samples = 8;  // all light is waited for, twice
  window_->document()->edit(fewPaths);
  step("preset", [&] { choosePreset("CT bone"); });
  EXPECT_NEAR(window_->document()->resolvedScene().surfaces.front().value.value_or(0.0), 226.0, 150.0);
  step("turn", [&] { drag(viewport(), at(0.0, 0.0), at(-0.45, 0.2), Qt::LeftButton, {}, 40); });

  step(
      "probe",
      [&] {
        trigger("Pin");
        QTest::mouseClick(viewport(), Qt::LeftButton, {}, at(-0.25, -0.2));
        QTest::mouseClick(viewport(), Qt::LeftButton, {}, at(0.2, -0.25));
        trigger("Geodesic distance");
        QTest::mouseClick(viewport(), Qt::LeftButton, {}, at(-0.25, -0.2));
        QTest::mouseClick(viewport(), Qt::LeftButton, {}, at(0.2, -0.25));
        viewport()->setFocus();
        QTest::keyClick(viewport(), Qt::Key_Escape);
        window_->showPanel("Marks");
      },
      [&] { return scene().marks.size() == 3 && !window_->marks()->measuring(); });
  ASSERT_EQ(scene().marks.size(), 3u);
  const auto& reports = window_->marks()->reports();
  ASSERT_EQ(reports.size(), 3u);
  EXPECT_EQ(reports[2].problem, "");
  EXPECT_GE(reports[2].quantities[0].value + 0.5,
            glm::distance(scene().marks[2].points[0], scene().marks[2].points[1]));

  step("cut", [&] { trigger("Axial plane"); });
  ASSERT_EQ(scene().clip.planes.size(), 1u);
  EXPECT_FALSE(viewport()->cutShapes().empty());
  step(
      "four_up", [&] { QTest::keyClick(window_.get(), Qt::Key_F4); },
      [&] {
        using volume::SliceDirection;
        for (const auto d : {SliceDirection::axial, SliceDirection::coronal, SliceDirection::sagittal})
          if (!window_->slices()->view(d)->complete() || window_->slices()->view(d)->shown().isNull())
            return false;
        return true;
      });
  step("piece", [&] {
    for (int i = 0; i < 2; ++i) QTest::keyClick(window_.get(), Qt::Key_F4);  // past the slices alone
    trigger("Remove all cuts");
    window_->showPanel("Pieces");
    auto* const panel = window_->panel<ui::PiecesPanel>();
    auto* const list = panel->findChild<QTreeWidget*>();
    ASSERT_TRUE(waitUntil([&] { return list->topLevelItemCount() > 0; }));
    list->setCurrentItem(list->topLevelItem(0));
    auto* const only = button<QPushButton>(panel, "Show only");
    ASSERT_TRUE(waitUntil([&] { return only->isEnabled(); }));
    QTest::mouseClick(only, Qt::LeftButton);
  });
  EXPECT_EQ(scene().pieces.only.size(), 1u);
  step("curvature", [&] {
    window_->showPanel("Settings");
    chooseLook("Mean curvature");
  });
  step("light", [&] {
    chooseLook("Global illumination");
    ASSERT_TRUE(waitUntil([&] { return window_->light()->state().counters.rays > 0; }));
    drag(viewport(), at(0.0, 0.0), at(0.3, -0.1), Qt::LeftButton, {}, 40);
  });
  step("own_preset", [&] {
    const TextAnswer name("My skull");
    Q_EMIT window_->presetsMenu()->aboutToShow();
    trigger("Save as preset…");
  });
  ASSERT_TRUE(preset("My skull") != nullptr);
  // Once all light is there, a picture is the same whenever it is drawn.
  ASSERT_TRUE(lightIsThere());
  const QImage before = fullPicture(*window_);
  const QString session = newFile("skull.isolux");
  step("save", [&] {
    DialogAnswers answers(QMessageBox::Discard, session);
    trigger("Save session as…");
    EXPECT_TRUE(waitUntil([&] { return QFile::exists(session); }));
  });
  step("another", [&] { ASSERT_TRUE(load(*window_, "phantom:ball:32")); });
  step("reopen", [&] {
    ASSERT_TRUE(load(*window_, session));
    ASSERT_TRUE(waitUntil([&] { return window_->light()->state().counters.rays > 0; }));
    ASSERT_TRUE(lightIsThere());
  });
  EXPECT_EQ(scene().marks.size(), 3u);
  const QImage after = fullPicture(*window_);
  if (const char* pictures = std::getenv("ISOLUX_VISIT_PICTURES")) {
    before.save(QString(pictures) + "/before.png");
    after.save(QString(pictures) + "/after.png");
  }
  EXPECT_EQ(differingPixels(before, after, 0), 0.0);
}

}  // namespace isolux::test
