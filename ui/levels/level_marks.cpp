#include "ui/levels/level_marks.h"

#include <QSettings>

#include "ui/document/picture_pixels.h"
#include "ui/language/number_text.h"

namespace isolux::ui {

namespace {

constexpr const char* marksKey = "markOverview";

}  // namespace

LevelMarks::LevelMarks(QObject* parent)
    : QObject(parent), marks_(QSettings().value(marksKey, true).toBool()) {}

void LevelMarks::show(const std::optional<Shown>& shown) {
  if (shown == shown_) return;
  task_.reset();
  marked_ = {};
  shown_ = shown;
  if (!shown_) return;  // what was said holds until another picture says something else
  if (shown_->volume != knownOf_) {
    known_ = {};
    knownOf_ = shown_->volume;
    say({}, {});
  }
  look();
}

void LevelMarks::forget() {
  show(std::nullopt);
  known_ = {};
  knownOf_.reset();
  say({}, {});
}

void LevelMarks::look() {
  app::StructureSubject subject;
  subject.volume = shown_->volume;
  subject.scene = shown_->resolved;
  subject.picture = [picture = shown_->picture] { return colorImageOf(picture); };
  subject.taken = shown_->legend;
  subject.known = known_;
  task_.watch(app::structureTask(std::move(subject)), [this](auto& task) { take(task); });
}

void LevelMarks::lookAgain() {
  if (shown_ && !task_ && !known_.whole) look();
}

void LevelMarks::take(app::StructureTask& task) {
  if (task.error()) return say({}, QString::fromStdString(task.error()->what()));
  const app::FoundStructure& found = task.value();
  known_ = found.known;
  tell(found.structure);
  if (!found.structure || found.structure->share() == 0.0) return;
  marked_ = imageOf(found.marked.image);
  legend_ = found.marked.legend;
  if (marks_) Q_EMIT painted(marked_, shown_->picture, legend_);
}

void LevelMarks::setMarking(bool marks) {
  marks_ = marks;
  QSettings().setValue(marksKey, marks);
  if (shown_) Q_EMIT painted(marks ? marked_ : QImage(), shown_->picture, legend_);
}

void LevelMarks::tell(const std::optional<app::HiddenStructure>& structure) {
  if (!structure)
    return say(
        {}, tr("Marking lost structure requires the volume’s index; the command “isolux index” creates it."));
  const QString thin = numberText(structure->thinnestMm, 3) + " mm";
  if (structure->share() == 0.0)
    return say(tr("hides nothing in this view"),
               tr("Wherever the isosurface crosses the volume, the overview shows a surface at most one of "
                  "its voxels away."));
  const QString share = numberText(100.0 * structure->share(), 2);
  say(tr("may hide structure in %1 % of the image").arg(share),
      tr("Hatched: the isosurface crosses the volume here, but the overview does not show it. Structures "
         "thinner than %1 may be missing.")
          .arg(thin));
}

void LevelMarks::say(const QString& text, const QString& meaning) {
  if (text == text_ && meaning == meaning_) return;
  text_ = text;
  meaning_ = meaning;
  Q_EMIT changed();
}

}  // namespace isolux::ui
