#include "app/jobs/load_job.h"

#include <new>
#include <utility>

#include "volume/bricks/coarse_level.h"

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

LoadJob::LoadJob(scene::Source source, bool coarser)
    : work_(
          [&] {
            auto work = std::make_shared<Work>();
            work->source = std::move(source);
            work->coarser = coarser;
            return work;
          }(),
          run) {}

LoadJob::~LoadJob() {
  work_->progress.requestStop();
}

scene::Source LoadJob::loaded() const {
  scene::Source source = work_->source;
  source.level = work_->level;
  return source;
}

void LoadJob::run(Work& work) {
  try {
    scene::Source source = work.source;
    const bool mayChoose = work.coarser && source.level == 0;
    if (mayChoose) source.level = volume::levelThatFits(source, work.progress, 0, kLevelShare);
    const auto load = [&] {
      work.level = source.level;
      work.volume = freedElsewhere(volume::loadVolume(source, work.progress));
    };
    try {
      load();
    } catch (const base::Error& error) {  // it takes more than its header said
      if (!mayChoose || source.level > 0 || error.kind() != base::ErrorKind::memory) throw;
      source.level = volume::levelThatFits(source, work.progress, 1, kLevelShare);
      if (source.level == 0) throw;
      load();
    }
  } catch (const base::Error& error) {
    work.error = error;
  } catch (const std::bad_alloc&) {
    work.error.emplace(base::ErrorKind::memory, work.source.path, "", "not enough memory");
  } catch (const std::exception& error) {
    work.error.emplace(base::ErrorKind::input, work.source.path, "", error.what());
  }
  work.finished.store(true, std::memory_order_release);
}

}  // namespace isolux::app
