#include "app/jobs/load_job.h"

#include <utility>

#include "app/process/caught_error.h"
#include "volume/large/coarse_level.h"
#include "volume/read/open_chunked.h"

namespace isolux::app {

namespace {

constexpr double kLevelShare = 0.75;  // beside a level the window draws level 0 from the file

// The same volume, freed on another thread: giving gigabytes back to the system takes a second.
std::shared_ptr<const volume::PreparedVolume> freedElsewhere(
    std::shared_ptr<const volume::PreparedVolume> volume) {
  const volume::PreparedVolume* const same = volume.get();
  return {same, [kept = std::move(volume)](const volume::PreparedVolume*) mutable {
            base::retire(std::move(kept));
          }};
}

}  // namespace

LoadJob::LoadJob(scene::Source source, Instead instead)
    : work_(
          [&] {
            auto work = std::make_shared<Work>();
            work->source = work->loaded = std::move(source);
            work->instead = instead;
            return work;
          }(),
          run) {}

LoadJob::~LoadJob() {
  work_->progress.requestStop();
}

void LoadJob::load(Work& work) {
  scene::Source& source = work.loaded;
  const bool choosesLevel = work.instead.coarser && source.level == 0;
  if (choosesLevel) source.level = volume::levelThatFits(source, work.progress, 0, kLevelShare);
  while (!work.volume) {
    try {
      work.volume = freedElsewhere(volume::loadVolume(source, work.progress));
    } catch (const base::Error& error) {
      if (error.kind() == base::ErrorKind::memory && choosesLevel) {  // it takes more than its header said
        const int level = volume::levelThatFits(source, work.progress, source.level + 1, kLevelShare);
        if (level <= source.level) throw;
        source.level = level;
      } else if (error.kind() == base::ErrorKind::input && work.instead.aroundDamage &&
                 !source.aroundDamage && volume::isReadInParts(source, work.progress)) {
        source.aroundDamage = true;
      } else {
        throw;
      }
    }
  }
}

void LoadJob::run(Work& work) {
  work.error = caughtError(work.source.path, "load the volume", [&] { load(work); });
  work.finished.store(true, std::memory_order_release);
}

}  // namespace isolux::app
