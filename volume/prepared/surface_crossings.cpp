#include "volume/prepared/surface_crossings.h"

#include "scene/shown_surfaces.h"

namespace isolux::volume {

std::vector<ShownSurface> shownSurfaces(const PreparedVolume& volume, const scene::Scene& resolved,
                                        base::Progress& progress) {
  std::vector<ShownSurface> surfaces;
  for (const scene::ShownSurface& surface : scene::visibleSurfaces(resolved))
    surfaces.push_back({*surface.value, volume.pieces->hidden(resolved.pieces, *surface.value,
                                                              resolved.isosurface.inside, progress)});
  return surfaces;
}

}  // namespace isolux::volume
