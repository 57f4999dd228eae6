#include "app/accuracy/light_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include <tbb/global_control.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/light/light_picture.h"
#include "app/study/light_reference.h"
#include "base/quantiles.h"
#include "gi/lattice/half_lattice.h"
#include "gi/reference/reference.h"
#include "render/still_picture.h"
#include "scene/opacity.h"
#include "scene/rules/ghosts.h"
#include "scene/shown_surfaces.h"

namespace isolux::app {

namespace {

constexpr float kNotLit = std::numeric_limits<float>::quiet_NaN();
// Of a traced pixel, in parts of the texels' own: what is left of noise is small beside theirs.
constexpr std::uint32_t kTracedPerStored = 16, kFewestTraced = 1024, kMostTraced = 16384;
constexpr double kNear = 1.25;                 // texels: how far a change counts for others
constexpr int kLeastNear = 2, kMostNear = 48;  // pixels
constexpr double kLeastPart = 0.2;             // of the picture's mean change counts everywhere

bool allOpaque(scene::Scene scene) {
  scene::addGhosts(scene);
  return std::ranges::none_of(scene::shownSurfaces(scene), scene::isSeenThrough<scene::Surface>);
}

gi::StoredSide halfOf(const gi::StoredSide& side, gi::HalfOfTexels half) {
  gi::StoredSide result = side;
  if (side.sky) result.sky = gi::halfOf(*side.sky, half);
  if (side.lamps) result.lamps = gi::halfOf(*side.lamps, half);
  return result;
}

// A number that no other light of the program has, and that is the same for the same half of it.
std::uint64_t versionOfHalf(std::uint64_t version, gi::HalfOfTexels half) {
  return (std::uint64_t{1} << 63) + 2 * version + (half == gi::HalfOfTexels::odd ? 1 : 0);
}

// Gives the renderer its light back at the end, whatever happens.
class LightJury {
 public:
  LightJury(render::Renderer& renderer, const ShownPicture& picture, base::Progress& progress)
      : renderer_(renderer), picture_(picture), progress_(progress) {
    request_.size = picture.size;
    request_.color = false;
    request_.aovs = std::vector{render::Aov::irradiance};
    scene_ = litScene(picture.scene, request_);
  }
  ~LightJury() { renderer_.setLight(picture_.light); }
  LightJury(const LightJury&) = delete;
  LightJury& operator=(const LightJury&) = delete;

  // E, row 0 at the top.
  std::vector<float> draw() {
    return std::move(render::drawStill(renderer_, scene_, request_, progress_).aovs[0].values);
  }

  // Pixels to either side over which changes are averaged: kNear texels, half of the picture's pixels being
  // larger.
  int near() {
    render::FrameRequest request = request_;
    request.aovs = std::vector{render::Aov::voxel};
    const std::vector<float> voxel = render::drawStill(renderer_, scene_, request, progress_).aovs[0].values;
    const gi::PictureLight& light = *picture_.light;
    const auto& lattice = light.sky ? *light.sky : *light.lamps;
    const glm::vec3 texels = 1.0f / glm::max(glm::vec3(lattice.geometry().voxelsPerTexel()), 1e-6f);
    std::vector<double> steps;
    for (std::size_t i = 3; i < voxel.size(); i += 3) {
      const glm::vec3 step(voxel[i] - voxel[i - 3], voxel[i + 1] - voxel[i - 2], voxel[i + 2] - voxel[i - 1]);
      const float texelsApart = glm::length(step * texels);
      if (!std::isnan(texelsApart)) steps.push_back(static_cast<double>(texelsApart));
    }
    if (steps.empty()) return kLeastNear;
    return static_cast<int>(
        std::lround(std::clamp(kNear / std::max(base::median(steps), 1e-9), static_cast<double>(kLeastNear),
                               static_cast<double>(kMostNear))));
  }

  // Squares of the largest difference of a channel between the halves of the texels.
  std::vector<float> changes() {
    std::array<std::vector<float>, 2> drawn;
    for (const gi::HalfOfTexels half : {gi::HalfOfTexels::even, gi::HalfOfTexels::odd}) {
      auto light = std::make_shared<gi::PictureLight>(*picture_.light);
      static_cast<gi::StoredSide&>(*light) = halfOf(*picture_.light, half);
      light->inner = halfOf(picture_.light->inner, half);
      light->version = versionOfHalf(picture_.light->version, half);
      renderer_.setLight(light);
      drawn[half == gi::HalfOfTexels::odd ? 1 : 0] = draw();
    }
    std::vector<float> squares(drawn[0].size() / 3);
    for (std::size_t i = 0; i < squares.size(); ++i) squares[i] = largest(drawn[0], drawn[1], i);
    return squares;
  }

  // E of the pixels, traced.
  std::vector<float> trace(std::vector<std::uint32_t> pixels) {
    const auto environment = gi::loadEnvironment(scene_.light.environment);
    const auto tracer = gi::lightTracerOf(scene_, picture_.volume, progress_);
    const std::size_t threads =
        tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
    gi::Reference reference(
        picture_.volume, tracer, environment, scene_,
        {request_.size, static_cast<int>(std::max<std::size_t>(1, threads)), std::move(pixels)}, progress_);
    const std::uint32_t paths = std::clamp(kTracedPerStored * static_cast<std::uint32_t>(scene_.gi.samples),
                                           kFewestTraced, kMostTraced);
    if (!reference.refineTo(paths, progress_)) progress_.throwIfStopped();
    std::vector<float> traced;
    for (const glm::vec3& e : reference.image().irradiance) traced.insert(traced.end(), {e.x, e.y, e.z});
    return traced;
  }

  static float largest(const std::vector<float>& a, const std::vector<float>& b, std::size_t pixel) {
    float square = 0.0f;
    for (std::size_t c = 3 * pixel; c < 3 * pixel + 3; ++c) {
      const float apart = a[c] - b[c];
      if (std::isnan(apart)) return kNotLit;
      square = std::max(square, apart * apart);
    }
    return square;
  }

 private:
  render::Renderer& renderer_;
  scene::Scene scene_;
  const ShownPicture& picture_;
  base::Progress& progress_;
  render::FrameRequest request_;
};

// Sums over `near` numbers to either side, of a line of `count` numbers that are `stride` apart.
void addUp(double* line, std::size_t count, std::size_t stride, int near, std::vector<double>& sums) {
  sums.assign(count + 1, 0.0);
  for (std::size_t i = 0; i < count; ++i) sums[i + 1] = sums[i] + line[i * stride];
  for (std::size_t i = 0; i < count; ++i) {
    const auto reach = static_cast<std::size_t>(near);
    line[i * stride] = sums[std::min(i + reach + 1, count)] - sums[i - std::min(i, reach)];
  }
}

// The same over squares, three times: nearly a Gaussian.
void spreadOut(std::vector<double>& image, std::size_t width, int near) {
  std::vector<double> sums;
  const std::size_t height = image.size() / width;
  for (int times = 0; times < 3; ++times) {
    for (std::size_t y = 0; y < height; ++y) addUp(&image[y * width], width, 1, near, sums);
    for (std::size_t x = 0; x < width; ++x) addUp(&image[x], height, width, near, sums);
  }
}

// P(at most k of n), each with probability p.
double binomialAtMost(std::size_t k, std::size_t n, double p) {
  double sum = 0.0;
  for (std::size_t i = 0; i <= k; ++i) {
    const auto count = static_cast<double>(i), all = static_cast<double>(n);
    sum += std::exp(std::lgamma(all + 1.0) - std::lgamma(count + 1.0) - std::lgamma(all - count + 1.0) +
                    count * std::log(p) + (all - count) * std::log1p(-p));
  }
  return sum;
}

}  // namespace

double toleranceLimit(std::span<double> scores, bool all) {
  const std::size_t n = scores.size();
  std::ranges::sort(scores);
  if (all && n > 0)
    return scores[static_cast<std::size_t>(std::ceil(kLightLevel * static_cast<double>(n))) - 1];
  // More than `above` of n exceed what kLightLevel of all do not in this share of draws.
  std::size_t above = 0;
  if (n == 0 || binomialAtMost(0, n, 1.0 - kLightLevel) > 1.0 - kLightConfidence)
    return std::numeric_limits<double>::infinity();
  while (binomialAtMost(above + 1, n, 1.0 - kLightLevel) <= 1.0 - kLightConfidence) ++above;
  return scores[n - 1 - above];
}

std::vector<float> smoothedRoots(std::span<const float> squares, std::size_t width, int near) {
  std::vector<double> sums(squares.size()), counts(squares.size());
  for (std::size_t i = 0; i < squares.size(); ++i) {
    if (std::isnan(squares[i])) continue;
    sums[i] = static_cast<double>(squares[i]);
    counts[i] = 1.0;
  }
  const double known = std::accumulate(counts.begin(), counts.end(), 0.0);
  const double mean = std::accumulate(sums.begin(), sums.end(), 0.0) / std::max(known, 1.0);
  spreadOut(sums, width, near);
  spreadOut(counts, width, near);
  std::vector<float> roots(squares.size(), kNotLit);
  for (std::size_t i = 0; i < squares.size(); ++i)
    if (!std::isnan(squares[i]))
      roots[i] = mean <= 0.0 ? 1.0f
                             : static_cast<float>(std::sqrt(std::max(sums[i], 0.0) / counts[i] +
                                                            kLeastPart * kLeastPart * mean));
  return roots;
}

void boundLight(render::Renderer& renderer, const ShownPicture& picture, PictureErrors& errors,
                base::Progress& progress) {
  const gi::PictureLight* const light = picture.light.get();
  if (!light || !(light->sky || light->lamps) || !allOpaque(picture.scene)) return;
  LightJury jury(renderer, picture, progress);
  progress.report(0.0, "bounding light");
  const std::vector<float> shown = jury.draw();
  std::vector<float> bounds =
      smoothedRoots(jury.changes(), static_cast<std::size_t>(picture.size.x), jury.near());
  std::vector<bool> judged(bounds.size());
  for (std::size_t i = 0; i < bounds.size(); ++i) judged[i] = errors.certain[i] && !std::isnan(bounds[i]);
  const std::vector<std::size_t> chosen = chosenPixels(judged, kTracedPixels);
  if (chosen.empty()) return;
  const std::vector<float> traced = jury.trace({chosen.begin(), chosen.end()});
  std::vector<double> scores, offs;
  for (const std::size_t i : chosen) {
    const float square = LightJury::largest(shown, traced, i);
    if (std::isnan(square)) continue;
    const double off = std::sqrt(static_cast<double>(square)), usual = static_cast<double>(bounds[i]);
    offs.push_back(off);
    scores.push_back(off == 0.0 ? 0.0 : off / usual);
  }
  const auto every = static_cast<std::size_t>(std::ranges::count(judged, true));
  const double factor = toleranceLimit(scores, scores.size() == every);
  errors.lightWithin = toleranceLimit(offs, offs.size() == every);
  double sum = 0.0;
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    if (std::isnan(bounds[i])) continue;
    const double bound = factor * static_cast<double>(bounds[i]);
    bounds[i] = judged[i] ? static_cast<float>(bound) : std::numeric_limits<float>::infinity();
    sum += static_cast<double>(shown[3 * i] + shown[3 * i + 1] + shown[3 * i + 2]) / 3.0;
  }
  const auto lit = std::ranges::count_if(bounds, [](float b) { return !std::isnan(b); });
  errors.light = std::move(bounds);
  errors.meanIrradiance = sum / static_cast<double>(lit);
}

}  // namespace isolux::app
