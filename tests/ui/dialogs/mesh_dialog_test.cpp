// Meshes from the window: the file that `isolux mesh` writes, stopped without a trace.
#include "tests/support/surfaces.h"
#include "tests/support/ui/window_fixture.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>

#include <QAction>
#include <QComboBox>
#include <QFileInfo>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QTest>

#include "tests/support/test_data.h"
#include "tests/support/ui/dialog_answers.h"
#include "tests/support/ui/run_program.h"
#include "ui/dialogs/mesh_dialog.h"
#include "ui/window/message_bar.h"

namespace isolux::test {

namespace {

std::string contentOf(const std::filesystem::path& file) {
  std::ostringstream content;
  content << std::ifstream(file, std::ios::binary).rdbuf();
  return content.str();
}

ui::MeshDialog* openedMeshDialog(ui::MainWindow& window) {
  for (QAction* menu : window.menuBar()->actions())
    for (QAction* action : menu->menu()->actions())
      if (action->text().startsWith("Export &mesh")) action->trigger();
  return window.findChild<ui::MeshDialog*>();
}

}  // namespace

TEST_F(WindowTest, AMeshFromTheWindowIsThatOfTheCommand) {
  ASSERT_TRUE(load(*window_, "phantom:ball:24"));
  ui::Edit edit{window_->document()->scene(), "Isovalue", {}, false};
  edit.scene.surfaces.front().value = 1.5;
  window_->document()->edit(edit);
  for (const QString ending : {"stl", "ply", "obj", "vtp"}) {
    const QString file = newFile("mesh." + ending);
    DialogAnswers answers(QMessageBox::Cancel, file);
    ui::MeshDialog* dialog = openedMeshDialog(*window_);
    ASSERT_NE(dialog, nullptr);
    EXPECT_FALSE(dialog->isModal());
    QTest::mouseClick(dialog->start, Qt::LeftButton);
    ASSERT_TRUE(waitUntil([&] { return !dialog->exporting(); }));
    ASSERT_TRUE(waitUntil([&] { return dialog->text().startsWith("Saved mesh."); }))
        << dialog->text().toStdString();
    EXPECT_NE(dialog->text().indexOf("triangles"), -1);
    EXPECT_TRUE(window_->messageBar()->text().startsWith("Saved mesh." + ending));
    const std::filesystem::path path = file.toStdString();
    const std::string name = "command." + ending.toStdString();
    ASSERT_EQ(runProgram("mesh phantom:ball:24 --isovalue 1.5 --out " + name, path.parent_path()), 0);
    EXPECT_EQ(contentOf(path), contentOf(path.parent_path() / name));
    delete dialog;
  }
}

TEST_F(WindowTest, TheMeshIsThatOfTheChosenSurfaceAndItsSizeIsKnownBefore) {
  ASSERT_TRUE(load(*window_, "phantom:ball:24"));
  ui::Edit edit{window_->document()->scene(), "Isovalue", {}, false};
  edit.scene.surfaces.front().value = 1.5;
  test::surfaceAt(edit.scene, 2).shown = true;
  test::surfaceAt(edit.scene, 2).value = 3.5;
  window_->document()->edit(edit);
  ui::MeshDialog* dialog = openedMeshDialog(*window_);
  ASSERT_NE(dialog, nullptr);
  ASSERT_EQ(dialog->surface->count(), 2);
  dialog->surface->setCurrentIndex(1);
  const auto texts = dialog->findChildren<QLabel*>();
  EXPECT_TRUE(std::any_of(texts.begin(), texts.end(),
                          [](QLabel* label) { return label->text().startsWith("about "); }));
  const std::filesystem::path path = newFile("mesh.ply").toStdString();
  dialog->exportTo(QString::fromStdString(path.string()));
  ASSERT_TRUE(waitUntil([&] { return dialog->text().startsWith("Saved mesh."); }))
      << dialog->text().toStdString();
  ASSERT_EQ(runProgram("mesh phantom:ball:24 --isovalue 3.5 --out command.ply", path.parent_path()), 0);
  EXPECT_EQ(contentOf(path), contentOf(path.parent_path() / "command.ply"));
  EXPECT_FALSE(dialog->showPlace->isVisible());
}

TEST_F(WindowTest, AStoppedMeshLeavesNoFileAndNoSurfaceIsToldInWords) {
  ASSERT_TRUE(load(*window_, "phantom:head:96"));
  const QString file = newFile("head.vtp");
  ui::MeshDialog* dialog = openedMeshDialog(*window_);
  ASSERT_NE(dialog, nullptr);
  dialog->exportTo(file);
  QTest::mouseClick(dialog->start, Qt::LeftButton);  // Stop
  ASSERT_TRUE(waitUntil([&] { return !dialog->exporting() && !dialog->text().startsWith("Writing"); }));
  EXPECT_TRUE(dialog->text().startsWith("Stopped") || QFileInfo::exists(file))
      << dialog->text().toStdString();
  EXPECT_EQ(dialog->text().startsWith("Stopped"), !QFileInfo::exists(file));
  delete dialog;

  ui::Edit edit{window_->document()->scene(), "Isovalue", {}, false};
  edit.scene.surfaces.front().value = 1e6;
  window_->document()->edit(edit);
  dialog = openedMeshDialog(*window_);
  dialog->exportTo(newFile("none.stl"));
  ASSERT_TRUE(waitUntil([&] { return !dialog->exporting() && !dialog->text().startsWith("Writing"); }));
  EXPECT_NE(dialog->text().indexOf("no surface at"), -1) << dialog->text().toStdString();
}

}  // namespace isolux::test
