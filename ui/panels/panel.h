// A panel of the window: overrides the functions for what it shows; they cost nothing where they are not
// overridden.
#pragma once

#include <QWidget>

#include "render/graph/frame.h"
#include "ui/document/document.h"
#include "ui/document/edit.h"

namespace isolux::ui {

class Panel : public QWidget {
  Q_OBJECT
 public:
  using QWidget::QWidget;
  virtual void setVolume(const VolumePointer&) {}
  virtual void setFirstPicture(double) {}  // seconds since the volume's bytes were read
  virtual void setScene(const scene::Scene&, const scene::Scene& /*resolved*/) {}
  virtual void setReport(const render::FrameReport&, const render::FrameRequest&) {}  // of every picture

 protected:
  virtual void themeChanged() {}  // what was filled in with its colours
  void changeEvent(QEvent* event) override;

 Q_SIGNALS:
  void edited(const isolux::ui::Edit& edit);
  void dragStarted();  // edits until dragEnded() are one gesture
  void dragEnded();
  void failed(const QString& message);
};

}  // namespace isolux::ui
