#include "volume/prepared/label_surfaces.h"

#include <algorithm>
#include <iterator>

#include "base/error.h"
#include "scene/opacity.h"
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
    const std::vector<int> named =
        labelsNamed(surface.labels, *shown.blocks, shown.table.get(), "surfaces." + surface.id + ".labels");
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
  std::vector<Key> keys;
  try {
    keys = keysOf(resolved, shown);
  } catch (const base::Error&) {  // make() says why
    return std::nullopt;
  }
  Fields fields;
  for (const Key& key : keys) {
    std::optional<std::shared_ptr<const PreparedVolume>> field(nullptr);
    if (!key.first.empty()) field = kept_.find(key);
    if (!field) return std::nullopt;
    fields.push_back(std::move(*field));
  }
  return fields;
}

LabelSurfaces::Fields LabelSurfaces::findEach(const scene::Scene& resolved, const ShownLabels& shown) const
    try {
  const std::vector<std::vector<int>> labels = labelsOfSurfaces(resolved, shown);
  Fields fields(labels.size());
  for (std::size_t i = 0; i < labels.size(); ++i)
    fields[i] = kept_.find({labels[i], resolved.surfaces[i].smoothing.value_or(shown.mask.smoothing)})
                    .value_or(nullptr);
  return fields;
} catch (const base::Error&) {  // make() says why
  return Fields(resolved.surfaces.size());
}

LabelSurfaces::Fields LabelSurfaces::make(const scene::Scene& resolved, const ShownLabels& shown,
                                          base::Progress& progress) const {
  const std::vector<Key> keys = keysOf(resolved, shown);
  kept_.keepAtLeast(keys.size() + 1);  // and what is lit
  Fields fields;
  for (const Key& key : keys) fields.push_back(key.first.empty() ? nullptr : fieldOf(key, progress));
  return fields;
}

std::shared_ptr<const PreparedVolume> LabelSurfaces::fieldOf(const Key& key, base::Progress& progress) const {
  return kept_.get(key, [&] {
    auto labels = std::make_shared<ShownLabels>();
    labels->mask = makeMask(*blocks_, key.first, key.second, progress);
    labels->blocks = blocks_;
    labels->table = table_;
    return prepareMask(asRead_, std::move(labels), progress);
  });
}

std::shared_ptr<const PreparedVolume> LabelSurfaces::litField(const scene::Scene& resolved,
                                                              const ShownLabels& shown,
                                                              base::Progress& progress) const {
  const std::vector<std::vector<int>> own = labelsOfSurfaces(resolved, shown);
  std::vector<int> opaque, visible;
  for (std::size_t i = 0; i < own.size(); ++i) {
    const scene::Surface& surface = resolved.surfaces[i];
    if (!isVisible(surface)) continue;
    std::ranges::copy(own[i], std::back_inserter(visible));
    if (scene::isOpaque(surface)) std::ranges::copy(own[i], std::back_inserter(opaque));
  }
  std::vector<int>& lit = opaque.empty() ? visible : opaque;
  std::ranges::sort(lit);
  if (lit.empty() || lit == shown.mask.labels) return nullptr;
  return fieldOf({std::move(lit), shown.mask.smoothing}, progress);
}

LabelSurfaces::Fields labelFields(const PreparedVolume& volume, const scene::Scene& resolved,
                                  base::Progress& progress) {
  if (!volume.labelSurfaces) return {};
  return volume.labelSurfaces->make(resolved, *volume.labels, progress);
}

std::shared_ptr<const PreparedVolume> litVolume(const std::shared_ptr<const PreparedVolume>& volume,
                                                const scene::Scene& resolved, base::Progress& progress) {
  if (!volume || !volume->labelSurfaces) return volume;
  auto lit = volume->labelSurfaces->litField(resolved, *volume->labels, progress);
  return lit ? lit : volume;
}

}  // namespace isolux::volume
