// The patient's name, id and birth date: on the screen, and in what is saved.
#include "tests/support/ui/window_fixture.h"

#include <algorithm>
#include <fstream>
#include <sstream>

#include <QAction>
#include <QCheckBox>
#include <QMenuBar>
#include <QPushButton>

#include "app/documents/session.h"
#include "app/files/image_io.h"
#include "scene/settings/host_settings.h"
#include "tests/support/test_data.h"
#include "tests/support/ui/dialog_answers.h"
#include "tests/volume/read/dicom_disc.h"
#include "ui/dialogs/picture_dialog.h"
#include "ui/dialogs/preferences_dialog.h"
#include "ui/document/privacy.h"
#include "ui/panels/volume_panel.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/wrapped_text.h"
#include "ui/window/message_bar.h"

namespace isolux::test {

namespace {

class PrivacyTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    folder_ = temporaryFolder() / "DOE_JANE_ID4711";
    DicomSlice slice;
    slice.patient = "DOE^JANE";
    slice.id = "ID4711";
    slice.birthDate = "19600102";
    slice.description = "Skull of Doe";
    slice.spacing = "2\\2";
    writeDicomSeries(folder_, slice, 16, [](int i) { return placeAt(0, 2.0 * i); });
    ASSERT_TRUE(load(*window_, QString::fromStdString(folder_.string())));
    fullPicture(*window_);
  }
  static std::string contentOf(const QString& file) {
    std::ifstream stream(file.toStdString(), std::ios::binary);
    return (std::ostringstream() << stream.rdbuf()).str();
  }
  static bool namesHer(const std::string& text) {
    for (const char* name : {"DOE", "of Doe", "Doe, left", "JANE", "4711", "1960"})
      if (text.find(name) != std::string::npos) return true;
    return false;
  }
  QString shownOnScreen() const {
    QStringList texts{window_->windowTitle(), window_->messageBar()->text()};
    for (const QWidget* widget : window_->panel<ui::VolumePanel>()->findChildren<QWidget*>()) {
      texts += widget->toolTip();
      if (const auto* text = qobject_cast<const ui::WrappedText*>(widget)) texts += text->text();
    }
    return texts.join('\n');
  }
  QAction* action(const QString& text) const {
    for (QAction* menu : window_->menuBar()->actions())
      for (QAction* entry : menu->menu()->actions())
        if (entry->text().startsWith(text)) return entry;
    return nullptr;
  }

  std::filesystem::path folder_;
};

}  // namespace

TEST_F(PrivacyTest, ThePatientIsNamedUntilTheUserHidesThem) {
  EXPECT_TRUE(namesHer(shownOnScreen().toStdString()));
  QAction* const hide = action("&Hide patient data");
  ASSERT_NE(hide, nullptr);
  hide->trigger();
  EXPECT_FALSE(namesHer(shownOnScreen().toStdString())) << shownOnScreen().toStdString();
  EXPECT_TRUE(window_->windowTitle().contains("anonymous"));
  EXPECT_TRUE(shownOnScreen().contains("Skull of anonymous"));
  hide->trigger();
  EXPECT_TRUE(namesHer(shownOnScreen().toStdString()));
}

TEST_F(PrivacyTest, PicturesNameNobodyUnlessTheUserWants) {
  ui::Edit edit{window_->document()->scene(), "Name a mark", {}, false};
  edit.scene.marks.push_back({.name = "Doe, left", .points = {{1, 2, 3}}});
  window_->document()->edit(edit);
  const QString picture = newFile("picture.png");
  ASSERT_TRUE(window_->savePicture(picture));
  EXPECT_FALSE(namesHer(app::readSessionText(picture.toStdString())));
  // It opens again, from wherever it lies.
  const scene::Scene opened = app::loadSession(picture.toStdString());
  EXPECT_EQ(opened.source.path, folder_.string());
  EXPECT_EQ(opened.marks.front().name, "anonymous, left");

  ui::keepPrivacy({.hideOnScreen = false, .hideInSaved = false});
  ASSERT_TRUE(window_->savePicture(picture));
  EXPECT_TRUE(namesHer(app::readSessionText(picture.toStdString())));
}

TEST_F(PrivacyTest, MarksRecordingsAndProposedNamesNameNobody) {
  const QString recording = newFile("recording.jsonl");
  ASSERT_TRUE(window_->document()->startRecording(recording));
  ui::Edit edit{window_->document()->scene(), "Name a mark", {}, false};
  edit.scene.marks.push_back({.name = "Doe, left", .points = {{1, 2, 3}}});
  window_->document()->edit(edit);
  window_->document()->stopRecording();
  EXPECT_NE(contentOf(recording).find("anonymous, left"), std::string::npos);
  EXPECT_EQ(contentOf(recording).find("Doe"), std::string::npos);
  for (const char* name : {"marks.mrk.json", "marks.csv"}) {
    const QString file = newFile(name);
    ASSERT_TRUE(window_->exportMarks(file));
    EXPECT_FALSE(namesHer(contentOf(file))) << name;
    EXPECT_NE(contentOf(file).find("anonymous, left"), std::string::npos) << name;
  }
  DialogAnswers answers(QMessageBox::Cancel);
  action("Save &image")->trigger();
  const auto* const dialog = window_->findChild<ui::PictureDialog*>();
  ASSERT_NE(dialog, nullptr);
  const QList<QPushButton*> buttons = dialog->findChildren<QPushButton*>();
  const auto save = std::find_if(buttons.begin(), buttons.end(),
                                 [](const QPushButton* button) { return button->text() == "&Save…"; });
  ASSERT_NE(save, buttons.end());
  (*save)->click();  // the dialog is gone then
  EXPECT_EQ(answers.proposal(), "anonymous.png");
}

TEST_F(PrivacyTest, ThePreferencesHaveBothChoices) {
  ui::PreferencesDialog dialog(scene::HostSettings{}, window_.get());
  EXPECT_FALSE(dialog.hideOnScreenBox()->isChecked());
  EXPECT_TRUE(dialog.hideInSavedBox()->isChecked()) << "on by default";
  dialog.hideInSavedBox()->click();
  EXPECT_EQ(ui::savedPrivacy(), (ui::Privacy{.hideOnScreen = false, .hideInSaved = false}));
  dialog.hideOnScreenBox()->click();
  EXPECT_EQ(ui::savedPrivacy(), (ui::Privacy{.hideOnScreen = true, .hideInSaved = false}));
}

}  // namespace isolux::test
