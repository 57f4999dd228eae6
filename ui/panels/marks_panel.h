// The marks of the scene: names, what they say with its error, colours; measured, renamed, hidden, deleted,
// copied, saved and opened here.
#pragma once

#include <vector>

#include <QPlainTextEdit>

#include "app/marks/mark_report.h"
#include "ui/panels/panel.h"

class QLabel;
class QToolButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace isolux::ui {

class ColorButton;

class MarksPanel : public Panel {
  Q_OBJECT
 public:
  explicit MarksPanel(QWidget* parent = nullptr);

  void setScene(const scene::Scene& scene, const scene::Scene& resolved) override;
  // One for each mark of the scene; measuring: some are still being computed.
  void setReports(const std::vector<app::MarkReport>& reports, bool measuring);

  int current() const;                                         // mark of the list; -1: none
  QString details() const { return details_->toPlainText(); }  // all that the current mark says
  QString text() const;                                        // all that all marks say, for other programs

 protected:
  void themeChanged() override { showMarks(); }

 Q_SIGNALS:
  void chosen(glm::dvec3 worldMm);  // a mark of the list: its first point
  void exportWanted();
  void importWanted();
  void stopWanted();
  void anywayWanted();  // lengths are to be measured though they are doubtful

 private:
  enum Column { nameColumn, valueColumn, columns };
  QToolButton* addButton(const QString& text, const QString& tip, void (MarksPanel::*clicked)());
  void makeList();
  void showMarks();
  void showDetails();
  void tellChosen();
  void showRow(QTreeWidgetItem* item, std::size_t mark);
  void itemEdited(QTreeWidgetItem* item, int column);
  void recolour(glm::dvec3 linear);
  void deleteChosen();
  void copy();
  void send(std::vector<scene::Mark> marks, const QString& name, const QString& mergeKey = {});

  scene::Scene scene_;
  std::vector<app::MarkReport> reports_;
  bool filling_ = false;  // the list is being written, not edited
  QLabel *empty_, *measuring_;
  QTreeWidget* list_;
  QPlainTextEdit* details_;
  ColorButton* colour_;
  QToolButton *delete_, *copy_, *export_, *import_, *stop_, *anyway_;
};

}  // namespace isolux::ui
