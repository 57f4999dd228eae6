// How large the piece is that is pointed at: known at once where its isosurface's pieces are, else found on a
// background thread after the pointer has rested.
#pragma once

#include <optional>

#include <QObject>
#include <QString>
#include <QTimer>

#include "app/tasks/piece_task.h"
#include "app/view_math/surface_pick.h"
#include "ui/document/background_task.h"
#include "ui/document/document.h"

namespace isolux::ui {

// Cubic millimetres as people read them: "1 234 567 mm³", "0.12 mm³".
QString volumeText(double mm3);

class PointedPiece : public QObject {
  Q_OBJECT
 public:
  explicit PointedPiece(QObject* parent);

  // Nothing: no surface is pointed at.
  void point(const VolumePointer& volume, const scene::Scene& resolved, const std::optional<app::Pick>& pick);
  // "piece 2 (of 14): 1 234 mm³", by its id: 0 is the largest. Empty while it is not known.
  QString text() const;

 Q_SIGNALS:
  void changed();  // text() says more than it did

 private:
  void find();

  VolumePointer volume_;
  scene::Scene scene_;
  std::optional<app::Pick> pick_;
  BackgroundTask<app::FoundPieces> task_;
  std::optional<app::PieceSubject> asked_;  // of the task, or of one that failed
  QTimer restTimer_;
};

}  // namespace isolux::ui
