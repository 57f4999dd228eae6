// What is being loaded, how far it is, a first look at it where one is to be had before, and a way to stop
// it: a card over the picture that blocks nothing.
#pragma once

#include <cstddef>

#include <QFrame>
#include <QLabel>
#include <QTimer>

#include "app/tasks/volume_preview_task.h"
#include "ui/document/background_task.h"
#include "ui/widgets/time_left.h"

class QProgressBar;
class QPushButton;

namespace isolux::ui {

class LoadCard : public QFrame {
  Q_OBJECT
 public:
  explicit LoadCard(QWidget* parent);  // stays at the lower edge of `parent`

  void begin(const QString& name);  // shows itself only when the work takes noticeable time
  void report(double fraction, const QString& stage);
  // A picture of what is being loaded, until end(). Begins with a scene of it.
  void lookAt(const scene::Scene& scene);
  bool showsPicture() const { return !picture_->isHidden(); }
  void setLeastBytes(std::size_t bytes) { leastBytes_ = bytes; }  // of volumes that are looked at; for tests
  void end();

 Q_SIGNALS:
  void cancelled();

 protected:
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  void place();
  int cardWidth() const;
  QString name_;
  void showPreview(const app::DrawnVolumePreview& preview);
  void dropLook();

  std::size_t leastBytes_ = volume::kPreviewLeastBytes;
  BackgroundTask<std::optional<app::DrawnVolumePreview>> look_;
  QLabel *picture_, *caption_;  // hidden where there is none
  QLabel *title_, *stage_;
  QProgressBar* bar_;
  QPushButton* cancel_;
  TimeLeft left_;
  QTimer delay_;
};

}  // namespace isolux::ui
