// A panel of the window, and the table of all of them: the window makes, docks and feeds them from it, and
// knows none of them by name.
//
// A panel overrides the functions for what it shows; they cost nothing where they are not overridden.
#pragma once

#include <span>

#include <QEvent>
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
  void changeEvent(QEvent* event) override {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) themeChanged();
  }

 Q_SIGNALS:
  void edited(const isolux::ui::Edit& edit);
  void dragStarted();  // edits until dragEnded() are one gesture
  void dragEnded();
  void failed(const QString& message);
};

struct PanelInfo {
  const char* name;   // in saved layouts, for showPanel() and --panel; never translated
  const char* title;  // on its tab and in the View menu
  Panel* (*make)(QWidget* parent);
  bool atFirst = true;  // shown before the user has chosen; the rest waits in the View menu
};

// From left to right; the first is in front when the window opens.
std::span<const PanelInfo> panels();

}  // namespace isolux::ui
