#include "app/accuracy/error_overlay.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "app/accuracy/overlay_painter.h"
#include "app/ready/give_way.h"
#include "base/error.h"
#include "base/numbers.h"
#include "base/quantiles.h"
#include "base/words.h"
#include "scene/color_maps.h"

namespace isolux::app {

namespace {

constexpr const char* kLimits = "limits";
constexpr double kLowEnd = 0.01, kHighEnd = 0.99;

// What is coloured: bounds in the unit of the legend.
struct Overlaid {
  const char* name;
  const char* title;
  const char* unit;
  ErrorImage image;
};
constexpr Overlaid kOverlays[] = {
    {"noise", "Error of depth by noise and sampling", "mm", ErrorImage::noise},
    {"normal_noise", "Error of normals by noise", "degrees", ErrorImage::normalNoise},
    {"kappa_noise", "Error of κ₁ and κ₂ by noise", "1/mm", ErrorImage::kappaNoise},
    {"depth", "Error of depth by arithmetic", "mm", ErrorImage::depth},
    {"normal", "Error of normals by arithmetic", "degrees", ErrorImage::normal},
    {"kappa", "Error of κ₁ and κ₂ by arithmetic", "1/mm", ErrorImage::kappa},
    {"light", "Error of light", "% of its mean", ErrorImage::light}};

const Overlaid& overlaidOf(ErrorImage image) {
  return *std::ranges::find(kOverlays, image, &Overlaid::image);
}

std::vector<double> shownBounds(const PictureErrors& errors, ErrorImage image) {
  const std::vector<float>& bounds = errors.*errorImage(image).bounds;
  const double factor = image == ErrorImage::light ? 100.0 / errors.meanIrradiance : 1.0;
  std::vector<double> shown;
  shown.reserve(bounds.size());
  for (const float bound : bounds) shown.push_back(factor * static_cast<double>(bound));
  return shown;
}

// Bounds that a limit is about, in its unit; none of a limit that is not about pixels.
struct Limited {
  const std::vector<float>* bounds = nullptr;
  double factor = 1.0;
  ErrorImage image = ErrorImage::depth;
};
Limited limitedBy(const Limit& limit, const PictureErrors& errors, double shortestEdgeMm) {
  switch (limit.quantity) {
    case Quantity::depthMm:
      return {&errors.depthMm, 1.0, ErrorImage::depth};
    case Quantity::depthVoxels:
      return {&errors.depthMm, 1.0 / shortestEdgeMm, ErrorImage::depth};
    case Quantity::normal:
      return {&errors.normalDegrees, 1.0, ErrorImage::normal};
    case Quantity::curvature:
      return {&errors.relativeCurvature, 1.0, ErrorImage::kappa};
    case Quantity::light:
      return {&errors.light, 1.0 / errors.meanIrradiance, ErrorImage::light};
    case Quantity::missed:
      break;
  }
  return {};
}

// Round ends of a logarithmic scale, at least a factor of ten apart; nothing where no pixel has a bound above
// 0.
std::optional<glm::dvec2> rangeOf(const std::vector<double>& bounds) {
  std::vector<double> known;
  std::ranges::copy_if(bounds, std::back_inserter(known),
                       [](double bound) { return bound > 0.0 && std::isfinite(bound); });
  if (known.empty()) return std::nullopt;
  glm::dvec2 range(base::niceBelow(base::quantile(known, kLowEnd)),
                   base::niceAbove(base::quantile(known, kHighEnd)));
  if (range.y < 10.0 * range.x) range.x = 0.1 * range.y;
  return range;
}

// Without numbers and colours.
render::Legend emptyLegend(const OverlayRequest& request) {
  render::Legend legend;
  legend.quantity = request.colors ? overlaidOf(*request.colors).title : "Errors";
  legend.unit = request.colors ? overlaidOf(*request.colors).unit : "";
  legend.logarithmic = request.colors.has_value();
  return legend;
}

std::string hatchedLine(const OverlayRequest& request, const Limit& limit) {
  return (request.colors ? "above " : std::string(nameOf(limit.quantity)) + " above ") +
         errorText(limit.quantity, limit.most);
}

std::vector<std::string> hatchedLines(const OverlayRequest& request, const PictureErrors& errors,
                                      const std::vector<std::uint8_t>& hatched) {
  std::vector<std::string> lines;
  if (std::ranges::find(hatched, 1) == hatched.end()) return lines;
  for (const Limit& limit : request.limits) {
    const Limited limited = limitedBy(limit, errors, 1.0);
    if (!limited.bounds || limited.bounds->empty() || (request.colors && limited.image != *request.colors))
      continue;
    lines.push_back(hatchedLine(request, limit));
  }
  if (std::ranges::find(errors.certain, 0) != errors.certain.end())
    lines.emplace_back(lines.empty() ? "not certain" : "or not certain");
  return lines;
}

}  // namespace

std::string overlayNames() {
  return base::joined(kOverlays, ", ", &Overlaid::name) + ", " + kLimits;
}

OverlayRequest parseOverlay(const std::string& text, std::vector<Limit> limits) {
  OverlayRequest request{!text.empty(), {}, std::move(limits)};
  if (text.empty()) return request;
  const auto refuse = [](const std::string& why) { base::throwUsage("", "--error-overlay", why); };
  if (text == kLimits) {
    if (std::ranges::none_of(request.limits,
                             [](const Limit& limit) { return limit.quantity != Quantity::missed; }))
      refuse("limits are those of --error, which names none of depth, normal, curvature or light");
    return request;
  }
  const auto found = std::ranges::find(kOverlays, text, &Overlaid::name);
  if (found == std::end(kOverlays)) refuse("unknown error '" + text + "'; known: " + overlayNames());
  request.colors = found->image;
  return request;
}

std::vector<std::uint8_t> hatchedPixels(const PictureErrors& errors, const OverlayRequest& request,
                                        double shortestEdgeMm) {
  std::vector<std::uint8_t> hatched(errors.certain.size());
  for (std::size_t i = 0; i < hatched.size(); ++i) hatched[i] = errors.certain[i] ? 0 : 1;
  for (const Limit& limit : request.limits) {
    const Limited limited = limitedBy(limit, errors, shortestEdgeMm);
    if (!limited.bounds || (request.colors && limited.image != *request.colors)) continue;
    for (std::size_t i = 0; i < limited.bounds->size(); ++i)  // none of light that is not stored
      if (limited.factor * static_cast<double>((*limited.bounds)[i]) > limit.most) hatched[i] = 1;
  }
  return hatched;
}

glm::ivec2 overlayReserve(const OverlayRequest& request, glm::ivec2 picture) {
  if (!request.asked) return glm::ivec2(0);
  render::Legend legend = emptyLegend(request);
  if (request.colors) {  // over three decades: numbers are no wider over others
    legend.low = 0.002;
    legend.high = 2.0;
    legend.colors = {glm::vec3(0.0F), glm::vec3(1.0F)};
  }
  for (const Limit& limit : request.limits) legend.hatched.push_back(hatchedLine(request, limit));
  legend.hatched.emplace_back("or not certain");
  return render::legendSizeFor(legend, picture);
}

std::optional<render::Tile> paintErrors(const PictureErrors& errors, const OverlayRequest& request,
                                        double shortestEdgeMm, scene::LegendCorner corner,
                                        const std::optional<render::Tile>& taken, render::ColorImage& image) {
  if (request.colors == ErrorImage::light && errors.light.empty())
    base::throwUsage(
        "", "--error-overlay",
        "light: this image has no baked light, or a surface is transparent; --look gi bakes light");
  OverlayPainter painter(image);
  render::Legend legend = emptyLegend(request);
  if (request.colors) {
    const std::vector<double> bounds = shownBounds(errors, *request.colors);
    const std::optional<glm::dvec2> range = rangeOf(bounds);
    painter.color(bounds, range.value_or(glm::dvec2(0.1, 1.0)));
    if (range) {
      legend.low = range->x;
      legend.high = range->y;
      legend.colors = scene::colorMapSamples(scene::ColorMap::cividis, kOverlayColors);
    }
  }
  const std::vector<std::uint8_t> hatched = hatchedPixels(errors, request, shortestEdgeMm);
  painter.hatch(hatched);
  legend.hatched = hatchedLines(request, errors, hatched);
  if (legend.colors.empty() && legend.hatched.empty()) return std::nullopt;
  std::vector<std::uint8_t> seen(errors.depthMm.size());
  for (std::size_t i = 0; i < seen.size(); ++i) seen[i] = std::isnan(errors.depthMm[i]) ? 0 : 1;
  return painter.addLegend(legend, corner, seen, taken);
}

std::unique_ptr<OverlayTask> overlayTask(OverlaySubject asked) {
  const auto work = [subject = std::move(asked)](base::Progress&) {
    giveWay();
    MarkedPicture marked{subject.picture(), {}};
    marked.legend = paintErrors(*subject.errors, subject.request, subject.shortestEdgeMm, subject.corner,
                                subject.taken, marked.image);
    return marked;
  };
  return OverlayTask::start({"", "show errors on the image"}, work);
}

}  // namespace isolux::app
