#include "volume/prepared/prepared_labels.h"

#include "base/error.h"
#include "scene/choices.h"

namespace isolux::volume {

std::shared_ptr<const LabelBlocks> labelBlocksOf(const PreparedVolume& prepared, const std::string& file,
                                                 base::Progress& progress) {
  if (prepared.labels) return prepared.labels->blocks;
  const Volume& volume = prepared.volume;
  auto blocks = std::make_shared<const LabelBlocks>(volume.grid, file, progress);
  const std::size_t count = blocks->list().size();
  if (count > 2 && volume.labels == 0 && volume.kind != scene::DataKind::labels)
    base::throwInput(file, "",
                     "its " + std::to_string(count) +
                         " values do not look like labels; --set source.kind=labels takes them for labels");
  if (count == 0 || (count == 1 && blocks->list().front().label == 0))
    base::throwInput(file, "", "it has no label but 0, the background");
  return blocks;
}

}  // namespace isolux::volume
