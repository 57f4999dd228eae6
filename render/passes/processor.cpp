#include "render/passes/processor.h"

#include <algorithm>
#include <span>
#include <type_traits>

#include "render/constants.h"
#include "render/passes/frame_state.h"
#include "scene/rules/needs.h"
#include "volume/cast/surface_caster.h"
#include "volume/cast/surface_derivatives.h"

namespace isolux::render {

namespace {

// `changed` of an image as large as the texture.
template <class T>
void upload(const Texture& texture, const volume::PictureArea& changed, const std::vector<T>& texels) {
  GLenum format = GL_RED, type = GL_UNSIGNED_BYTE;
  if constexpr (!std::is_same_v<T, std::uint8_t>) {
    format = std::is_same_v<T, glm::vec4> ? GL_RGBA : GL_RG;
    type = GL_FLOAT;
  }
  const Gl& gl = texture.gl();
  const int width = texture.size().x;
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.PixelStorei(GL_UNPACK_ROW_LENGTH, width);
  for (const volume::Rectangle& part : changed.rectangles()) {
    const std::ptrdiff_t first = static_cast<std::ptrdiff_t>(part.low.y) * width + part.low.x;
    gl.TextureSubImage2D(texture.id(), 0, part.low.x, part.low.y, part.size.x, part.size.y, format, type,
                         texels.data() + first);
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

void derive(const GpuVolume& volume, const FieldAt& field, const volume::CrossingImage& crossings,
            const volume::PictureArea& area, const volume::DerivativeImages& out,
            const std::stop_token& stop) {
  constexpr auto widest = volume::TracerTarget::automatic;
  if (const volume::ScaledField* const scaled = volume.scaled(field)) {
    volume::surfaceDerivatives(volume.grid(), *scaled, crossings.points, area, out, widest, stop);
    return;
  }
  const bool trilinear = field.field == scene::Field::trilinear;
  volume::surfaceDerivatives(volume.grid(),
                             trilinear ? volume::DerivedField::trilinear : volume::DerivedField::spline,
                             volume.coefficients(field.field), crossings.points, area, out, widest, stop);
}

volume::SurfaceCaster casterOf(const FrameState& frame) {
  std::vector<double> isovalues;
  for (const Surface& surface : frame.surfaces)
    isovalues.push_back(frame.volume->grid().storedOfValue(surface.value));
  const scene::Field field = frame.scene->hit.field;
  const GpuVolume& volume = *frame.volume;
  std::vector<const volume::HiddenVoxels*> hidden;
  if (!frame.hidden.empty())
    for (const Surface& surface : frame.surfaces)
      hidden.push_back(volume::hiddenAt(frame.hidden, surface.value).voxels);
  volume::CastField of{volume.grid(), field, volume.coefficients(field), hidden,
                       frame.scene->isosurface.inside};
  if (frame.cut.cuts()) {
    of.region = &frame.cut.region();
    of.clipped = frame.clippedBits();
  }
  if (frame.cutFaceColors) of.rayEnds = frame.cutFaces->ends;
  return {of, isovalues, volume.blocks().dims(), volume.masks()};
}

void cast(FrameState& frame, volume::CrossingImage& out) {
  const volume::PictureRays rays = frame.rays();
  const volume::SurfaceCaster caster = casterOf(frame);
  if (frame.layer.empty()) {
    caster.castAll(rays, out, frame.request.stop);
    return;
  }
  const volume::CrossingImage& before = frame.host.at(frame.layerBefore).crossings;
  const std::vector<float> covered = alphaOf(frame.images.at(image::color).images[0], before.area);
  caster.castBehind(rays, {before, covered}, out, frame.request.stop);
}

void findEdges(const FrameState& frame, const FieldAt& field, const volume::EdgeSearch<float>& search,
               const std::vector<glm::vec4>& points, const volume::PictureArea& area,
               std::vector<glm::vec2>& edges) {
  const GpuVolume& volume = *frame.volume;
  volume::surfaceEdges(volume.grid(), volume.scaled(field), volume.coefficients(field.field), search, points,
                       area, edges, kNoEdge, volume::TracerTarget::automatic, frame.request.stop);
}

}  // namespace

HostImages::HostImages(glm::ivec2 size)
    : held(base::machineMemory().reserve(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) *
                                             (sizeof(glm::vec2) + 5 * sizeof(glm::vec4)),
                                         "hits of the picture",
                                         "a smaller image or --executor gpu needs less")),
      crossings(size) {}

OnProcessor onProcessor(bool taken, const scene::Scene& scene) {
  OnProcessor on;
  if (!taken) return on;
  on.casts = scene.hit.method == scene::HitMethod::exact;
  // The fast scheme is one of filtered fetches: it is what it is on a graphics card only.
  on.all = on.casts && !scene::fetchesFast(scene);
  return on;
}

bool takesProcessor(scene::Executor executor, const Gl& gl) {
  if (!volume::SurfaceCaster::available()) return false;
  return executor == scene::Executor::cpu || (executor == scene::Executor::automatic && gl.software);
}

void castOnProcessor(FrameState& frame) {
  volume::CrossingImage& crossings = hostImages(frame).crossings;
  if (!frame.empty())
    cast(frame, crossings);
  else if (!crossings.area.empty())
    crossings = volume::CrossingImage(frame.raySize());
  Target& target = frame.target(image::surface, {GL_RGBA32F, GL_RG32F});
  target.drawn.add(crossings.area);
  upload(target.images[0], target.drawn, crossings.points);
  upload(target.images[1], target.drawn, crossings.infos);
  target.drawn = crossings.area;
}

void deriveOnProcessor(FrameState& frame, Target& target, const FieldAt& field) {
  HostImages& images = frame.host.at(frame.layer);
  const volume::PictureArea& area = images.crossings.area;
  const std::size_t count = target.images.size();
  const std::span<HostImages::Derivatives> own(count == 3 ? images.hessian : &images.gradient, count);
  volume::PictureArea changed = area;
  for (HostImages::Derivatives& image : own) {
    image.texels.resize(images.crossings.points.size());
    if (image.area.size() == area.size()) changed.add(image.area);
  }
  volume::DerivativeImages out{own[0].texels, {}, {}};
  if (count == 3) out = {own[0].texels, own[1].texels, own[2].texels};
  if (!changed.empty()) derive(*frame.volume, field, images.crossings, changed, out, frame.request.stop);
  const bool stopped = frame.request.stop.stop_requested();  // some of what was there may be left
  target.drawn.add(area);
  for (std::size_t i = 0; i < count; ++i) {
    upload(target.images[i], target.drawn, own[i].texels);
    own[i].area = stopped ? changed : area;
  }
  if (!stopped) target.drawn = area;
}

void edgesOnProcessor(FrameState& frame, Target& target, const FieldAt& field,
                      const volume::EdgeSearch<float>& search) {
  HostImages& images = frame.host.at(frame.layer);
  const volume::PictureArea& area = images.crossings.area;
  volume::PictureArea changed = area;
  images.edges.resize(images.crossings.points.size(), {kNoEdge, 0.0f});
  if (images.edgesArea.size() == area.size()) changed.add(images.edgesArea);
  findEdges(frame, field, search, images.crossings.points, changed, images.edges);
  const bool stopped = frame.request.stop.stop_requested();
  target.drawn.add(area);
  upload(target.images[0], target.drawn, images.edges);
  images.edgesArea = stopped ? changed : area;
  if (!stopped) target.drawn = area;
}

void edgesAtReadPoints(FrameState& frame, Target& target, const FieldAt& field,
                       const volume::EdgeSearch<float>& search) {
  const glm::ivec2 size = frame.raySize();
  const std::vector<float> read = frame.image(image::surface).readFloats(4, {glm::ivec2(0), size});
  std::vector<glm::vec4> points(read.size() / 4);
  for (std::size_t i = 0; i < points.size(); ++i)
    points[i] = {read[4 * i], read[4 * i + 1], read[4 * i + 2], read[4 * i + 3]};
  std::vector<glm::vec2> edges(points.size(), {kNoEdge, 0.0f});
  findEdges(frame, field, search, points, frame.area(), edges);
  volume::PictureArea all = frame.area();
  all.add(target.drawn);
  upload(target.images[0], all, edges);
  target.drawn = frame.area();
}

void shadowOnProcessor(FrameState& frame, Target& target, int opaque) {
  HostImages& images = frame.host.at(frame.layer);
  const glm::dmat4 voxelFromWorld = frame.volume->grid().geometry().voxelFromWorld();
  const volume::ShadowRays shadow{.rays = frame.rays(),
                                  .right = frame.view->rightWorld,
                                  .up = frame.view->upWorld,
                                  .forward = frame.view->forwardWorld,
                                  .outward = static_cast<float>(frame.outward()),
                                  .voxelFromWorld = glm::mat3(voxelFromWorld),
                                  .light = frame.towardLight(),
                                  .opaque = opaque};
  const HostImages::Derivatives& gradients = frame.gradientShared ? images.hessian[0] : images.gradient;
  casterOf(frame).castShadows(shadow, images.crossings, gradients.texels, images.shadow, frame.request.stop);
  target.drawn.add(images.shadow.area);
  upload(target.images[0], target.drawn, images.shadow.lit);
  target.drawn = images.shadow.area;
}

}  // namespace isolux::render
