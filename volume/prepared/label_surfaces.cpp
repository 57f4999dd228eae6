#include "volume/prepared/label_surfaces.h"

#include <algorithm>
#include <iterator>

#include "volume/prepared/prepared_volume.h"

namespace isolux::volume {

namespace {

std::vector<int> without(const std::vector<int>& labels, const std::vector<int>& others) {
  std::vector<int> left;
  std::ranges::set_difference(labels, others, std::back_inserter(left));
  return left;
}

bool isVisible(const scene::Surface& surface) {
  return surface.shown && surface.opacity > 0.0;
}

}  // namespace

std::vector<std::vector<int>> labelsOfSurfaces(const scene::Scene& scene, const ShownLabels& shown) {
  std::vector<std::vector<int>> own;
  std::vector<int> left = shown.mask.labels;
  for (const scene::Surface& surface : scene.surfaces) {
    std::vector<int>& labels = own.emplace_back();
    if (surface.labels.empty()) continue;
    const std::vector<int> named = labelsNamed(surface.labels, *shown.blocks, shown.table.get(),
                                               "surfaces." + surface.id + ".labels");
    std::ranges::set_intersection(named, left, std::back_inserter(labels));
    left = without(left, labels);
  }
  const auto rest = std::ranges::find_if(scene.surfaces, [](const auto& s) { return s.labels.empty(); });
  if (rest != scene.surfaces.end())
    own[static_cast<std::size_t>(rest - scene.surfaces.begin())] = std::move(left);
  return own;
}

std::vector<LabelSurfaces::Key> LabelSurfaces::keysOf(const scene::Scene& resolved,
                                                      const ShownLabels& shown) {
  const std::vector<std::vector<int>> labels = labelsOfSurfaces(resolved, shown);
  std::vector<Key> keys;
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (const scene::Surface& surface = resolved.surfaces[i]; isVisible(surface))
      keys.emplace_back(labels[i], surface.smoothing.value_or(shown.mask.smoothing));
  const Key all(shown.mask.labels, shown.mask.smoothing);
  if (keys.empty() || (keys.size() == 1 && keys.front() == all)) return {};
  return keys;
}

std::optional<LabelSurfaces::Fields> LabelSurfaces::find(const scene::Scene& resolved,
                                                         const ShownLabels& shown) const {
  Fields fields;
  for (const Key& key : keysOf(resolved, shown)) {
    std::optional<std::shared_ptr<const PreparedVolume>> field(nullptr);
    if (!key.first.empty()) field = kept_.find(key);
    if (!field) return std::nullopt;
    fields.push_back(std::move(*field));
  }
  return fields;
}

LabelSurfaces::Fields LabelSurfaces::make(const scene::Scene& resolved, const ShownLabels& shown,
                                          base::Progress& progress) const {
  const std::vector<Key> keys = keysOf(resolved, shown);
  kept_.keepAtLeast(keys.size());
  Fields fields;
  for (const Key& key : keys)
    fields.push_back(key.first.empty() ? nullptr : kept_.get(key, [&] {
      auto labels = std::make_shared<ShownLabels>();
      labels->mask = makeMask(*blocks_, key.first, key.second, progress);
      labels->blocks = blocks_;
      labels->table = table_;
      return prepareMask(asRead_, std::move(labels), progress);
    }));
  return fields;
}

LabelSurfaces::Fields labelFields(const PreparedVolume& volume, const scene::Scene& resolved,
                                  base::Progress& progress) {
  if (!volume.labelSurfaces) return {};
  return volume.labelSurfaces->make(resolved, *volume.labels, progress);
}

}  // namespace isolux::volume
