#include "render/passes/cut_faces_pass.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>
#include <vector>

#include <tbb/combinable.h>

#include "scene/color_maps.h"
#include "scene/opacity.h"
#include "scene/rules/needs.h"
#include "volume/parallel/parallel_loops.h"
#include "volume/prepared/label_surfaces.h"

namespace isolux::render {

namespace {

constexpr int kCutColors = 256;

// As the caster's and the shaders', in double precision; t counts from where they begin.
volume::Ray rayAt(const volume::PictureRays& rays, glm::ivec2 pixel) {
  const glm::dvec2 at = (glm::dvec2(pixel + rays.origin) + 0.5) / glm::dvec2(rays.picture);
  const glm::dvec2 plane = (2.0 * at - 1.0) * glm::dvec2(rays.halfExtent);
  const glm::dvec3 offset = plane.x * glm::dvec3(rays.right) + plane.y * glm::dvec3(rays.up);
  if (rays.orthographic) return {glm::dvec3(rays.eye) + offset, glm::dvec3(rays.forward)};
  const glm::dvec3 forward = glm::dvec3(rays.forward) + offset;
  return {glm::dvec3(rays.eye) + static_cast<double>(rays.startDepth) * offset,
          forward / std::sqrt(1.0 + glm::dot(plane, plane))};
}

// 8 bits of the root of each channel, red first: floats hold 24 exactly.
float packed(const glm::vec3& linear) {
  const glm::vec3 bytes = glm::round(255.0f * glm::sqrt(glm::clamp(linear, 0.0f, 1.0f)));
  return (bytes.x * 256.0f + bytes.y) * 256.0f + bytes.z;
}

glm::vec3 unpacked(float value) {
  const int bytes = static_cast<int>(value);
  const glm::vec3 roots = glm::vec3(bytes >> 16, bytes >> 8 & 255, bytes & 255) / 255.0f;
  return roots * roots;
}

// What a cut lays open of a label map: each label in the colour of its surface, opaque ones alone.
class LabelFaces {
 public:
  LabelFaces(const scene::Scene& scene, const volume::ShownLabels& labels)
      : labels_(labels), whole_(scene.clip.cap == scene::ClipCap::whole) {
    const std::vector<std::vector<int>> own = volume::labelsOfSurfaces(scene, labels);
    for (std::size_t i = 0; i < own.size(); ++i) {
      const scene::Surface& surface = scene.surfaces[i];
      const bool isFilled = surface.shown && scene::isOpaque(surface) && surface.clipped;
      for (const int label : own[i])
        known_[label] = {isFilled, packed(surface.labelColors ? volume::faceColor(labels, label)
                                                              : glm::vec3(surface.albedo))};
    }
  }
  std::optional<float> at(const volume::Ray& ray, const volume::CutFace& face) const {
    const int label = volume::labelOfFace(labels_, ray.origin + face.t * ray.direction, face.value);
    const auto known = known_.find(label);
    if (known == known_.end()) return packed(volume::faceColor(labels_, label));
    if (!whole_ && !known->second.isFilled) return std::nullopt;
    return known->second.color;
  }

 private:
  struct Known {
    bool isFilled = false;
    float color = 0.0f;
  };
  const volume::ShownLabels& labels_;
  bool whole_;
  std::unordered_map<int, Known> known_;
};

// Fills row y; what of it holds faces goes to `area`.
void findRow(const volume::CutFaces& faces, const LabelFaces* labels, const volume::PictureRays& rays, int y,
             CutFaceImage& out, volume::PictureArea& area) {
  const int width = area.size().x;
  int first = width, last = -1;
  for (int x = 0; x < width; ++x) {
    const std::size_t i = volume::Extent2{area.size()}.index(x, y);
    const volume::Ray ray = rayAt(rays, {x, y});
    const std::optional<volume::CutFace> face = faces.at(ray);
    std::optional<float> value;
    if (face) value = labels ? labels->at(ray, *face) : static_cast<float>(face->value);
    out.ends[i] = value ? static_cast<float>(face->t) : std::numeric_limits<float>::infinity();
    out.texels[i] = value ? glm::vec2(out.ends[i], *value) : glm::vec2(-1.0f, 0.0f);
    if (!value) continue;
    first = std::min(first, x);
    last = x;
  }
  if (last >= 0) area.add(y, first, last + 1);
}

void declareCutFaces(Declaring& d) {
  d.writes(image::cutFaces, 8);
  if (!scene::showsCutFaces(d.asked.scene)) {
    d.notNeeded("no cut face is shown");
    return;
  }
  d.volume().isovalues().cuts().pictureSize();
  d.settings({"camera.", "hit.field", "isosurface.inside", "clip.cap", "slice.field"});
  d.ofSurfaces("what is opaque", scene::isOpaque);
  if (d.asked.volume.hasLabels)
    d.settings({"surfaces.#.labels", "surfaces.#.label_colors", "surfaces.#.albedo"});
}

void findCutFaces(FrameState& frame) {
  const glm::ivec2 size = frame.raySize();
  Target& target = frame.target(image::cutFaces, {GL_RG32F});
  if (!frame.cutFaces || frame.cutFaces->area.size() != size) frame.cutFaces.emplace(size);
  CutFaceImage& out = *frame.cutFaces;
  std::fill(out.ends.begin(), out.ends.end(), std::numeric_limits<float>::infinity());
  std::fill(out.texels.begin(), out.texels.end(), glm::vec2(-1.0f, 0.0f));
  out.area = volume::PictureArea(size);
  if (frame.prepared) {
    base::Progress unwatched;
    const auto hidden = volume::hiddenOf(*frame.scene, *frame.prepared->pieces, unwatched);
    const volume::CutFaces faces(frame.prepared->grid(), *frame.prepared->cubicFields, *frame.scene, hidden);
    std::optional<LabelFaces> labels;
    if (frame.prepared->labels) labels.emplace(*frame.scene, *frame.prepared->labels);
    const LabelFaces* const ofLabels = labels ? &*labels : nullptr;
    const volume::PictureRays rays = frame.rays();
    tbb::combinable<volume::PictureArea> areas([&] { return volume::PictureArea(size); });
    volume::parallelRanges(size.y, 4, [&](const auto& rows) {
      for (int y = rows.begin(); y < rows.end() && !frame.request.stop.stop_requested(); ++y)
        findRow(faces, ofLabels, rays, y, out, areas.local());
    });
    areas.combine_each([&](const volume::PictureArea& area) { out.area.add(area); });
  }
  target.images[0].write(GL_RG, GL_FLOAT, out.texels.data());
  target.drawn = out.area;
}

}  // namespace

Pass cutFacesPass() {
  return {.name = "cut faces", .declare = declareCutFaces, .run = findCutFaces, .cpu = Pass::Cpu::always};
}

CutFaceImage::CutFaceImage(glm::ivec2 size)
    : held(base::machineMemory().reserve(volume::Extent2{size}.count() * (sizeof(glm::vec2) + sizeof(float)),
                                         "cut faces of the picture", "a smaller image needs less")),
      area(size),
      ends(volume::Extent2{size}.count()),
      texels(ends.size()) {}

glm::vec3 CutFaceColors::at(float value) const {
  if (ofLabels) return unpacked(value);
  const auto last = static_cast<float>(row.size() - 1);
  const float x = static_cast<float>(window.greyOf(static_cast<double>(value))) * last;
  const auto i = static_cast<std::size_t>(std::min(std::floor(x), last - 1.0f));
  return glm::mix(row[i], row[i + 1], x - static_cast<float>(i));
}

CutFaceColors cutFaceColors(const scene::Scene& scene, const volume::PreparedVolume& volume) {
  const scene::ColorMap map =
      scene.slice.map == scene::ColorMap::automatic ? scene::ColorMap::gray : scene.slice.map;
  return {volume::greyWindow(scene.slice, volume.histogram), scene::colorMapSamples(map, kCutColors),
          volume.labels != nullptr};
}

void setCutFaces(FrameState& frame, Program& program, int unit) {
  const CutFaceColors& colors = *frame.cutFaceColors;
  frame.cutColors = Texture::make2D(frame.gl, GL_RGB32F, {kCutColors, 1});
  frame.cutColors.write(GL_RGB, GL_FLOAT, colors.row.data());
  program.setTexture("uCutFaces", unit, frame.images.at(image::cutFaces).images[0]);
  program.setTexture("uCutColors", unit + 1, frame.cutColors);
  program.set("uCutOfLabels", colors.ofLabels ? 1 : 0);
  program.set("uCutWindow", glm::vec2(colors.window.level, colors.window.width));
}

void addCutFaces(const FrameState& frame, std::vector<float>& rgba) {
  if (!frame.cutFaceColors || !frame.cutFaces) return;
  const std::vector<glm::vec2>& texels = frame.cutFaces->texels;
  for (std::size_t i = 0; i < texels.size(); ++i) {
    if (texels[i].x < 0.0f) continue;
    const glm::vec3 behind = (1.0f - rgba[4 * i + 3]) * frame.cutFaceColors->at(texels[i].y);
    for (std::size_t channel = 0; channel < 3; ++channel)
      rgba[4 * i + channel] += behind[static_cast<int>(channel)];
    rgba[4 * i + 3] = 1.0f;
  }
}

}  // namespace isolux::render
