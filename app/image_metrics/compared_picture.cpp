#include "app/image_metrics/compared_picture.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "base/color.h"

namespace isolux::app {

namespace {

glm::dvec3 screenColor(const glm::dvec3& linear) {
  return {base::encodeSrgb(linear.x), base::encodeSrgb(linear.y), base::encodeSrgb(linear.z)};
}

}  // namespace

ComparedPicture comparedPicture(const render::ColorImage& image) {
  ComparedPicture picture{image.size, {}};
  picture.linear.reserve(image.rgba.size() / 4);
  const auto decoded = [&](std::size_t i) { return base::decodeSrgb(image.rgba[i] / 255.0); };
  for (std::size_t i = 0; i < image.rgba.size(); i += 4)
    picture.linear.emplace_back(decoded(i), decoded(i + 1), decoded(i + 2));
  return picture;
}

ComparedPicture comparedPicture(const render::LinearImage& image) {
  ComparedPicture picture{image.size, {}};
  picture.linear.reserve(image.rgba.size() / 4);
  const auto shown = [&](std::size_t i) { return std::clamp(static_cast<double>(image.rgba[i]), 0.0, 1.0); };
  for (std::size_t i = 0; i < image.rgba.size(); i += 4)
    picture.linear.emplace_back(shown(i), shown(i + 1), shown(i + 2));
  return picture;
}

ComparedPicture blockMeans(const ComparedPicture& picture, int block) {
  assert(block > 0 && picture.size.x % block == 0 && picture.size.y % block == 0);
  ComparedPicture means{picture.size / block, {}};
  means.linear.resize(volume::Extent2{means.size}.count());
  std::size_t from = 0;
  for (int y = 0; y < picture.size.y; ++y)
    for (int x = 0; x < picture.size.x; ++x, ++from)
      means.linear[volume::Extent2{means.size}.index(x / block, y / block)] += picture.linear[from];
  for (glm::dvec3& mean : means.linear) mean /= static_cast<double>(block * block);
  return means;
}

std::vector<bool> edgePixels(const ComparedPicture& picture, int block, double contrast) {
  const volume::Extent2 extent{picture.size / block};
  std::vector<double> least(extent.count(), 1.0), most(extent.count(), 0.0);
  std::size_t from = 0;
  for (int y = 0; y < picture.size.y; ++y)
    for (int x = 0; x < picture.size.x; ++x, ++from) {
      const std::size_t to = extent.index(x / block, y / block);
      const double luma = base::luminance(screenColor(picture.linear[from]));
      least[to] = std::min(least[to], luma);
      most[to] = std::max(most[to], luma);
    }
  std::vector<bool> edges(extent.count());
  for (std::size_t i = 0; i < edges.size(); ++i) edges[i] = most[i] - least[i] > contrast;
  return edges;
}

double rmsDifference(const ComparedPicture& a, const ComparedPicture& b, const std::vector<bool>& among) {
  assert(a.size == b.size);
  double squares = 0.0;
  std::size_t pixels = 0;
  for (std::size_t i = 0; i < a.linear.size(); ++i) {
    if (!among.empty() && !among[i]) continue;
    const glm::dvec3 difference = screenColor(a.linear[i]) - screenColor(b.linear[i]);
    squares += difference.x * difference.x + difference.y * difference.y + difference.z * difference.z;
    ++pixels;
  }
  if (pixels == 0) return std::numeric_limits<double>::quiet_NaN();
  return std::sqrt(squares / (3.0 * static_cast<double>(pixels)));
}

}  // namespace isolux::app
