// The panel of what accuracy costs: measured when the window rests, dropped when it does not, a click is an
// edit.
#include "ui/accuracy/accuracy_panel.h"

#include <QCategoryAxis>
#include <QChart>
#include <QComboBox>
#include <QLabel>
#include <QTest>

#include "tests/support/ui/window_fixture.h"
#include "ui/accuracy/accuracy_chart.h"
#include "ui/viewport/viewport.h"

namespace isolux::test {
namespace {

class AccuracyPanelTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    ASSERT_TRUE(load(*window_, "phantom:torus:24"));
  }
  ui::AccuracyPanel* panel() { return window_->panel<ui::AccuracyPanel>(); }
  const scene::Scene& scene() { return window_->document()->scene(); }
  void openMeasured() {
    window_->showPanel("Accuracy");
    ASSERT_TRUE(waitUntil([&] { return panel()->complete(); }, 120000)) << panel()->state().toStdString();
  }
  void look(const char* quality) {
    panel()->qualityBox()->setCurrentIndex(panel()->qualityBox()->findData(quality));
  }
};

TEST_F(AccuracyPanelTest, NothingOfItRunsWhileItIsNotSeen) {
  fullPicture(*window_);
  window_->showPanel("Passes");
  EXPECT_EQ(panel()->jobsBegun(), 0);
  EXPECT_FALSE(panel()->working());
}

TEST_F(AccuracyPanelTest, MeasuresEveryKnobThatActsAndAClickedPointIsUsed) {
  openMeasured();
  EXPECT_EQ(panel()->qualityBox()->findData("rate"), -1);  // hits are exact
  look("derivatives_field");
  const std::vector<app::QualityPoint>& points = panel()->chart().points();
  ASSERT_EQ(points.size(), 3u);
  EXPECT_TRUE(points[1].isPresent && points[1].isDefault);  // cubic
  EXPECT_GT(points[0].error, points[1].error);              // trilinear
  auto* const chart = panel()->findChild<ui::AccuracyChart*>();
  QTest::mouseClick(chart->viewport(), Qt::LeftButton, {}, chart->placeOf(0).toPoint());
  EXPECT_EQ(scene().derivatives.field, scene::Field::trilinear);
  EXPECT_TRUE(panel()->chart().points()[0].isPresent);
  EXPECT_TRUE(panel()->complete());  // turning a quality setting asks for no new measurement
  window_->document()->undo();
  EXPECT_EQ(scene().derivatives.field, scene::Field::cubic);
}

TEST_F(AccuracyPanelTest, AnotherViewIsMeasuredAnew) {
  openMeasured();
  const int before = panel()->jobsBegun();
  window_->viewport()->applyStandardView(scene::StandardView::left);
  EXPECT_FALSE(panel()->complete());
  EXPECT_TRUE(waitUntil([&] { return panel()->complete(); }, 120000));
  EXPECT_GT(panel()->jobsBegun(), before);
}

// Every decade and what is between, all in one way: QLogValueAxis leaves the lowest out, and mixes 0.0001
// with 1e-05.
TEST(AccuracyChart, TicksOfTheErrorAreLabelledInOneWay) {
  const auto labelsOf = [](double least, double most) {
    ui::AccuracyChart chart;
    app::QualityPoint cheap, dear;
    cheap.error = most;
    dear.error = least;
    cheap.cost = 1.0;
    dear.cost = 2.0;
    chart.show({cheap, dear}, "ms", "voxels");
    auto* const axis = qobject_cast<QCategoryAxis*>(chart.chart()->axes(Qt::Vertical).front());
    QStringList labels = axis ? axis->categoriesLabels() : QStringList();
    for (QString& label : labels) label = label.trimmed();
    return labels;
  };
  EXPECT_EQ(labelsOf(2.2e-5, 5e-5), QStringList({"10⁻⁵", "2·10⁻⁵", "5·10⁻⁵", "10⁻⁴"}));
  EXPECT_EQ(labelsOf(0.02, 3.0), QStringList({"0.01", "0.1", "1", "10"}));
}

TEST(AccuracyPanel, SaysWhatToDoWithoutAVolume) {
  const ui::AccuracyPanel panel;
  EXPECT_TRUE(panel.state().contains("Open a volume")) << panel.state().toStdString();
}

}  // namespace
}  // namespace isolux::test
