#include "render/passes/processor.h"

#include <algorithm>

#include "render/passes/frame_state.h"
#include "scene/rules/needs.h"
#include "volume/cast/surface_caster.h"
#include "volume/cast/surface_derivatives.h"

namespace isolux::render {

namespace {

// What is in `area`, and in the area that the texture shows yet, of an image of `channels` floats as large.
void upload(const Texture& texture, const volume::PictureArea& changed, const float* values, int channels) {
  const Gl& gl = texture.gl();
  const int width = texture.size().x;
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  gl.PixelStorei(GL_UNPACK_ROW_LENGTH, width);
  for (const volume::Rectangle& part : changed.rectangles()) {
    const std::ptrdiff_t first = static_cast<std::ptrdiff_t>(part.low.y) * width + part.low.x;
    gl.TextureSubImage2D(texture.id(), 0, part.low.x, part.low.y, part.size.x, part.size.y,
                         channels == 4 ? GL_RGBA : GL_RG, GL_FLOAT, values + channels * first);
  }
  gl.PixelStorei(GL_UNPACK_ROW_LENGTH, 0);
}

HostImages& hostImages(FrameState& frame) {
  const auto found = frame.host.find(frame.layer);
  if (found != frame.host.end()) {
    if (found->second.crossings.area.size() == frame.raySize()) return found->second;
    frame.host.erase(found);  // before its successor is made: both need not fit
  }
  return frame.host.emplace(frame.layer, HostImages(frame.raySize())).first->second;
}

// How much of each pixel is covered already, of those of the crossing before.
std::vector<float> alphaOf(const Texture& color, const volume::PictureArea& before) {
  const int width = color.size().x;
  std::vector<float> alpha(static_cast<std::size_t>(width) * static_cast<std::size_t>(color.size().y));
  for (const volume::Rectangle& part : before.rectangles()) {
    const std::vector<float> rgba = color.readFloats(4, part);
    const auto columns = static_cast<std::size_t>(part.size.x);
    for (std::size_t i = 0; i < rgba.size() / 4; ++i)
      alpha[(static_cast<std::size_t>(part.low.y) + i / columns) * static_cast<std::size_t>(width) +
            static_cast<std::size_t>(part.low.x) + i % columns] = rgba[4 * i + 3];
  }
  return alpha;
}

void cast(FrameState& frame, volume::Crossings& out) {
  const volume::PictureRays rays = frame.view->rays(frame.request.size * frame.request.supersampling,
                                                    frame.tileOrigin() * frame.request.supersampling);
  std::vector<double> isovalues;
  for (const Surface& surface : frame.surfaces)
    isovalues.push_back(frame.volume->grid().storedOfValue(surface.value));
  const volume::SurfaceCaster caster(frame.volume->grid(), isovalues, frame.volume->blocks().dims(),
                                     frame.volume->masks());
  if (frame.layer.empty()) {
    caster.castAll(rays, out, frame.request.stop);
    return;
  }
  const volume::Crossings& before = frame.host.at(frame.layerBefore).crossings;
  const std::vector<float> covered = alphaOf(frame.images.at(image::color).images[0], before.area);
  caster.castBehind(rays, {before, covered}, out, frame.request.stop);
}

}  // namespace

HostImages::HostImages(glm::ivec2 size)
    : held(base::machineMemory().reserve(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) *
                                             (sizeof(glm::vec2) + 4 * sizeof(glm::vec4)),
                                         "hits of the picture",
                                         "a smaller picture or --executor gpu needs less")),
      crossings(size) {}

OnProcessor onProcessor(bool taken, const scene::Scene& scene) {
  OnProcessor on;
  if (!taken) return on;
  on.casts = scene.hit.method == scene::HitMethod::exact && scene.hit.field == scene::Field::trilinear;
  // The fast scheme is one of filtered fetches: it is what it is on a graphics card only.
  on.derives = on.casts && (scene.derivatives.field == scene::Field::trilinear ||
                            scene.derivatives.fetch != scene::Fetch::fast);
  on.all = on.derives && !scene::showsShadow(scene);
  return on;
}

bool takesProcessor(scene::Executor executor, const Gl& gl) {
  if (!volume::SurfaceCaster::available()) return false;
  return executor == scene::Executor::cpu || (executor == scene::Executor::automatic && gl.software);
}

void castOnProcessor(FrameState& frame) {
  volume::Crossings& crossings = hostImages(frame).crossings;
  if (!frame.empty())
    cast(frame, crossings);
  else if (!crossings.area.empty())
    crossings = volume::Crossings(frame.raySize());
  Target& target = frame.target(image::surface, {GL_RGBA32F, GL_RG32F});
  target.drawn.add(crossings.area);
  upload(target.images[0], target.drawn, &crossings.points.data()->x, 4);
  upload(target.images[1], target.drawn, &crossings.infos.data()->x, 2);
  target.drawn = crossings.area;
}

void deriveOnProcessor(FrameState& frame, Target& target) {
  HostImages& images = frame.host.at(frame.layer);
  const volume::PictureArea& area = images.crossings.area;
  const std::size_t count = target.images.size();
  volume::PictureArea changed = area;
  for (std::size_t i = 0; i < count; ++i) {
    HostImages::Derivatives& own = images.derivatives[i];
    own.texels.resize(images.crossings.points.size());
    if (own.area.size() == area.size()) changed.add(own.area);
  }
  auto& [gradient, diagonal, mixed] = images.derivatives;
  volume::DerivativeImages out{gradient.texels, {}, {}};
  if (count == 3) out = {gradient.texels, diagonal.texels, mixed.texels};
  const scene::Field field = frame.scene->derivatives.field;
  const volume::DerivedField derived =
      field == scene::Field::trilinear ? volume::DerivedField::trilinear : volume::DerivedField::spline;
  if (!changed.empty())
    volume::surfaceDerivatives(frame.volume->grid(), derived, frame.volume->coefficients(field),
                               images.crossings.points, changed, out, volume::TracerTarget::automatic,
                               frame.request.stop);
  const bool stopped = frame.request.stop.stop_requested();  // some of what was there may be left
  target.drawn.add(area);
  for (std::size_t i = 0; i < count; ++i) {
    upload(target.images[i], target.drawn, &images.derivatives[i].texels.data()->x, 4);
    images.derivatives[i].area = stopped ? changed : area;
  }
  if (!stopped) target.drawn = area;
}

}  // namespace isolux::render
