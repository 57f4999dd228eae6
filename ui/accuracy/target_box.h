// "Error at most", "Time at most": searches the settings that keep one of them for the view on show
// (app/error_budget/target_search.h), says what they cost, and applies them as one edit.
//
// A search begins with a click and ends at once when anything of its question changes.
#pragma once

#include <optional>

#include <QLabel>
#include <QRadioButton>
#include <QWidget>

#include "app/error_budget/target_search.h"
#include "ui/document/background_task.h"
#include "ui/document/edit.h"

class QComboBox;
class QPushButton;

namespace isolux::ui {

class NumberSpinBox;

class TargetBox : public QWidget {
  Q_OBJECT
 public:
  explicit TargetBox(QWidget* parent = nullptr);

  // What is searched in; its limits are not read. Without a volume, or a size: nothing can be searched.
  void setSubject(const app::TargetSubject& subject);
  void drop();  // the search, and what it found

  void askError(app::Quantity quantity, double most);  // in unitTextOf(quantity)
  void askTime(double milliseconds);
  std::optional<app::Limit> limit() const;  // the error that is entered; none: a time is
  QPushButton* findButton() const { return find_; }
  QPushButton* applyButton() const { return apply_; }
  QString text() const { return text_->text(); }  // what was found, or why nothing was
  bool searching() const { return bool(task_); }
  const std::optional<app::TargetAnswer>& answer() const { return answer_; }

 Q_SIGNALS:
  void limitChanged();
  void searchingChanged();
  void edited(const isolux::ui::Edit& edit);

 private:
  void makeRows();
  void find();
  void take(app::TargetTask& task);
  void apply();
  void showState();
  bool asksTime() const { return time_->isChecked(); }
  app::Quantity quantity() const;
  QString questionName() const;  // of the step of undo

  app::TargetSubject subject_;
  BackgroundTask<std::optional<app::TargetAnswer>> task_;
  std::optional<app::TargetAnswer> answer_;
  QString said_;  // of the last search

  QRadioButton *error_, *time_;
  NumberSpinBox *most_, *milliseconds_;
  QComboBox* unit_;
  QPushButton *find_, *apply_;
  QLabel* text_;
};

}  // namespace isolux::ui
