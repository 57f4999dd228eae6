// Makes the mask fields of the surfaces of a scene that show labels of their own (scene::Surface::labels):
// one for each, since surfaces behind one another need all their sides.
//
// Where one surface shows all labels, it is that of PreparedVolume itself. All members may be called from any
// thread; nobody waits for another's work.
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "base/progress.h"
#include "base/recent.h"
#include "scene/scene.h"
#include "volume/labels/shown_labels.h"
#include "volume/volume.h"

namespace isolux::volume {

struct PreparedVolume;

// Returns for each surface of the scene which of the shown labels are its own, ascending: those that it names
// and none before it; the first surface that names none has all that no surface names, switched off or not.
// Throws Error{usage} with the setting's path.
std::vector<std::vector<int>> labelsOfSurfaces(const scene::Scene& scene, const ShownLabels& shown);

class LabelSurfaces {
 public:
  // `asRead`: with the labels as its values, those of `blocks`.
  LabelSurfaces(Volume asRead, std::shared_ptr<const LabelBlocks> blocks,
                std::shared_ptr<const LabelTable> table)
      : asRead_(std::move(asRead)), blocks_(std::move(blocks)), table_(std::move(table)) {}

  // The field of each of scene::visibleSurfaces(), null if none of its labels is shown; its PreparedVolume
  // holds what a frame needs, and no facts. Empty if one surface shows all that `shown` does.
  using Fields = std::vector<std::shared_ptr<const PreparedVolume>>;
  // nullopt: not made yet, or make() would throw.
  std::optional<Fields> find(const scene::Scene& resolved, const ShownLabels& shown) const;
  // Returns the field of each surface, shown or not: null if it is not made, or there is none.
  Fields findEach(const scene::Scene& resolved, const ShownLabels& shown) const;
  // Throws Error: usage, interrupted, memory.
  Fields make(const scene::Scene& resolved, const ShownLabels& shown, base::Progress& progress) const;

  // The field of all labels of opaque surfaces, or of visible ones if none is opaque: light is traced past
  // the rest. Null: those that `shown` shows. Throws as make().
  std::shared_ptr<const PreparedVolume> litField(const scene::Scene& resolved, const ShownLabels& shown,
                                                 base::Progress& progress) const;

 private:
  using Key = std::pair<std::vector<int>, double>;  // labels, smoothing
  // Returns those of scene::visibleSurfaces(); empty as Fields.
  static std::vector<Key> keysOf(const scene::Scene& resolved, const ShownLabels& shown);
  std::shared_ptr<const PreparedVolume> fieldOf(const Key& key, base::Progress& progress) const;

  Volume asRead_;
  std::shared_ptr<const LabelBlocks> blocks_;
  std::shared_ptr<const LabelTable> table_;
  mutable base::Recent<Key, std::shared_ptr<const PreparedVolume>> kept_;
};

// Returns LabelSurfaces::make() of a volume; empty if it shows no labels.
LabelSurfaces::Fields labelFields(const PreparedVolume& volume, const scene::Scene& resolved,
                                  base::Progress& progress);

// Returns the volume that light is baked in: LabelSurfaces::litField(), or the volume itself.
std::shared_ptr<const PreparedVolume> litVolume(const std::shared_ptr<const PreparedVolume>& volume,
                                                const scene::Scene& resolved, base::Progress& progress);

}  // namespace isolux::volume
