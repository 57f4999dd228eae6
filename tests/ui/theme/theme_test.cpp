// Both themes: what reads on what, and that all of the window follows when another is chosen.
#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QMenu>
#include <QSpinBox>
#include <QToolBar>
#include <QToolButton>

#include <gtest/gtest.h>

#include "tests/support/ui/window_fixture.h"
#include "ui/dialogs/preferences_dialog.h"
#include "ui/document/preferences.h"
#include "ui/theme/icons.h"
#include "ui/theme/style.h"
#include "ui/theme/theme.h"

namespace isolux::test {
namespace {

using ui::Theme;
using ui::ThemeColours;

constexpr double forText = 4.5, forEdges = 3.0;  // WCAG 2.1, AA

TEST(ThemeContrast, IsThatOfTheStandard) {
  EXPECT_NEAR(ui::contrast(Qt::black, Qt::white), 21.0, 1e-9);
  EXPECT_NEAR(ui::contrast(QColor(0x77, 0x77, 0x77), Qt::white), 4.48, 0.01);  // known to fail narrowly
  EXPECT_NEAR(ui::contrast(Qt::white, QColor(0x76, 0x76, 0x76)), 4.54, 0.01);  // known to pass
}

TEST(ThemeContrast, TextsAndEdgesReadInBothThemes) {
  for (const Theme theme : {Theme::dark, Theme::light}) {
    const ThemeColours& c = ui::coloursOf(theme);
    const char* const name = theme == Theme::dark ? "dark" : "light";
    for (const QColor& ground : {c.window, c.base, c.raised})
      for (const QColor& text : {c.text, c.quietText})
        EXPECT_GE(ui::contrast(text, ground), forText) << name << ' ' << text.name().toStdString();
    for (const QColor& ground : {c.window, c.base})
      for (const QColor& text : {c.error, c.warning, c.good})
        EXPECT_GE(ui::contrast(text, ground), forText) << name << ' ' << text.name().toStdString();
    for (const QColor& area : {c.noteArea, c.errorArea})
      EXPECT_GE(ui::contrast(c.text, area), forText) << name;
    EXPECT_GE(ui::contrast(c.onAccent, c.accent), forText) << name;
    EXPECT_GE(ui::contrast(c.onIsovalue, c.isovalue), forText) << name;
    for (const QColor& ground : {c.window, c.base})
      for (const QColor& line : {c.edge, c.accent, c.isovalue})
        EXPECT_GE(ui::contrast(line, ground), forEdges) << name << ' ' << line.name().toStdString();
    EXPECT_GE(ui::contrast(c.plotInside, c.base), forEdges) << name;
    EXPECT_GE(ui::contrast(c.error, c.errorArea), forEdges) << name;
    EXPECT_GE(ui::contrast(c.accent, c.noteArea), forEdges) << name;
  }
}

class ThemeTest : public WindowTest {
 protected:
  void TearDown() override {
    WindowTest::TearDown();
    ui::applyTheme(Theme::dark);
  }
};

// The colour that most pixels have.
QColor groundOf(const QImage& image) {
  QHash<QRgb, int> counts;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) ++counts[image.pixel(x, y)];
  QRgb most = 0;
  for (auto it = counts.begin(); it != counts.end(); ++it)
    if (it.value() > counts.value(most)) most = it.key();
  return QColor::fromRgb(most);
}

TEST_F(ThemeTest, ThePaletteAndWhatIsPaintedHaveItsContrast) {
  for (const Theme theme : {Theme::light, Theme::dark}) {
    ui::applyTheme(theme);
    const QPalette palette = QApplication::palette();
    for (const auto& [ink, ground] :
         {std::pair{QPalette::WindowText, QPalette::Window}, std::pair{QPalette::Text, QPalette::Base},
          std::pair{QPalette::ButtonText, QPalette::Button},
          std::pair{QPalette::PlaceholderText, QPalette::Base},
          std::pair{QPalette::HighlightedText, QPalette::Highlight},
          std::pair{QPalette::ToolTipText, QPalette::ToolTipBase},
          std::pair{QPalette::Link, QPalette::Window}})
      EXPECT_GE(ui::contrast(palette.color(ink), palette.color(ground)), forText) << ink;
    // An edge about a field, as it is drawn.
    QSpinBox box;
    box.resize(90, 26);
    const QImage drawn = box.grab().toImage();
    double best = 0.0;
    for (int y = 0; y < drawn.height(); ++y)
      best = std::max(best, ui::contrast(drawn.pixelColor(0, y), palette.color(QPalette::Window)));
    EXPECT_GE(best, forEdges);
  }
}

TEST_F(ThemeTest, TheWholeWindowFollowsAtOnce) {
  ASSERT_TRUE(load(*window_, "phantom:ball:24"));
  QToolBar* const bar = window_->findChild<QToolBar*>("Tools");
  ASSERT_NE(bar, nullptr);
  const ThemeColours &dark = ui::coloursOf(Theme::dark), &light = ui::coloursOf(Theme::light);
  EXPECT_EQ(groundOf(bar->grab().toImage()), dark.window);
  ui::applyTheme(Theme::light);
  QCoreApplication::processEvents();
  EXPECT_EQ(groundOf(bar->grab().toImage()), light.window);
  // No widget has kept a colour of the other theme for itself.
  for (const QWidget* widget : window_->findChildren<QWidget*>())
    for (const QColor& color : {dark.window, dark.base, dark.border, dark.text, dark.quietText, dark.error,
                                dark.warning, dark.accent})
      EXPECT_FALSE(widget->styleSheet().contains(color.name(), Qt::CaseInsensitive))
          << widget->metaObject()->className() << ' ' << widget->objectName().toStdString() << ": "
          << widget->styleSheet().toStdString();
  for (const QLabel* label : window_->findChildren<QLabel*>())
    if (label->property("ink").toString() == "quiet") {
      EXPECT_EQ(label->palette().color(QPalette::WindowText), light.quietText);
    }
}

TEST_F(ThemeTest, IconsAreDrawnInItsTextColour) {
  const QIcon open = ui::icon("open");
  const auto ink = [&](double ratio) {
    const QImage image = open.pixmap(QSize(24, 24), ratio).toImage();
    EXPECT_EQ(image.width(), static_cast<int>(24 * ratio));
    QColor strongest;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x)
        if (image.pixelColor(x, y).alpha() >= strongest.alpha()) strongest = image.pixelColor(x, y);
    return strongest;
  };
  for (const Theme theme : {Theme::light, Theme::dark}) {
    ui::applyTheme(theme);
    for (const double ratio : {1.0, 2.0, 3.0}) {
      const QColor drawn = ink(ratio), text = ui::coloursOf(theme).text;
      EXPECT_NEAR(drawn.red(), text.red(), 3) << ratio;
      EXPECT_NEAR(drawn.blue(), text.blue(), 3) << ratio;
    }
  }
}

TEST_F(ThemeTest, ThePreferencesChooseItAndItIsKept) {
  ui::PreferencesDialog dialog(window_->host(), window_.get());
  EXPECT_EQ(ui::savedTheme(), Theme::dark);
  dialog.themeBox()->setCurrentIndex(static_cast<int>(Theme::light));
  EXPECT_EQ(ui::theme(), Theme::light);
  EXPECT_EQ(ui::savedTheme(), Theme::light);
  EXPECT_EQ(QApplication::palette().color(QPalette::Window), ui::coloursOf(Theme::light).window);
  dialog.scaleBox()->setValue(200);
  EXPECT_EQ(ui::savedScale(), 200);
  dialog.restoreDefaults();
  EXPECT_EQ(ui::savedTheme(), Theme::dark);
  EXPECT_EQ(ui::savedScale(), 100);
}

TEST(InterfaceScale, IsWithinItsRangeAndLeavesTheEnvironmentAlone) {
  const QByteArray before = qgetenv("QT_SCALE_FACTOR");
  qunsetenv("QT_SCALE_FACTOR");
  ui::applyInterfaceScale(100);
  EXPECT_FALSE(qEnvironmentVariableIsSet("QT_SCALE_FACTOR"));
  ui::applyInterfaceScale(10);
  EXPECT_FALSE(qEnvironmentVariableIsSet("QT_SCALE_FACTOR")) << "Qt does not paint all of a smaller window";
  EXPECT_EQ(ui::textScale(), 0.75);
  ui::applyInterfaceScale(1000);
  EXPECT_EQ(ui::textScale(), 1.0);
  EXPECT_EQ(qgetenv("QT_SCALE_FACTOR").toDouble(), 3.0);
  ui::applyInterfaceScale(150);
  EXPECT_EQ(qgetenv("QT_SCALE_FACTOR").toDouble(), 3.0) << "what is set holds";
  if (before.isNull())
    qunsetenv("QT_SCALE_FACTOR");
  else
    qputenv("QT_SCALE_FACTOR", before);
}

}  // namespace
}  // namespace isolux::test
