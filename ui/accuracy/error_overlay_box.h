// "Show errors in the picture": which error of the picture on screen is laid over it, as colours and hatching
// (app/accuracy/error_overlay.h), painted on a background thread as soon as the picture's errors are known.
#pragma once

#include <memory>
#include <optional>

#include <QImage>
#include <QWidget>

#include "app/accuracy/error_overlay.h"
#include "ui/document/background_task.h"

class QComboBox;
class QLabel;

namespace isolux::ui {

class ErrorOverlayBox : public QWidget {
  Q_OBJECT
 public:
  // A picture on screen, finished, and what is known of it.
  struct Shown {
    QImage picture;                                    // null: there is none, or its errors are not known
    std::shared_ptr<const app::PictureErrors> errors;  // null: they are not known
    double shortestEdgeMm = 1.0;
    scene::LegendCorner corner = scene::LegendCorner::automatic;
    std::optional<render::Tile> legend;  // of the picture
    std::optional<app::Limit> limit;     // what exceeds it is hatched
  };

  explicit ErrorOverlayBox(QWidget* parent = nullptr);

  void setShown(const Shown& shown);
  bool wanted() const { return chosen().has_value(); }  // something is to be laid over
  void choose(std::optional<app::ErrorImage> error);
  QString note() const;  // why nothing is
  bool working() const { return bool(task_); }

 Q_SIGNALS:
  void wantedChanged();
  // A picture with its errors; null: the picture as it is.
  void painted(const QImage& image, const QImage& of, const std::optional<isolux::render::Tile>& legend);

 private:
  std::optional<app::ErrorImage> chosen() const;
  void paint();
  void take(const QImage& image, const std::optional<render::Tile>& legend = {});

  Shown shown_;
  BackgroundTask<app::MarkedPicture> task_;
  bool isPainted_ = false;  // something is laid over the picture now
  QComboBox* errors_;
  QLabel* note_;
};

}  // namespace isolux::ui
