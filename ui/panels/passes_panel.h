// What the last picture cost: each pass of the frame graph, whether it ran, why, how long, how much memory.
//
// Shows the last picture for which something ran; that the same picture was shown again for nothing is said
// below it. Follows moving pictures a few times a second and costs nothing while it is hidden.
#pragma once

#include <map>

#include <QTimer>

#include "ui/panels/panel.h"
#include "ui/viewport/canvas_choice.h"

class QLabel;
class QTreeWidget;

namespace isolux::ui {

class PassesPanel : public Panel {
  Q_OBJECT
 public:
  explicit PassesPanel(QWidget* parent = nullptr);

  void setReport(const render::FrameReport& report, const render::FrameRequest& request) override;  // cheap
  void setCanvas(const CanvasChoice& canvas) { canvas_ = canvas; }  // how the window shows images
  QString text() const;  // the table as tab-separated lines, for other programs

 protected:
  void showEvent(QShowEvent* event) override;
  void themeChanged() override;

 private:
  void refresh();
  void showPasses();
  void write();
  QString summary() const;
  QLabel *heading_, *summary_;
  QTreeWidget* table_;
  QTimer timer_;
  render::FrameReport report_;
  render::FrameRequest request_;
  CanvasChoice canvas_;
  int shownAgain_ = 0;                       // since report_
  std::map<std::string, double> lastTimes_;  // milliseconds, of each pass when it last ran
};

}  // namespace isolux::ui
