#include "render/passes/processor.h"

#include <algorithm>

#include "render/passes/frame_state.h"
#include "scene/rules/needs.h"
#include "volume/cast/surface_caster.h"
#include "volume/cast/surface_derivatives.h"

namespace isolux::render {

namespace {

void upload(const Texture& texture, GLenum format, const void* texels) {
  const glm::ivec3 size = texture.size();
  texture.gl().TextureSubImage2D(texture.id(), 0, 0, 0, size.x, size.y, format, GL_FLOAT, texels);
}

// For points and infos; derivatives are made when they are asked for.
void makeRoom(HostImages& images, std::size_t count) {
  images = {};
  images.held =
      base::machineMemory().reserve(count * (sizeof(glm::vec2) + 4 * sizeof(glm::vec4)),
                                    "hits of the picture", "a smaller picture or --executor gpu needs less");
  images.points.resize(count);
  images.infos.resize(count);
}

// How much of each pixel is covered already.
std::vector<float> alphaOf(const Texture& color) {
  const std::vector<float> rgba = color.readFloats(4);
  std::vector<float> alpha(rgba.size() / 4);
  for (std::size_t i = 0; i < alpha.size(); ++i) alpha[i] = rgba[4 * i + 3];
  return alpha;
}

void cast(FrameState& frame, HostImages& images) {
  const volume::PictureRays rays = frame.rays();
  std::vector<double> isovalues;
  for (const Surface& surface : frame.surfaces)
    isovalues.push_back(frame.volume->grid().storedOfValue(surface.value));
  const volume::SurfaceCaster caster(frame.volume->grid(), isovalues, frame.volume->blocks().dims(),
                                     frame.volume->masks());
  if (frame.layer.empty()) {
    caster.castAll(rays, frame.raySize(), images.points, images.infos, frame.request.stop);
    return;
  }
  const HostImages& before = frame.host.at(frame.layerBefore);
  const std::vector<float> covered = alphaOf(frame.images.at(image::color).images[0]);
  caster.castBehind(rays, frame.raySize(), {before.points, before.infos, covered}, images.points,
                    images.infos, frame.request.stop);
}

}  // namespace

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
  const glm::ivec2 size = frame.raySize();
  const std::size_t count = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
  HostImages& images = frame.host[frame.layer];
  if (images.points.size() != count) makeRoom(images, count);
  if (frame.empty()) {
    std::fill(images.points.begin(), images.points.end(), glm::vec4(0.0f, 0.0f, 0.0f, -1.0f));
    std::fill(images.infos.begin(), images.infos.end(), glm::vec2(0.0f));
  } else {
    cast(frame, images);
  }
  const Target& target = frame.target(image::surface, {GL_RGBA32F, GL_RG32F});
  upload(target.images[0], GL_RGBA, images.points.data());
  upload(target.images[1], GL_RG, images.infos.data());
  images.any = std::any_of(images.points.begin(), images.points.end(),
                           [](const glm::vec4& point) { return point.w >= 0.0f; });
}

void deriveOnProcessor(FrameState& frame, const std::vector<Texture>& textures) {
  HostImages& images = frame.host.at(frame.layer);
  for (std::size_t i = 0; i < textures.size(); ++i) images.derivatives[i].resize(images.points.size());
  auto& [gradient, diagonal, mixed] = images.derivatives;
  if (frame.empty()) {
    for (std::vector<glm::vec4>& image : images.derivatives)
      std::fill(image.begin(), image.end(), glm::vec4(0.0f));
  } else {
    volume::DerivativeImages out{gradient, {}, {}};
    if (textures.size() == 3) out = {gradient, diagonal, mixed};
    const scene::Field field = frame.scene->derivatives.field;
    const volume::DerivedField derived =
        field == scene::Field::trilinear ? volume::DerivedField::trilinear : volume::DerivedField::spline;
    volume::surfaceDerivatives(frame.volume->grid(), derived, frame.volume->coefficients(field),
                               images.points, out, volume::TracerTarget::automatic, frame.request.stop);
  }
  for (std::size_t i = 0; i < textures.size(); ++i)
    upload(textures[i], GL_RGBA, images.derivatives[i].data());
}

}  // namespace isolux::render
