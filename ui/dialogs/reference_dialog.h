// Path traces the view pixel by pixel, for print: size and samples, a preview that becomes better, saving.
//
// Traces the scene as it was when tracing began; the window stays usable meanwhile. Without the dialog the
// tracing stops; a file that is being written is finished.
#pragma once

#include <future>
#include <memory>

#include <QDialog>
#include <QLabel>
#include <QTimer>

#include "app/tasks/reference_task.h"
#include "ui/document/background_task.h"
#include "ui/widgets/time_left.h"

class QComboBox;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace isolux::ui {

class ReferenceDialog : public QDialog {
  Q_OBJECT
 public:
  // `given`: the scene before it was resolved, of which its pictures carry what app::carriedScene() says.
  ReferenceDialog(std::shared_ptr<const volume::PreparedVolume> volume, const scene::Scene& given,
                  scene::Scene resolved, QSize size, std::optional<int> threads, QWidget* parent = nullptr);

  bool tracing() const { return bool(task_); }
  app::ReferencePointer image() const { return {round_, round_ ? &round_->image : nullptr}; }
  QSpinBox* samplesBox() const { return samples_; }
  QPushButton* startButton() const { return start_; }  // also stops
  QPushButton* saveButton() const { return save_; }
  QString text() const { return text_->text(); }
  // .exr (with the variance) or .png, written beside the window; text() tells the end. False: nothing to
  // save, or still saving.
  bool saveAs(const QString& file);
  bool saving() const { return saving_.valid(); }

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void startOrStop();
  void takeRound(app::ReferenceTask& task);
  void showProgress();
  void takeEnd(app::ReferenceTask& task);
  QString noiseText() const;
  void showImage();
  void pollSaving();
  void tell(const QString& text, bool wrong = false);
  void choose();

  std::shared_ptr<const volume::PreparedVolume> volume_;
  const scene::Scene carried_;  // by its pictures
  scene::Scene resolved_;
  std::optional<int> threads_;  // scene::HostSettings::threads
  BackgroundTask<void, app::RoundPointer> task_;
  app::RoundPointer round_;
  std::future<QString> saving_;  // why it failed; empty: it did not
  QString savedName_;
  QSpinBox *width_, *height_, *samples_;
  QComboBox* shown_;
  QLabel *preview_, *text_;
  QProgressBar* bar_;
  QPushButton *start_, *save_;
  TimeLeft left_;
  QTimer saveTimer_;
};

}  // namespace isolux::ui
