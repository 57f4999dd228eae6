// The German translation: complete, well formed, and what the window shows.
#include <map>

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QMenuBar>
#include <QProcess>
#include <QRegularExpression>
#include <QSettings>
#include <QXmlStreamReader>

#include "app/accuracy/error_limits.h"
#include "app/documents/autosave.h"
#include "app/marks/mark_kinds.h"
#include "tests/support/paths.h"
#include "tests/support/test_data.h"
#include "tests/support/ui/window_fixture.h"
#include "tests/ui/language/listed_texts.h"
#include "ui/dialogs/preferences_dialog.h"
#include "ui/editors/setting_editor.h"
#include "ui/language/language.h"
#include "ui/language/number_text.h"
#include "ui/language/sentences.h"
#include "ui/language/translated.h"
#include "ui/panels/marks_panel.h"
#include "ui/panels/panel_layout.h"
#include "ui/panels/settings_panel.h"

namespace isolux::test {

namespace {

struct Entry {
  QString context, source, translation, type;  // type: "" finished
};

std::vector<Entry> readEntries(const QString& file) {
  QFile in(file);
  EXPECT_TRUE(in.open(QIODevice::ReadOnly)) << file.toStdString();
  std::vector<Entry> entries;
  Entry entry;
  QString context;
  QXmlStreamReader xml(&in);
  while (!xml.atEnd()) {
    xml.readNext();
    if (xml.isEndElement() && xml.name() == u"message") entries.push_back(entry);
    if (!xml.isStartElement()) continue;
    if (xml.name() == u"name") context = xml.readElementText();
    if (xml.name() == u"message") entry = {context, {}, {}, {}};
    if (xml.name() == u"source") entry.source = xml.readElementText();
    if (xml.name() == u"translation") {
      entry.type = xml.attributes().value("type").toString();
      entry.translation = xml.readElementText();
    }
  }
  EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
  return entries;
}

QString germanFile() {
  return QString(ISOLUX_SOURCE_DIR) + "/resources/translations/isolux_de.ts";
}

const std::vector<Entry>& german() {
  static const std::vector<Entry> entries = readEntries(germanFile());
  return entries;
}

std::string nameOf(const Entry& entry) {
  return (entry.context + ": \"" + entry.source + '"').toStdString();
}

// What matches, in any order: languages have orders of their own.
QStringList partsOf(const QString& text, const char* expression) {
  QStringList parts;
  for (auto match = QRegularExpression(expression).globalMatch(text); match.hasNext();)
    parts += match.next().captured();
  parts.sort();
  return parts;
}

QString whole(const QString& file) {
  QFile in(file);
  return in.open(QIODevice::ReadOnly) ? QString::fromUtf8(in.readAll()) : QString();
}

// As one text in which adjacent literals are one.
QString sourcesOf(const QStringList& folders) {
  QString all;
  for (const QString& folder : folders) {
    QStringList open{QString(ISOLUX_SOURCE_DIR) + '/' + folder};
    while (!open.isEmpty()) {
      const QDir dir(open.takeLast());
      for (const QFileInfo& info : dir.entryInfoList(QDir::Dirs | QDir::Files | QDir::NoDotAndDotDot)) {
        if (info.isDir()) open += info.filePath();
        if (info.suffix() == "cpp") all += whole(info.filePath());
      }
    }
  }
  return all.replace(QRegularExpression("\"\\s*\n\\s*\""), {});
}

class GermanTest : public WindowTest {
 protected:
  void SetUp() override {
    QSettings().remove("language");
    ui::setLanguage(ui::Language::german);
    WindowTest::SetUp();
  }
  void TearDown() override {
    WindowTest::TearDown();
    ui::setLanguage(ui::Language::english);
    QSettings().remove("language");
  }
};

}  // namespace

TEST(TranslationTest, HasEveryTextOfTheLists) {
  std::map<std::pair<std::string, std::string>, const Entry*> known;
  for (const Entry& entry : german())
    known[{entry.context.toStdString(), entry.source.toStdString()}] = &entry;
  const auto expectKnown = [&](const std::string& context, const std::string& text) {
    const auto found = known.find({context, text});
    ASSERT_NE(found, known.end()) << context << ": \"" << text << "\"; ./dev texts adds it";
    EXPECT_TRUE(found->second->type.isEmpty() && !found->second->translation.isEmpty())
        << nameOf(*found->second);
  };
  const auto listed = listedTexts();
  EXPECT_GT(listed.size(), 500U);
  for (const auto& [context, text] : listed) expectKnown(context, text);
  for (const char* const sentence : ui::knownSentences()) expectKnown("sentences", sentence);
}

TEST(TranslationTest, EveryEntryIsFinishedAndFitsItsText) {
  EXPECT_GT(german().size(), 1000U);
  for (const Entry& entry : german()) {
    SCOPED_TRACE(nameOf(entry) + " -> \"" + entry.translation.toStdString() + '"');
    EXPECT_EQ(entry.type.toStdString(), "");
    EXPECT_FALSE(entry.translation.isEmpty());
    for (const char* const parts : {"%[1-9n]", "</?[a-z][a-z0-9]*>", "\\*\\.[a-z.]+"})
      EXPECT_EQ(partsOf(entry.translation, parts), partsOf(entry.source, parts));
    const auto accelerators = partsOf(entry.source, "&(?=\\S)").size();
    EXPECT_EQ(partsOf(entry.translation, "&(?=\\S)").size(), accelerators);
    EXPECT_LE(accelerators, 1);
    for (const char* const ends : {"^\\s*", "\\s*$"})
      EXPECT_EQ(partsOf(entry.translation, ends), partsOf(entry.source, ends));
  }
}

// What the update of docs/developers/extending.md would add or take out.
TEST(TranslationTest, HoldsWhatIsInTheSourcesAndNothingElse) {
  const QString folder = QString::fromStdString((temporaryFolder() / "texts").string());
  ASSERT_TRUE(QDir().mkpath(folder));
  const QString lists = folder + "/lists.cpp", updated = folder + "/isolux_de.ts";
  QFile out(lists);
  ASSERT_TRUE(out.open(QIODevice::WriteOnly));
  for (const auto& [context, text] : listedTexts()) {
    QString literal = QString::fromStdString(text).replace('\\', "\\\\").replace('"', "\\\"");
    out.write(QString("QT_TRANSLATE_NOOP(\"%1\", \"%2\")\n")
                  .arg(QString::fromStdString(context), literal)
                  .toUtf8());
  }
  out.close();
  QFile::remove(updated);
  ASSERT_TRUE(QFile::copy(germanFile(), updated));
  QProcess lupdate;
  lupdate.setWorkingDirectory(ISOLUX_SOURCE_DIR);
  lupdate.start(ISOLUX_LUPDATE, {"-silent", "-locations", "none", "-I", ".", "ui", lists, "-ts", updated});
  ASSERT_TRUE(lupdate.waitForFinished(120000));
  ASSERT_EQ(lupdate.exitCode(), 0) << lupdate.readAllStandardError().toStdString();
  const auto entries = readEntries(updated);
  EXPECT_GE(entries.size(), german().size());
  for (const Entry& entry : entries)
    EXPECT_EQ(entry.type.toStdString(), "") << nameOf(entry) << "; ./dev texts brings the file up to date";
}

// A literal that is shown as it stands cannot be translated.
TEST(TranslationTest, NoTextIsShownUntranslated) {
  const QString sources = sourcesOf({"ui"});
  ASSERT_GT(sources.size(), 100000);
  const QRegularExpression shown(
      "(?:set(?:Text|ToolTip|WindowTitle|PlaceholderText|AccessibleName|Suffix|Title|StatusTip)|addAction|"
      "addMenu|"
      "addRow|addItem|addSection|addTab|new Q(?:Label|PushButton|CheckBox|RadioButton|GroupBox)|newAction)"
      "\\(\\s*(?:menu, )?\"([^\"]*)\"");
  const QStringList names{"Isolux", "Isolux[*]", "English", "Deutsch"};
  int seen = 0;
  for (auto match = shown.globalMatch(sources); match.hasNext(); ++seen) {
    const QString text = match.next().captured(1);
    EXPECT_TRUE(names.contains(text) || !text.contains(QRegularExpression("[A-Za-z]{3}")))
        << text.toStdString();
  }
  EXPECT_GT(seen, 3) << "the expression finds nothing any more";
}

// A sentence that no lower layer says any more would be a pattern that never matches.
TEST(TranslationTest, SentencesAreStillSaid) {
  const QString sources =
      sourcesOf({"app", "readers", "render", "ui/document", "volume/read", "volume/statistics"});
  for (const char* const sentence : ui::knownSentences())
    for (QString part : QString::fromUtf8(sentence).split(QRegularExpression("%[1-9]|\\b(the )?point\\b"))) {
      part = part.trimmed();
      EXPECT_TRUE(sources.contains(part) || sources.contains(QString(part).replace(' ', '_')))
          << sentence << ": " << part.toStdString();
    }
}

TEST(TranslationTest, TheSystemsLanguageDecides) {
  using ui::Language;
  EXPECT_EQ(ui::spokenOf({"de-AT", "en"}), Language::german);
  EXPECT_EQ(ui::spokenOf({"de_DE.UTF-8"}), Language::german);
  EXPECT_EQ(ui::spokenOf({"fr", "de", "en"}), Language::german);
  EXPECT_EQ(ui::spokenOf({"en-GB", "de"}), Language::english);
  EXPECT_EQ(ui::spokenOf({"deu-x"}), Language::english);
  EXPECT_EQ(ui::spokenOf({"C"}), Language::english);
  EXPECT_EQ(ui::spokenOf({}), Language::english);
}

TEST(TranslationTest, AnUnknownTextStaysAsItIs) {
  ui::setLanguage(ui::Language::german);
  EXPECT_EQ(ui::translated(ui::texts::presets, "My own preset"), "My own preset");
  EXPECT_EQ(ui::translatedSentence("nobody has said this"), "nobody has said this");
  EXPECT_EQ(ui::translatedSentence("No surface at 300: the data range is -1 to 2"),
            "Keine Oberfläche bei 300: Der Wertebereich ist -1 bis 2");
  EXPECT_EQ(ui::translatedSentence(app::agoText(std::chrono::minutes(5))), "vor 5 min");
  ui::setLanguage(ui::Language::english);
  EXPECT_EQ(ui::translatedSentence(app::agoText(std::chrono::minutes(5))), "5 min ago");
}

TEST(TranslationTest, WhyNoSettingsKeepAnErrorIsSaidInGermanAsAWhole) {
  const char* const english[] = {"depth", "depth", "missed", "normal", "curvature", "light"};
  const char* const german[] = {"Tiefe", "Tiefe", "verfehlt", "Normale", "Krümmung", "Licht"};
  ui::setLanguage(ui::Language::german);
  for (const app::Quantity quantity : app::kAllQuantities) {
    const app::Limit limit{quantity, 0.5};
    const QString text =
        ui::translatedWithParts("no settings keep " + app::limitsText({&limit, 1}) +
                                ", missed at most 0.1 %; the smallest guaranteed error is " +
                                app::nameOf(quantity) + ' ' + app::errorText(quantity, 0.25));
    const auto at = app::indexOf(quantity);
    const QString unit = QString::fromStdString(app::errorText(quantity, 0.5)).section(' ', 1);
    const QString inGerman = unit == "degrees" ? "Grad" : unit == "voxels" ? "Voxel" : unit;
    const QString half = QString::fromStdString(app::errorText(quantity, 0.5)).section(' ', 0, 0);
    const QString quarter = QString::fromStdString(app::errorText(quantity, 0.25)).section(' ', 0, 0);
    EXPECT_EQ(text,
              QString("keine Einstellungen halten ein: %1 höchstens %2 %4, verfehlt höchstens 0.1 %; der "
                      "kleinste zugesicherte Fehler ist %1 %3 %4")
                  .arg(german[at], half, quarter, inGerman))
        << english[at];
  }
  ui::setLanguage(ui::Language::english);
}

TEST(TranslationTest, AMarkSaysTheSameInBothLanguages) {
  scene::Mark mark{scene::MarkKind::thickness, "Wall", {glm::dvec3(0.0)}};
  app::MarkReport report;
  report.place = "L 1.0 mm";
  report.quantities = {{"surface_distance", 4.0, 0.25, "mm"}};
  report.notes = {"point 2 is 3 mm off the surface"};
  EXPECT_EQ(ui::markText(mark, report).toStdString(), app::fullText(mark, report));
  ui::setLanguage(ui::Language::german);
  EXPECT_EQ(ui::markText(mark, report),
            "Wall (Dicke)\n  L 1.0 mm\n  Abstand zur Oberfläche: 4.00 ± 0.25 mm\n"
            "  Hinweis: Punkt 2 ist 3 mm von der Oberfläche entfernt\n");
  ui::setLanguage(ui::Language::english);
}

TEST_F(GermanTest, EveryEntryIsFoundWhereItIsLookedUp) {
  for (const Entry& entry : german())
    EXPECT_EQ(QCoreApplication::translate(entry.context.toUtf8(), entry.source.toUtf8()), entry.translation)
        << nameOf(entry);
}

TEST_F(GermanTest, TheWindowSpeaksIt) {
  QStringList menus;
  for (QAction* action : window_->menuBar()->actions()) menus += action->text();
  for (const char* const title : {"&Datei", "&Bearbeiten", "&Ansicht", "&Messen", "&Hilfe"})
    EXPECT_TRUE(menus.contains(title)) << title << " is none of " << menus.join(' ').toStdString();
  ASSERT_TRUE(load(*window_, "phantom:ball:24"));
  EXPECT_EQ(ui::wordsOf("mean_curvature"), "Mittlere Krümmung");
  EXPECT_EQ(ui::labelOf(scene::setting("isosurface.opacity")).text, "Deckkraft");
  auto* const editor = window_->panel<ui::SettingsPanel>()->editor("look.ambient");
  scene::Scene scene = window_->document()->scene();
  scene.look.ambient = 0.77;
  window_->document()->edit({scene, "before", {}, false});
  editor->resetToDefault();
  EXPECT_EQ(window_->document()->history().undoName(), "Umgebungslicht ändern");
  // Panels are called by their names, not by what their tabs say.
  window_->showPanel("marks");
  EXPECT_TRUE(waitUntil([&] { return window_->panel<ui::MarksPanel>()->isVisible(); }));
}

TEST_F(GermanTest, TheLanguageIsAPreferenceOfTheUser) {
  ui::PreferencesDialog dialog({}, nullptr);
  QComboBox* const box = dialog.languageBox();
  EXPECT_EQ(ui::savedLanguage(), ui::Language::system);
  box->setCurrentIndex(box->findText("Deutsch"));
  EXPECT_EQ(ui::savedLanguage(), ui::Language::german);
  EXPECT_EQ(ui::PreferencesDialog({}, nullptr).languageBox()->currentText(), "Deutsch");
  box->setCurrentIndex(box->findText("English"));
  EXPECT_EQ(ui::savedLanguage(), ui::Language::english);
  dialog.restoreDefaults();
  EXPECT_EQ(ui::savedLanguage(), ui::Language::system);
  EXPECT_FALSE(QSettings().contains("language"));
}

}  // namespace isolux::test
