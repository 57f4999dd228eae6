#include "render/passes/processor.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <type_traits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/gl/constants.h"
#include "render/passes/frame_state.h"
#include "render/passes/passes.h"
#include "scene/rules/needs.h"
#include "volume/cast/hit_info.h"
#include "volume/cast/surface_caster.h"
#include "volume/cast/surface_derivatives.h"

namespace isolux::render {

namespace {

// Parts of an image into a texture as wide, whose first row is that row of the image.
template <class T>
void upload(const Texture& texture, const std::vector<volume::Rectangle>& parts, const std::vector<T>& texels,
            int firstRow = 0) {
  GLenum format = GL_RED, type = GL_UNSIGNED_BYTE;
  if constexpr (!std::is_same_v<T, std::uint8_t>) {
    format = std::is_same_v<T, glm::vec4> ? GL_RGBA : GL_RG;
    type = GL_FLOAT;
  }
  const Gl& gl = texture.gl();
  const int width = texture.size().x;
  gl.PixelStorei(GL_UNPACK_ROW_LENGTH, width);
  for (const volume::Rectangle& part : parts) {
    const std::ptrdiff_t first = static_cast<std::ptrdiff_t>(part.low.y) * width + part.low.x;
    texture.write(format, type, texels.data() + first, {part.low - glm::ivec2(0, firstRow), part.size});
  }
  gl.PixelStorei(GL_UNPACK_ROW_LENGTH, 0);
}

// `changed` of an image as large as the texture.
template <class T>
void upload(const Texture& texture, const volume::PictureArea& changed, const std::vector<T>& texels) {
  upload(texture, changed.rectangles(), texels);
}

HostImages& hostImages(FrameState& frame, const std::string& name) {
  const auto found = frame.host.find(name);
  if (found != frame.host.end()) {
    if (found->second.crossings.area.size() == frame.raySize()) return found->second;
    frame.host.erase(found);  // before its successor is made: both need not fit
  }
  return frame.host.emplace(name, HostImages(frame.raySize())).first->second;
}

// How much of each pixel is covered already, of those of the crossing before.
std::vector<float> alphaOf(const Texture& color, const volume::PictureArea& before) {
  const volume::Extent2 extent{glm::ivec2(color.size())};
  std::vector<float> alpha(extent.count());
  for (const volume::Rectangle& part : before.rectangles()) {
    const std::vector<float> rgba = color.readFloats(4, part);
    for (std::size_t i = 0; i < rgba.size() / 4; ++i)
      alpha[extent.index(part.low + volume::Extent2{part.size}.at(i))] = rgba[4 * i + 3];
  }
  return alpha;
}

void derive(const GpuVolume& volume, const FieldAt& field, const std::vector<glm::vec4>& points,
            const volume::PictureArea& area, const volume::DerivativeImages& out,
            const std::stop_token& stop) {
  const volume::ScaledField* const scaled = volume.scaled(field);
  const volume::DerivedField of{scaled ? nullptr : volume.coefficients(field.field), scaled,
                                field.field == scene::Field::trilinear};
  volume::surfaceDerivatives(volume.grid(), of, points, area, out, volume::TracerTarget::automatic, stop);
}

volume::SurfaceCaster casterOf(const FrameState& frame) {
  std::vector<double> isovalues;
  for (const Surface& surface : frame.groupSurfaces())
    isovalues.push_back(frame.volume->grid().storedOfValue(surface.value));
  const scene::Field field = frame.scene->hit.field;
  const GpuVolume& volume = *frame.volume;
  std::vector<const volume::VoxelMask*> hidden;
  if (!volume.hidden().empty())
    for (const Surface& surface : frame.groupSurfaces())
      hidden.push_back(volume::hiddenAt(volume.hidden(), surface.value).voxels);
  volume::CastField of{volume.grid(), field, volume.coefficients(field), hidden,
                       frame.scene->isosurface.inside};
  if (frame.cut.cuts()) {
    of.region = &frame.cut.region();
    of.clipped = frame.clippedBits();
  }
  if (frame.cutFaceColors) of.rayEnds = frame.cutFaces->ends;
  return {of, isovalues, volume.surface().blocks().dims(), volume.surface().masks()};
}

bool isOfGroup(const FrameState& frame, const glm::vec2& info) {
  const int place = volume::HitInfo::of(info.y).surface() - static_cast<int>(frame.firstSurface());
  return place >= 0 && place < static_cast<int>(frame.groupSurfaces().size());
}

std::uint8_t darker(std::uint8_t a, std::uint8_t b) {
  return std::min(a, b);
}

// The name of the crossings of the group that is cast, in a layer.
std::string castName(const FrameState& frame, const std::string& layer) {
  return frame.castName("") + layer;
}

// The crossings of the group that were not the nearest of their rays are still to come.
void keepCrossings(const FrameState& frame, const volume::CrossingsBefore& before,
                   volume::CrossingImage& out) {
  const std::vector<glm::vec2>& nearest = frame.host.at(frame.layerBefore).crossings.infos;
  const volume::CrossingImage& own = before.crossings;
  for (const volume::Rectangle& part : own.area.rectangles())
    for (int y = part.low.y; y < part.low.y + part.size.y; ++y)
      for (int x = part.low.x; x < part.low.x + part.size.x; ++x) {
        const std::size_t i = volume::Extent2{own.area.size()}.index(x, y);
        const bool ends = before.covered[i] > volume::CrossingsBefore::kMostCovered;
        if (own.points[i].w < 0.0f || ends || isOfGroup(frame, nearest[i])) continue;
        out.points[i] = own.points[i];
        out.infos[i] = own.infos[i];
        out.area.add(y, x, x + 1);
      }
}

// `covered`: of each pixel, behind the first crossing.
void cast(FrameState& frame, const std::vector<float>& covered, volume::CrossingImage& out) {
  const volume::PictureRays rays = frame.rays();
  const volume::SurfaceCaster caster = casterOf(frame);
  if (frame.layer.empty()) return caster.castAll(rays, out, frame.request.stop);
  const volume::CrossingsBefore before{frame.host.at(castName(frame, frame.layerBefore)).crossings, covered};
  if (frame.groups() == 1) return caster.castBehind(rays, before, out, frame.request.stop);
  const std::vector<glm::vec2>& nearest = frame.host.at(frame.layerBefore).crossings.infos;
  std::vector<float> others = covered;
  for (std::size_t i = 0; i < others.size(); ++i)
    if (!isOfGroup(frame, nearest[i])) others[i] = 1.0f;
  caster.castBehind(rays, {before.crossings, others}, out, frame.request.stop);
  keepCrossings(frame, before, out);
}

void findEdges(const FrameState& frame, const FieldAt& field, const volume::EdgeSearch<float>& search,
               const std::vector<glm::vec4>& points, const volume::PictureArea& area,
               std::vector<glm::vec2>& edges) {
  const GpuVolume& volume = *frame.volume;
  volume::surfaceEdges(volume.grid(), {volume.coefficients(field.field), volume.scaled(field)}, search,
                       points, area, edges, kNoEdge, volume::TracerTarget::automatic, frame.request.stop);
}

}  // namespace

namespace {

constexpr const char* kStripOfGradients = "a strip of gradients";
constexpr const char* kLess = "a smaller image or --executor gpu needs less";

void resize(HostImages::Derivatives& image, std::size_t texels) {
  if (image.texels.size() == texels) return;
  image = {};
  image.held = base::machineMemory().reserve(texels * sizeof(glm::vec4), "derivatives of the picture", kLess);
  image.texels.resize(texels);
}

// The smallest rectangle of whole pixels with all hits and a margin of pixels without, as the passes that
// read neighbours expect; at multiples of the strips of an area.
Tile pixelsOfHits(const volume::PictureArea& hits, int supersampling, glm::ivec2 drawn) {
  constexpr int margin = 2;
  glm::ivec2 low = hits.size(), high(0);
  for (const volume::Rectangle& part : hits.rectangles()) {
    low = glm::min(low, part.low);
    high = glm::max(high, part.low + part.size);
  }
  low = glm::min(low, high) / supersampling - margin;
  high = (high + supersampling - 1) / supersampling + margin;
  constexpr int step = volume::PictureArea::kRows;
  low = glm::max(low, glm::ivec2(0)) / step * step;
  return {low, glm::min(high, drawn) - low};
}

// The part of the crossings that starts at `low`.
void copyPart(const volume::CrossingImage& from, glm::ivec2 low, volume::CrossingImage& to) {
  const glm::ivec2 size = to.area.size();
  for (int y = 0; y < size.y; ++y) {
    const auto source = static_cast<std::ptrdiff_t>(low.y + y) * from.area.size().x + low.x;
    const auto target = static_cast<std::ptrdiff_t>(y) * size.x;
    std::copy_n(from.points.begin() + source, size.x, to.points.begin() + target);
    std::copy_n(from.infos.begin() + source, size.x, to.infos.begin() + target);
  }
  for (const volume::Rectangle& part : from.area.rectangles())
    for (int y = 0; y < part.size.y; ++y)
      to.area.add(part.low.y - low.y + y, part.low.x - low.x, part.low.x - low.x + part.size.x);
}

// From here on images have the size of what can be seen of the surface.
void cropToHits(FrameState& frame) {
  const volume::CrossingImage& whole = frame.host.at("").crossings;
  const int rays = frame.request.supersampling;
  const Tile part = pixelsOfHits(whole.area, rays, frame.drawnSize());
  if (part.size == frame.drawnSize()) return;
  HostImages images(part.size * rays);
  copyPart(whole, part.origin * rays, images.crossings);
  frame.host.clear();
  frame.host.emplace("", std::move(images));
  frame.hitPart = part;
}

}  // namespace

HostImages::HostImages(glm::ivec2 size)
    : held(base::machineMemory().reserve(
          volume::Extent2{size}.count() * (sizeof(glm::vec2) + sizeof(glm::vec4)), "hits of the picture",
          kLess)),
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

namespace {
void uploadCrossings(FrameState& frame) {
  const volume::CrossingImage& crossings = frame.host.at(frame.layer).crossings;
  Target& target = surfaceTarget(frame);
  target.drawn.add(crossings.area);
  upload(target.images[0], target.drawn, crossings.points);
  upload(target.images[1], target.drawn, crossings.infos);
  target.drawn = crossings.area;
}
}  // namespace

void castOnProcessor(FrameState& frame) {
  std::vector<float> covered;
  if (!frame.layer.empty())
    covered =
        alphaOf(frame.images.at(image::color).images[0], frame.host.at(frame.layerBefore).crossings.area);
  bool any = false;
  frame.forGroups([&] {
    volume::CrossingImage& crossings = hostImages(frame, castName(frame, frame.layer)).crossings;
    if (!frame.groupIsEmpty())
      cast(frame, covered, crossings);
    else if (!crossings.area.empty())
      crossings = volume::CrossingImage(frame.raySize());
    any = any || !crossings.area.empty();
  });
  if (!frame.layer.empty()) frame.anyBehind = any;
  if (frame.groups() > 1) return;  // to be merged
  if (frame.layer.empty() && frame.cropsToHits() && !frame.request.stop.stop_requested()) cropToHits(frame);
  uploadCrossings(frame);
}

namespace {

// Calls each(index) for the pixels of an area, rows in parallel.
template <class Each>
void eachPixel(const volume::PictureArea& area, const Each& each) {
  for (const volume::Rectangle& part : area.rectangles())
    volume::parallelEach(part.size.y, [&](int row) {
      const std::size_t first = volume::Extent2{area.size()}.index(part.low + glm::ivec2(0, row));
      for (std::size_t i = first; i < first + static_cast<std::size_t>(part.size.x); ++i) each(i);
    });
}

// Voxels per mm along the axis on which a ray covers most.
float largestStep(const volume::PictureRays& rays, glm::ivec2 pixel) {
  const glm::vec2 at = (glm::vec2(pixel + rays.origin) + 0.5f) / glm::vec2(rays.picture);
  const glm::vec2 plane = (2.0f * at - 1.0f) * rays.halfExtent;
  const glm::vec3 steps = rays.orthographic ? rays.forward
                                            : (rays.forward + plane.x * rays.right + plane.y * rays.up) /
                                                  std::sqrt(1.0f + glm::dot(plane, plane));
  return std::max({std::abs(steps.x), std::abs(steps.y), std::abs(steps.z)});
}

// As merge.frag.glsl with JOIN.
void joinSolids(FrameState& frame, volume::CrossingImage& nearest) {
  const volume::PictureRays rays = frame.rays();
  const bool outward = frame.outward() < 0.0;
  const auto enters = [&](volume::HitInfo info) { return info.risesBehind() == outward; };
  const volume::Extent2 extent{nearest.area.size()};
  const auto join = [&](const volume::CrossingImage& other) {
    eachPixel(nearest.area, [&](std::size_t i) {
      const volume::HitInfo known = volume::HitInfo::of(nearest.infos[i].y);
      const float t = nearest.points[i].w, of = other.points[i].w;
      if (t < 0.0f || of < 0.0f || enters(known) || known.isJoined()) return;
      if (!enters(volume::HitInfo::of(other.infos[i].y))) return;
      if (std::abs(of - t) * largestStep(rays, extent.at(i)) <= 0.5f)
        nearest.infos[i].y = known.joined().packed();
    });
  };
  frame.forGroups([&] { join(frame.host.at(castName(frame, frame.layer)).crossings); });
  if (!frame.layer.empty()) join(frame.host.at(frame.layerBefore).crossings);
}

}  // namespace

void mergeOnProcessor(FrameState& frame) {
  volume::CrossingImage& nearest = hostImages(frame, frame.layer).crossings;
  nearest = volume::CrossingImage(frame.raySize());
  frame.forGroups([&] {
    const volume::CrossingImage& of = frame.host.at(castName(frame, frame.layer)).crossings;
    eachPixel(of.area, [&](std::size_t i) {
      const float t = of.points[i].w;
      if (t < 0.0f || (nearest.points[i].w >= 0.0f && nearest.points[i].w <= t)) return;
      nearest.points[i] = of.points[i];
      const volume::HitInfo known = volume::HitInfo::of(of.infos[i].y);
      nearest.infos[i] = {of.infos[i].x, known.amongAll(static_cast<int>(frame.firstSurface())).packed()};
    });
    nearest.area.add(of.area);
  });
  if (frame.joinsSolids()) joinSolids(frame, nearest);
  uploadCrossings(frame);
}

namespace {

// Calls make(points), which fills images at the points, for those of each volume, and puts together what it
// wrote.
template <class Texel, class Make>
void atHitsOfVolumes(FrameState& frame, const volume::CrossingImage& crossings,
                     const std::vector<std::vector<Texel>*>& images, const Make& make) {
  if (!frame.isOfLabels()) return make(crossings.points);
  std::vector<std::vector<Texel>> all;
  for (const std::vector<Texel>* image : images) all.push_back(*image);
  frame.forVolumes([&] {
    const auto isOther = [&](std::size_t i) {
      return !frame.isOfVolume(volume::HitInfo::of(crossings.infos[i].y));
    };
    std::vector<glm::vec4> points = crossings.points;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (isOther(i)) points[i].w = -1.0f;
    make(points);
    for (std::size_t i = 0; i < points.size(); ++i)
      if (crossings.points[i].w < 0.0f || !isOther(i))
        for (std::size_t k = 0; k < images.size(); ++k) all[k][i] = (*images[k])[i];
  });
  for (std::size_t k = 0; k < images.size(); ++k) images[k]->swap(all[k]);
}

}  // namespace

void deriveOnProcessor(FrameState& frame, Target* target, const FieldAt& field, bool hessian) {
  HostImages& images = frame.host.at(frame.layer);
  const volume::PictureArea& area = images.crossings.area;
  const std::size_t count = hessian ? 3 : 1;
  const std::span<HostImages::Derivatives> own(hessian ? images.hessian : &images.gradient, count);
  volume::PictureArea changed = area;
  for (HostImages::Derivatives& image : own) {
    resize(image, images.crossings.points.size());
    if (image.area.size() == area.size()) changed.add(image.area);
  }
  std::vector<std::vector<glm::vec4>*> texels;
  for (HostImages::Derivatives& image : own) texels.push_back(&image.texels);
  if (!changed.empty())
    atHitsOfVolumes(frame, images.crossings, texels, [&](const std::vector<glm::vec4>& points) {
      volume::DerivativeImages out{own[0].texels, {}, {}};
      if (hessian) out = {own[0].texels, own[1].texels, own[2].texels};
      derive(*frame.volume, field, points, changed, out, frame.request.stop);
    });
  const bool stopped = frame.request.stop.stop_requested();  // some of what was there may be left
  for (HostImages::Derivatives& image : own) image.area = stopped ? changed : area;
  if (!target) return;
  target->drawn.add(area);
  upload(target->images[0], target->drawn, own[0].texels);
  if (!stopped) target->drawn = area;
}

void setGradientStrip(FrameState& frame, Program& program, int unit, int firstRow, int rows) {
  const int width = frame.raySize().x;
  const Target& strip = frame.images.make(frame.gl, kStripOfGradients, {width, rows}, {GL_RGBA32F});
  upload(strip.images[0], volume::partsOf(frame.area(), {{0, firstRow}, {width, rows}}),
         frame.host.at(frame.layer).gradient.texels, firstRow);
  program.setTexture("uGradient", unit, strip.images[0]);
  program.set("uGradientRow", firstRow);
}

void drawFromHostHessians(FrameState& frame, Target& target, Program& program) {
  constexpr int kRows = 64;
  const char* const name = "a strip of Hessians";
  const HostImages::Derivatives* const hessian = frame.host.at(frame.layer).hessian;
  const glm::ivec2 size = frame.raySize();
  volume::PictureArea drawn = frame.area();
  drawn.add(target.drawn);
  const Target& strip =
      frame.images.make(frame.gl, name, {size.x, std::min(kRows, size.y)}, {GL_RGBA32F, GL_RGBA32F});
  program.setTexture("uHessianDiagonal", 1, strip.images[0]);
  program.setTexture("uHessianMixed", 2, strip.images[1]);
  frame.begin(target);
  for (int row = 0; row < size.y && !frame.request.stop.stop_requested(); row += kRows) {
    const std::vector<volume::Rectangle> parts = volume::partsOf(drawn, {{0, row}, {size.x, kRows}});
    for (std::size_t i : {std::size_t{0}, std::size_t{1}})
      upload(strip.images[i], parts, hessian[i + 1].texels, row);
    program.set("uHessianRow", row);
    frame.drawRectangles(program, parts);
  }
  frame.images.drop(name);
  target.drawn = frame.request.stop.stop_requested() ? drawn : frame.area();
}

void releaseHostImages(FrameState& frame, const std::string& image) {
  if (image == image::surface) frame.host.clear();
  if (image == image::gradient) frame.images.drop(kStripOfGradients);
  for (auto& [layer, images] : frame.host) {
    if (image == image::gradient) images.gradient = {};
    if (image == image::tangents) images.hessian[0] = {};
    if (image == image::hessian) images.hessian[1] = images.hessian[2] = {};
  }
}

void edgesOnProcessor(FrameState& frame, Target& target, const FieldAt& field,
                      const volume::EdgeSearch<float>& search) {
  HostImages& images = frame.host.at(frame.layer);
  const volume::PictureArea& area = images.crossings.area;
  volume::PictureArea changed = area;
  images.edges.resize(images.crossings.points.size(), {kNoEdge, 0.0f});
  if (images.edgesArea.size() == area.size()) changed.add(images.edgesArea);
  atHitsOfVolumes<glm::vec2>(frame, images.crossings, {&images.edges},
                             [&](const std::vector<glm::vec4>& points) {
                               findEdges(frame, field, search, points, changed, images.edges);
                             });
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

void shadowOnProcessor(FrameState& frame, Target& target) {
  HostImages& images = frame.host.at(frame.layer);
  const glm::dmat4 voxelFromWorld = frame.volume->grid().geometry().voxelFromWorld();
  volume::ShadowRays shadow{.rays = frame.rays(),
                            .right = frame.view->rightWorld,
                            .up = frame.view->upWorld,
                            .forward = frame.view->forwardWorld,
                            .outward = static_cast<float>(frame.outward()),
                            .voxelFromWorld = glm::mat3(voxelFromWorld),
                            .light = frame.towardLight()};
  const HostImages::Derivatives& gradients = frame.gradientShared ? images.hessian[0] : images.gradient;
  volume::ShadowImage ofGroup;
  frame.forGroups([&] {
    if (frame.group > 0 && frame.groupIsEmpty()) return;
    shadow.opaque = frame.opaqueBits();
    shadow.first = static_cast<int>(frame.firstSurface());
    shadow.surfaces = static_cast<int>(frame.groupSurfaces().size());
    volume::ShadowImage& out = frame.group == 0 ? images.shadow : ofGroup;
    casterOf(frame).castShadows(shadow, images.crossings, gradients.texels, out, frame.request.stop);
    if (frame.group > 0)
      std::ranges::transform(out.lit, images.shadow.lit, images.shadow.lit.begin(), darker);
  });
  target.drawn.add(images.shadow.area);
  upload(target.images[0], target.drawn, images.shadow.lit);
  target.drawn = images.shadow.area;
}

}  // namespace isolux::render
