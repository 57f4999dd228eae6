#include "app/jobs/overlay_job.h"

#include <utility>

#include "app/jobs/give_way.h"

namespace isolux::app {

std::unique_ptr<OverlayTask> overlayTask(OverlaySubject asked) {
  const auto work = [subject = std::move(asked)](base::Progress&) {
    giveWay();
    MarkedPicture marked{subject.picture(), {}};
    marked.legend = paintErrors(*subject.errors, subject.wish, subject.shortestEdgeMm, subject.corner,
                                subject.taken, marked.image);
    return marked;
  };
  return OverlayTask::start({"", "show errors on the image"}, work);
}

}  // namespace isolux::app
