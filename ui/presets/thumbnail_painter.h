// Draws small pictures of scenes, one after the other, with a renderer of its own and only while nothing else
// is drawn: what was begun is dropped as soon as the window's own picture is to be drawn.
//
// Each place keeps the last few pictures that were drawn for it, with their scenes.
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include <QImage>
#include <QObject>
#include <QSize>
#include <QTimer>

#include "app/tasks/picture_thread.h"
#include "ui/document/document.h"

namespace isolux::ui {

class ThumbnailPainter : public QObject {
  Q_OBJECT
 public:
  explicit ThumbnailPainter(QObject* parent = nullptr);
  void setVolume(const VolumePointer& volume);
  // What is wanted from now on, by place; resolved. None: nothing is drawn there. Pixels of the screen.
  void want(std::vector<std::optional<scene::Scene>> scenes, QSize pixels);
  // While the window draws, or is being used, nothing is drawn here.
  void setBusy(bool busy);

  // Of the scene that is wanted there; null: not drawn yet.
  const QImage* picture(std::size_t place) const;
  bool complete() const;                     // every picture that is wanted is there
  int drawnCount() const { return drawn_; }  // pictures

 Q_SIGNALS:
  void drawn(int place);

 private:
  struct Kept {
    scene::Scene scene;
    QImage image;
  };
  struct Place {
    std::optional<scene::Scene> wanted;
    std::deque<Kept> kept;  // newest first
    bool failed = false;    // the wanted one
  };
  void next();
  void take();
  void put(std::size_t place, const app::DrawnPicture& picture);
  void drop();
  bool isThere(const Place& place) const;

  VolumePointer volume_;
  std::vector<Place> places_;
  QSize pixels_;
  std::unique_ptr<app::PictureThread> thread_;  // made for the first picture
  std::optional<std::size_t> drawing_;
  bool busy_ = true;
  int drawn_ = 0;
  QTimer restTimer_;
};

}  // namespace isolux::ui
