// Level 0 of a volume of which the window holds a coarser level: a finished picture of the level is followed
// by one of the file's own voxels, drawn from the file by a thread that gives way, and shown in its place.
// An index is made in the background where there is none. Nothing of it runs for a volume that is in memory.
//
// Data: the finished picture of the level, from MainWindow. Owner: the volume in its file
// (app::wholeFileTask) is kept as long as its source is the document's; an app::PictureThread keeps the
// renderer. Flow: show() -> open, index -> draw -> painted(); a picture that changes drops what is being
// drawn, but not the opening.
#pragma once

#include <memory>
#include <optional>

#include <QImage>
#include <QObject>

#include "app/tasks/picture_thread.h"
#include "app/tasks/whole_file_task.h"
#include "render/still_picture.h"
#include "ui/document/background_task.h"
#include "ui/document/document.h"

namespace isolux::ui {

class FullResolutionView : public QObject {
  Q_OBJECT
 public:
  struct Shown {
    scene::Scene scene, resolved;  // as the user gave it, and of the level's picture
    QImage picture;                // of the level
    double pixelRatio = 1.0;

    bool operator==(const Shown& other) const { return picture.cacheKey() == other.picture.cacheKey(); }
  };
  explicit FullResolutionView(QObject* parent = nullptr);
  void setHostSettings(const scene::HostSettings& host) { host_ = host; }
  // Whose level the document shows; none: no level. What is known of another source is let go.
  void setSource(const std::optional<scene::Source>& source);
  // The finished picture of a level on show; none: there is none now.
  void show(const std::optional<Shown>& shown);
  void setWanted(bool wanted);  // by the user; kept in the user's settings
  bool wanted() const { return wanted_; }

  bool shows() const { return !image_.isNull(); }  // the picture on screen is that of level 0
  const QImage& image() const { return image_; }   // null: it is not
  bool working() const { return opening_ || drawing_; }
  QString text() const { return text_; }        // "making the index: 34 %"; empty: nothing to say
  QString meaning() const { return meaning_; }  // a sentence more: why not, or what of it is missing

  // What shows() shows, of another size, with a dialog where it takes long. Throws base::Error.
  render::StillPicture picture(const render::FrameRequest& request, bool transparent, QWidget* window,
                               const QString& what);

 Q_SIGNALS:
  void changed();                                       // what is said
  void opened();                                        // the volume has an index now
  void painted(const QImage& image, const QImage& of);  // null: the level's picture it is

 private:
  void open();
  void draw();
  void sayOpening();
  void takeVolume(app::WholeFileTask& task);
  void takeStill();
  void takePicture(const render::StillPicture& picture);
  void stopDrawing();
  void say(const QString& text, const QString& meaning);
  app::PictureOrder order(const render::FrameRequest& request) const;

  scene::HostSettings host_;
  std::optional<scene::Source> source_;
  std::optional<Shown> shown_;
  bool wanted_ = true;
  BackgroundTask<app::WholeFile> opening_;
  VolumePointer whole_;               // of source_
  scene::HostSettings wholeMachine_;  // what draws it
  std::optional<QString> refused_;    // why source_ cannot be opened
  std::unique_ptr<app::PictureThread> thread_;
  std::shared_ptr<app::PictureThread::Still> drawing_;
  QImage image_;
  QString text_, meaning_;
};

}  // namespace isolux::ui
