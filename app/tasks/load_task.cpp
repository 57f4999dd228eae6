#include "app/tasks/load_task.h"

#include <string>
#include <utility>

#include "volume/large/coarse_level.h"
#include "volume/read/step_files.h"

namespace isolux::app {

namespace {

constexpr double kLevelShare = 0.75;  // beside a level the window draws level 0 from the file

// The same volume, freed on another thread: giving gigabytes back to the system takes a second.
std::shared_ptr<const volume::PreparedVolume> freedElsewhere(
    std::shared_ptr<const volume::PreparedVolume> volume) {
  const volume::PreparedVolume* const same = volume.get();
  return {same, [kept = std::move(volume)](const volume::PreparedVolume*) mutable {
            base::destroyInBackground(std::move(kept));
          }};
}

LoadedVolume load(scene::Source source, LoadInstead instead, base::Progress& progress) {
  const bool choosesLevel = instead.coarser && source.level == 0;
  const scene::Source step = volume::sourceOfStep(source, static_cast<int>(source.timeStep));
  const volume::VolumeFile file = volume::openSource(step, progress);
  if (choosesLevel) source.level = volume::levelThatFits(file, 0, kLevelShare);
  for (;;) {
    try {
      return {source, freedElsewhere(volume::loadVolume(source, file, progress))};
    } catch (const base::Error& error) {
      if (error.kind() == base::ErrorKind::memory && choosesLevel) {  // it takes more than its header said
        const int level = volume::levelThatFits(file, source.level + 1, kLevelShare);
        if (level <= source.level) throw;
        source.level = level;
      } else if (error.kind() == base::ErrorKind::input && instead.aroundDamage && !source.aroundDamage &&
                 file.parts) {
        source.aroundDamage = true;
      } else {
        throw;
      }
    }
  }
}

// Whether the source asks for other labels of a volume that is there.
bool differsInLabels(scene::Source source, const std::optional<LoadedVolume>& shown) {
  if (!shown || !shown->volume || !shown->volume->labels || source.labels == scene::kLabelsAsValues)
    return false;
  source.labels = shown->source.labels;
  source.smoothing = shown->source.smoothing;
  return source == shown->source;
}

}  // namespace

std::unique_ptr<LoadTask> loadTask(scene::Source asked, LoadInstead instead,
                                   std::optional<LoadedVolume> shown) {
  const std::string file = asked.path;
  const auto work = [source = std::move(asked), instead, shown = std::move(shown)](base::Progress& progress) {
    if (differsInLabels(source, shown))
      return LoadedVolume{source, freedElsewhere(volume::showOtherLabels(*shown->volume, source, progress))};
    return load(source, instead, progress);
  };
  return LoadTask::start({file, "load the volume"}, work);
}

}  // namespace isolux::app
