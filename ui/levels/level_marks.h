// What a coarser level hides of the picture on screen: found on a background thread
// (app/accuracy/hidden_structure.h) as soon as the picture is finished, hatched in it, and said in words.
// Nothing of it runs for a volume's own voxels.
#pragma once

#include <optional>

#include <QImage>
#include <QObject>

#include "app/accuracy/hidden_structure.h"
#include "ui/document/background_task.h"
#include "ui/document/document.h"

namespace isolux::ui {

class LevelMarks : public QObject {
  Q_OBJECT
 public:
  struct Shown {
    VolumePointer volume;  // a level
    scene::Scene resolved;
    QImage picture;
    std::optional<render::Tile> legend;  // of the picture

    bool operator==(const Shown& other) const {
      return volume == other.volume && picture.cacheKey() == other.picture.cacheKey();
    }
  };
  explicit LevelMarks(QObject* parent = nullptr);

  // The finished picture of a level on show; none: there is none.
  void show(const std::optional<Shown>& shown);
  void forget();                // all of the volume that is no more
  void setMarking(bool marks);  // the user wants hatching; kept in the user's settings
  void lookAgain();             // the volume may have an index now
  bool marking() const { return marks_; }
  bool working() const { return bool(task_); }
  QString text() const { return text_; }  // "may hide structure in 3 % of the picture"; empty: not known
  QString meaning() const { return meaning_; }  // a sentence, or how it would become known

 Q_SIGNALS:
  void changed();  // what is said
  // The marked picture, and where its legend stands; null: it has no marks.
  void painted(const QImage& image, const QImage& of, const std::optional<isolux::render::Tile>& legend);

 private:
  void look();
  void take(app::StructureTask& task);
  void say(const QString& text, const QString& meaning);
  void tell(const std::optional<app::HiddenStructure>& structure);

  std::optional<Shown> shown_;
  app::KnownStructure known_;  // of knownOf_
  VolumePointer knownOf_;
  QImage marked_;
  std::optional<render::Tile> legend_;  // in it
  QString text_, meaning_;
  bool marks_ = true;
  BackgroundTask<app::FoundStructure> task_;
};

}  // namespace isolux::ui
