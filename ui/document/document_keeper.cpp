#include "ui/document/document_keeper.h"

#include <utility>

#include "ui/document/document.h"

namespace isolux::ui {

namespace {
constexpr int gatherMilliseconds = 300;
constexpr int minuteMilliseconds = 60'000;
}  // namespace

DocumentKeeper::DocumentKeeper(Document* document, const std::filesystem::path& folder, QObject* parent)
    : QObject(parent), document_(document), file_(folder), lost_(app::takeLostAutosaves(folder)) {
  callOnce(soon_, gatherMilliseconds, this, &DocumentKeeper::save);

  minute_.setInterval(minuteMilliseconds);
  connect(&minute_, &QTimer::timeout, this, [this] {
    tellProblem();
    if (told_) save();
  });
  minute_.start();
  // Not started anew by each change: during a long drag something is kept, too.
  connect(document_, &Document::stateChanged, this, [this] {
    if (!soon_.isActive()) soon_.start();
  });
  connect(document_, &Document::restored, this, &DocumentKeeper::finishRestoring);
}

void DocumentKeeper::save() {
  soon_.stop();
  tellProblem();
  if (!document_->volume()) return;
  app::OpenDocument kept = document_->kept();
  if (app::worthKeeping(kept)) {
    file_.write(std::move(kept));
  } else {
    file_.remove();
  }
}

void DocumentKeeper::forget() {
  soon_.stop();
  file_.remove();
}

void DocumentKeeper::tellProblem() {
  const auto problem = file_.problem();
  if (problem && !told_)
    Q_EMIT failed(
        tr("Autosave failed: %1. Save the session; Isolux tries again every minute.").arg(problem->what()));
  told_ = problem.has_value();
}

const app::Autosave* DocumentKeeper::lost() const {
  return lost_.found.empty() ? nullptr : &lost_.found.front().content;
}

void DocumentKeeper::restoreLost() {
  if (!lost()) return;
  restoring_ = true;
  document_->restore(lost()->document);
}

// It is ours now. The old file goes when the new one is there, so that at no moment there is none.
void DocumentKeeper::finishRestoring() {
  if (!std::exchange(restoring_, false) || !lost()) return;
  const std::string recording = lost()->document.recordingFile;
  if (!recording.empty())
    Q_EMIT noted(
        tr("Recording %1 was interrupted and is not continued").arg(QString::fromStdString(recording)));
  save();
  finish();
  if (!file_.problem()) lost_.found.front().discard();
  lost_.found.clear();  // further ones are offered at the next start
}

void DocumentKeeper::discardLost() {
  if (!lost()) return;
  lost_.found.front().discard();
  lost_.found.erase(lost_.found.begin());
}

}  // namespace isolux::ui
