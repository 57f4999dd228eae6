#include "render/graph/empty_picture.h"

#include <algorithm>
#include <array>
#include <vector>

#include <glm/geometric.hpp>

#include "base/number_text.h"
#include "base/words.h"
#include "scene/camera.h"
#include "scene/rules/needs.h"
#include "scene/shown_surfaces.h"

namespace isolux::render {

namespace {

using Remedy = EmptyPicture::Remedy;

constexpr double kInvisible = 0.5 / 255.0;  // an opacity that changes no pixel

struct Shown {
  std::vector<double> values;
  bool visible = false;  // one of them at least
};

Shown shownOf(const scene::Scene& scene) {
  Shown shown;
  for (const auto& surface : scene::shownSurfaces(scene)) {
    shown.values.push_back(surface.value.value_or(0.0));
    shown.visible = shown.visible || surface.opacity >= kInvisible;
  }
  return shown;
}

EmptyPicture noSurface(const std::vector<double>& values, const volume::Grid& grid) {
  const glm::ivec3 dims = grid.dims();
  if (std::min({dims.x, dims.y, dims.z}) < 2)
    return {"No surface: the volume has only one voxel along an axis", Remedy::none};
  if (!(grid.minimum() <= grid.maximum())) return {"No surface: all voxels are missing", Remedy::none};
  const std::string list = base::joined(values, ", ", [](double value) { return base::shortText(value); });
  return {"No surface at " + list + ": the data range is " + base::shortText(grid.minimum()) + " to " +
              base::shortText(grid.maximum()),
          Remedy::isovalue};
}

// Of a volume that is in view.
std::optional<EmptyPicture> whatHides(const scene::Scene& scene) {
  if (!(scene.pieces == scene::Pieces{}))
    return EmptyPicture{"All connected components that would be visible here are hidden", Remedy::pieces};
  if (scene::cutsSurfaces(scene)) return EmptyPicture{"The cuts remove all of the surface", Remedy::cuts};
  return std::nullopt;
}

// All of the volume on the wrong side of one edge of the picture, or behind the eye.
EmptyPicture notInView(const scene::Scene& scene, const volume::GridGeometry& geometry, double aspect) {
  const scene::CameraFrame frame = scene::frameOf(scene.camera);
  const bool perspective = frame.projection == scene::Projection::perspective;
  int behind = 0;
  std::array<int, 4> beyond{};
  for (const glm::dvec3& corner : geometry.corners()) {
    const glm::dvec3 v = corner - frame.eye;
    const double depth = -glm::dot(v, frame.back), reach = frame.halfHeight * (perspective ? depth : 1.0);
    const double x = glm::dot(v, frame.right), y = glm::dot(v, frame.up);
    behind += perspective && depth <= 0.0;
    beyond[0] += x < -aspect * reach;
    beyond[1] += x > aspect * reach;
    beyond[2] += y < -reach;
    beyond[3] += y > reach;
  }
  if (behind == 8) return {"The camera looks away from the volume", Remedy::view};
  if (behind == 0 && *std::max_element(beyond.begin(), beyond.end()) == 8)
    return {"The volume is outside the image", Remedy::view};
  return whatHides(scene).value_or(EmptyPicture{"No surface is visible from here", Remedy::view});
}

}  // namespace

std::optional<EmptyPicture> whyEmpty(const scene::Scene& scene, const volume::PreparedVolume& volume,
                                     double aspect, bool crossed, bool seen) {
  const Shown shown = shownOf(scene);
  if (!shown.visible)
    return EmptyPicture{shown.values.size() > 1 ? "Every isosurface is fully transparent"
                                                : "The isosurface is fully transparent",
                        Remedy::opacity};
  if (!crossed) return noSurface(shown.values, volume.grid());
  if (!seen) return notInView(scene, volume.grid().geometry(), aspect);
  return std::nullopt;
}

}  // namespace isolux::render
