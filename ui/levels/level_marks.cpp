#include "ui/levels/level_marks.h"

#include <QSettings>

#include "ui/document/picture_pixels.h"
#include "ui/language/number_text.h"

namespace isolux::ui {

namespace {

constexpr int marksPollMilliseconds = 30;
constexpr const char* marksKey = "markOverview";

}  // namespace

LevelMarks::LevelMarks(QObject* parent)
    : QObject(parent), marks_(QSettings().value(marksKey, true).toBool()) {
  pollTimer_.setInterval(marksPollMilliseconds);
  connect(&pollTimer_, &QTimer::timeout, this, &LevelMarks::poll);
}

void LevelMarks::show(const std::optional<Shown>& shown) {
  const bool same = shown.has_value() == shown_.has_value() &&
                    (!shown || (shown->volume == shown_->volume &&
                                shown->picture.cacheKey() == shown_->picture.cacheKey()));
  if (same) return;
  pollTimer_.stop();
  job_.reset();
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
  app::StructureJob::Subject subject;
  subject.volume = shown_->volume;
  subject.scene = shown_->resolved;
  subject.picture = [picture = shown_->picture] { return colorImageOf(picture); };
  subject.taken = shown_->legend;
  subject.known = known_;
  job_ = std::make_unique<app::StructureJob>(std::move(subject));
  pollTimer_.start();
}

void LevelMarks::lookAgain() {
  if (shown_ && !job_ && !known_.whole) look();
}

void LevelMarks::poll() {
  if (!job_) return pollTimer_.stop();
  if (!job_->finished()) return;
  pollTimer_.stop();
  const std::unique_ptr<app::StructureJob> job = std::move(job_);
  if (job->error()) return say({}, QString::fromStdString(job->error()->what()));
  known_ = job->known();
  tell(job->structure());
  if (!job->structure() || job->structure()->share() == 0.0) return;
  marked_ = imageOf(job->marked());
  legend_ = job->legend();
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
