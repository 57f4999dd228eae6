#include "render/passes/gloss_passes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/passes/frame_state.h"
#include "render/passes/light_passes.h"
#include "scene/rules/needs.h"
#include "volume/field/reconstruct.h"
#include "volume/parallel/parallel_loops.h"

namespace isolux::render {

namespace {

constexpr int kPixelsOfGlossCell = 2,
              kPixelsInMotion = 4;  // per axis, of a cell; in frames of one ray a pixel
constexpr int kAround = 4;          // cells per axis that a result is the mean of
constexpr int kFilteredSize = 192;  // texels per axis of an octahedron's square
// Mirror directions turn twice as far as normals.
constexpr float kSharpnessOfExponent = 1.0f, kMostSharp = 256.0f;
constexpr std::size_t kCellsAtOnce = 1024;
constexpr float kNotTraced = -1.0f;

int cellOf(const FrameRequest& request) {
  return request.supersampling == 1 ? kPixelsInMotion : kPixelsOfGlossCell * request.supersampling;
}

struct Cells {
  glm::ivec2 first, size;  // in the whole image
};

Cells cellsOf(const FrameState& frame) {
  const int cell = cellOf(frame.request);
  const glm::ivec2 low = frame.rayOrigin() / cell;
  return {low, (frame.rayOrigin() + frame.raySize() + cell - 1) / cell - low};
}

// A number for each square of kAround cells: what its cells trace together is one pattern.
std::uint32_t seedOf(glm::ivec2 cell) {
  const glm::ivec2 square = cell / kAround;
  std::uint32_t h =
      static_cast<std::uint32_t>(square.x) * 0x9e3779b1u ^ static_cast<std::uint32_t>(square.y) * 0x85ebca77u;
  h = (h ^ (h >> 15)) * 0x2c1b3c6du;
  return h ^ (h >> 13);
}

// The place of a cell within its square, so that neighbours are far apart in the pattern.
std::uint32_t placeOf(glm::ivec2 cell) {
  static constexpr std::uint32_t places[kAround][kAround] = {
      {0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};
  return places[cell.y % kAround][cell.x % kAround];
}

// Without light that knows reflections, there are none.
void declareGloss(Declaring& d) {
  if (!d.asked.light.gloss) return;
  d.settings({"camera.", "isosurface.inside", "surfaces.#.roughness"});
  d.ofSurfaces("glossy surfaces", [](const scene::Surface& surface) { return surface.specular > 0.0; });
  d.input("light", d.asked.light.version);
}

// One point of a cell that is traced.
struct CellPoint {
  int surface = -1;
  float depth = kNotTraced;
  glm::vec3 place{0.0f};   // mm
  float tolerance = 0.0f;  // mm; how far off the tangent plane cells of the same piece of surface are
  glm::vec3 normal{0.0f};
  float sharpness = 0.0f;  // 1 / (1 - cosine) of normals at which a cell around it counts no more
};

// How much a cell counts for another: none unless both show the same piece of surface and reflect much the
// same.
float fitOf(const CellPoint& other, const CellPoint& own) {
  if (other.surface != own.surface) return 0.0f;
  if (std::abs(glm::dot(other.place - own.place, own.normal)) > own.tolerance) return 0.0f;
  const float fits = std::max(1.0f - own.sharpness * (1.0f - glm::dot(other.normal, own.normal)), 0.0f);
  return fits * fits;
}

struct WeightedReflection {
  gi::Reflection sum{.lamps = glm::vec3(0.0f)};
  float weights = 0.0f;

  // Times the filtered environment. At most half of the lobe is below the surface and comes from above, too,
  // so that all of it is at most twice that; the fewer rays there are, the more of a ratio above 1 is noise.
  float visiblePart() const {
    if (!(sum.open > 0.0f)) return 1.0f;
    return std::min(sum.visible / sum.open, 1.0f + std::min(weights / (kAround * kAround), 1.0f));
  }
};

// The means of the cells around each that fit: along rows, then along columns of what rows have.
std::vector<WeightedReflection> smoothed(const std::vector<gi::Reflection>& of,
                                         const std::vector<CellPoint>& cells, glm::ivec2 size) {
  std::vector<WeightedReflection> rows(of.size()), result(of.size());
  const auto low = [](int at) { return std::max(at - kAround / 2, 0); };
  const auto end = [](int at, int count) { return std::min(at + kAround / 2, count); };
  const auto index = [&](int x, int y) { return volume::Extent2{size}.index(x, y); };
  volume::parallelEach(size.y, [&](int y) {
    for (int x = 0; x < size.x; ++x) {
      const std::size_t at = index(x, y);
      if (cells[at].surface < 0) continue;
      for (int u = low(x); u < end(x, size.x); ++u) {
        const std::size_t i = index(u, y);
        const float weight = i == at ? 1.0f : fitOf(cells[i], cells[at]);
        if (!(weight > 0.0f)) continue;
        rows[at].sum.add(of[i], weight);
        rows[at].weights += weight;
      }
    }
  });
  volume::parallelEach(size.y, [&](int y) {
    for (int x = 0; x < size.x; ++x) {
      const std::size_t at = index(x, y);
      if (cells[at].surface < 0) continue;
      WeightedReflection& all = result[at];
      for (int v = low(y); v < end(y, size.y); ++v) {
        const std::size_t i = index(x, v);
        const float weight = i == at ? 1.0f : fitOf(cells[i], cells[at]);
        if (!(weight > 0.0f)) continue;
        all.sum.add(rows[i].sum, weight);
        all.weights += weight * rows[i].weights;
      }
      all.sum.met /= all.weights;
      all.sum.unoccluded /= all.weights;
      all.sum.lamps /= all.weights;
    }
  });
  return result;
}

// Bilinear, from middle to middle of pixels.
glm::vec3 between(const gi::Environment& map, double column, double row) {
  const int width = map.width(), height = map.height();
  const int left = static_cast<int>(std::floor(column - 0.5)), top = static_cast<int>(std::floor(row - 0.5));
  const auto x = static_cast<float>(column - 0.5 - left), y = static_cast<float>(row - 0.5 - top);
  const auto at = [&](int c, int r) {
    return map.pixels()[static_cast<std::size_t>(std::clamp(r, 0, height - 1) * width + (c + width) % width)];
  };
  return glm::mix(glm::mix(at(left, top), at(left + 1, top), x),
                  glm::mix(at(left, top + 1), at(left + 1, top + 1), x), y);
}

// The direction of a point of the square [-1, 1]^2 that an octahedron is unfolded to (gloss.glsl).
glm::dvec3 ofOctahedron(glm::dvec2 at) {
  glm::dvec3 direction(at, 1.0 - std::abs(at.x) - std::abs(at.y));
  if (direction.z < 0.0) {
    direction.x = (1.0 - std::abs(at.y)) * (at.x >= 0.0 ? 1.0 : -1.0);
    direction.y = (1.0 - std::abs(at.x)) * (at.y >= 0.0 ? 1.0 : -1.0);
  }
  return glm::normalize(direction);
}

// `first`: the cell in the whole image that the images begin with.
void traceReflections(FrameState& frame, const Target& target, const Target& found, glm::ivec2 first) {
  const glm::ivec2 size(found.images[0].size());
  const std::vector<float> places = found.images[0].readFloats(4), normals = found.images[1].readFloats(4),
                           rays = found.images[2].readFloats(4);
  const gi::PictureLight& light = *frame.light;
  const volume::Grid& grid = frame.volume->grid();
  const bool trilinear = frame.scene->hit.field == scene::Field::trilinear;
  // Some times the width of a cell.
  const auto tolerancePerDepth = static_cast<float>(16.0 * frame.view->halfExtent.y * cellOf(frame.request) /
                                                    (frame.request.size.y * frame.request.supersampling));
  const auto vectorAt = [](const std::vector<float>& of, std::size_t i) {
    return glm::vec3(of[4 * i], of[4 * i + 1], of[4 * i + 2]);
  };
  std::vector<CellPoint> cells(places.size() / 4);
  std::vector<std::size_t> of;  // the cells that are traced
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const int which = static_cast<int>(places[4 * i + 3]);
    if (which < 0) continue;
    const Surface& surface = frame.surfaces[static_cast<std::size_t>(which)];
    if (!(surface.specular > 0.0) || !light.gloss->of(static_cast<float>(surface.roughness))) continue;
    cells[i].surface = which;
    of.push_back(i);
  }
  std::vector<gi::GlossPoint> points(of.size());
  volume::parallelRanges(of.size(), kCellsAtOnce, [&](const volume::Indices<std::size_t>& range) {
    for (std::size_t k = range.first; k < range.last; ++k) {
      const std::size_t i = of[k];
      const Surface& surface = frame.surfaces[static_cast<std::size_t>(cells[i].surface)];
      const auto roughness = static_cast<float>(surface.roughness);
      const float exponent = gi::glossExponent(roughness), depth = normals[4 * i + 3];
      const glm::ivec2 cell = first + volume::Extent2{size}.at(i);
      const glm::vec3 voxel = vectorAt(places, i), normal = vectorAt(normals, i), ray = vectorAt(rays, i);
      const double value = trilinear ? surface.value : volume::sampleTrilinear(grid, glm::dvec3(voxel)).value;
      cells[i] = {cells[i].surface,
                  depth,
                  glm::vec3(grid.geometry().worldFromVoxel * glm::dvec4(voxel, 1.0)),
                  tolerancePerDepth * (frame.view->orthographic ? 1.0f : depth),
                  normal,
                  std::min(kSharpnessOfExponent * exponent, kMostSharp)};
      points[k] = {voxel,         grid.storedIsovalue(value),
                   normal,        ray - 2.0f * std::min(glm::dot(ray, normal), 0.0f) * normal,
                   exponent,      seedOf(cell),
                   placeOf(cell), light.gloss->of(roughness).get()};
    }
  });
  std::vector<gi::Reflection> traced(points.size()), alone(cells.size());
  if (!gi::reflectionsOf(light, points, 1, traced, frame.request.stop)) return;
  std::vector<glm::vec3>& hits = frame.layer.empty() ? frame.reflectedHits : frame.hitsBehind.outer;
  for (std::size_t k = 0; k < of.size(); ++k) {
    alone[of[k]] = traced[k];
    if (traced[k].met > 0.0f) hits.push_back(traced[k].hit);
  }
  const std::vector<WeightedReflection> all = smoothed(alone, cells, size);
  std::vector<glm::vec4> reflected;
  std::vector<glm::u8vec4> lamps;
  std::vector<float> depths;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const gi::Reflection& mean = all[i].sum;
    const glm::vec3 surface = mean.baked > 0.01f ? mean.light / mean.baked : mean.unoccluded;
    reflected.emplace_back(mean.met * surface, all[i].visiblePart());
    lamps.emplace_back(glm::round(255.0f * mean.lamps), 255);
    depths.push_back(cells[i].depth);
  }
  target.images[0].write(GL_RGBA, GL_FLOAT, reflected.data());
  target.images[1].write(GL_RGBA, GL_UNSIGNED_BYTE, lamps.data());
  target.images[2].write(GL_RED, GL_FLOAT, depths.data());
}

void declareReflections(Declaring& d) {
  const LightState& light = d.asked.light;
  d.reads(image::surface).reads(image::gradient).reads(image::light).writes(image::reflections);
  d.notNeeded("no surface is glossy");
  declareGloss(d);
  if (!light.gloss) return;
  d.pictureSize().input("stored light", light.skyRevision, light.lampsRevision);
}

void drawReflections(FrameState& frame) {
  const Cells cells = cellsOf(frame);
  Target& target = frame.images.make(frame.gl, image::reflections + frame.layer, cells.size,
                                     {GL_RGBA16F, GL_RGBA8, GL_R32F});
  static constexpr float open[4] = {0.0f, 0.0f, 0.0f, 1.0f}, white[4] = {1.0f, 1.0f, 1.0f, 1.0f},
                         none[4] = {kNotTraced};
  frame.clear(target, {open, white, none});
  if (frame.layer.empty()) frame.reflectedHits.clear();
  if (frame.empty() || !frame.light || !frame.light->gloss) return;
  const std::string name = "points of reflections";
  Target& points = frame.images.make(frame.gl, name, cells.size, {GL_RGBA32F, GL_RGBA32F, GL_RGBA32F});
  Program& p = frame.program("reflections.frag.glsl");
  frame.setView(p);
  frame.setPoint(p, 0);
  p.set("uCell", cellOf(frame.request));
  p.set("uFirstCell", cells.first);
  frame.begin(points);
  frame.drawFullscreen(p);
  traceReflections(frame, target, points, cells.first);
  frame.images.drop(name);
}

}  // namespace

Pass reflectionsPass() {
  const LookInput input{
      image::reflections, "GLOSS", {"uReflected", "uLampsSeen", "uCellDepth"}, scene::showsGloss};
  return {pass::reflections, declareReflections, drawReflections, input, {.ofCrossing = true}};
}

int reachOfGloss() {
  return kPixelsInMotion * (kAround / 2 + 2);
}

void GlossUniforms::declare(Declaring& d) {
  declareGloss(d);
  if (d.asked.light.gloss) d.settings({"surfaces.#.specular"});
}

void GlossUniforms::set(FrameState& frame, Program& p, int unit) {
  const std::size_t surfaces = placesOf(frame.surfaces.size());
  std::vector<float> specular(surfaces, 0.0f), roughness(surfaces, 1.0f), layers(surfaces, 0.0f);
  const gi::GlossLight* const gloss = frame.light ? frame.light->gloss.get() : nullptr;
  if (!gloss) return p.set("uReflectance", specular);
  if (of_ != gloss->environments) {
    std::vector<glm::vec3> texels;
    for (const auto& environment : gloss->environments) {
      const gi::Environment& map = environment->filtered();
      for (int y = 0; y < kFilteredSize; ++y)
        for (int x = 0; x < kFilteredSize; ++x) {
          const glm::dvec3 d =
              ofOctahedron((2.0 * glm::dvec2(x, y) + 1.0) / static_cast<double>(kFilteredSize) - 1.0);
          texels.push_back(between(map, (0.5 + std::atan2(d.x, d.y) / (2.0 * std::numbers::pi)) * map.width(),
                                   std::acos(std::clamp(d.z, -1.0, 1.0)) / std::numbers::pi * map.height()));
        }
    }
    environments_ = Texture();
    environments_ = Texture::make2D(
        frame.gl, GL_RGBA16F, {kFilteredSize, kFilteredSize * static_cast<int>(gloss->environments.size())});
    environments_.write(GL_RGB, GL_FLOAT, texels.data());
    environments_.setFilter(GL_LINEAR);
    of_ = gloss->environments;
  }
  p.setTexture("uFiltered", unit, environments_);
  p.set("uGlossFromWorld", frame.light->environmentFromWorld);
  p.set("uGlossScale", frame.light->backgroundScale);
  p.set("uFirstCell", cellsOf(frame).first);
  p.set("uCellSize", static_cast<float>(cellOf(frame.request)));
  frame.lighting->setLocalLight(frame, p);
  for (std::size_t i = 0; i < frame.surfaces.size(); ++i) {
    const auto of = static_cast<float>(frame.surfaces[i].roughness);
    const auto found = std::ranges::find(of_, of, &gi::FilteredEnvironment::roughness);
    if (found == of_.end()) continue;  // matt
    specular[i] = static_cast<float>(frame.surfaces[i].specular);
    roughness[i] = of;
    layers[i] = static_cast<float>(found - of_.begin());
  }
  p.set("uReflectance", specular);
  p.set("uRoughness", roughness);
  p.set("uFilteredLayer", layers);
}

}  // namespace isolux::render
