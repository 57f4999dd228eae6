#include "app/accuracy/error_images.h"

#include <algorithm>
#include <limits>
#include <sstream>

#include "base/error.h"
#include "base/words.h"

namespace isolux::app {

const std::vector<ErrorImageInfo>& errorImages() {
  static const std::vector<ErrorImageInfo> images{
      {ErrorImage::depth, "error_depth", &PictureErrors::depthMm},
      {ErrorImage::normal, "error_normal", &PictureErrors::normalDegrees},
      {ErrorImage::kappa, "error_kappa", &PictureErrors::curvature},
      {ErrorImage::light, "error_light", &PictureErrors::light},
      {ErrorImage::noise, "error_noise", &PictureErrors::depthNoiseMm},
      {ErrorImage::normalNoise, "error_normal_noise", &PictureErrors::normalNoiseDegrees},
      {ErrorImage::kappaNoise, "error_kappa_noise", &PictureErrors::curvatureNoise}};
  return images;
}

const ErrorImageInfo& errorImage(ErrorImage image) {
  return *std::ranges::find(errorImages(), image, &ErrorImageInfo::image);
}

std::string imageNames() {
  return base::joined(render::aovs(), ", ", &render::AovInfo::name) + ", " +
         base::joined(errorImages(), ", ", &ErrorImageInfo::name);
}

WantedImages parseImageList(const std::string& text) {
  WantedImages wanted;
  std::string others, name;
  for (std::istringstream list(text); std::getline(list, name, ',');) {
    const auto isNamed = [&](const auto& info) { return name == info.name; };
    const auto found = std::ranges::find_if(errorImages(), isNamed);
    if (found == errorImages().end()) {
      if (std::ranges::none_of(render::aovs(), isNamed))
        base::throwUsage("", "--aov", "unknown image '" + name + "'; known: " + imageNames());
      others += (others.empty() ? "" : ",") + name;
    } else if (std::ranges::find(wanted.errors, found->image) == wanted.errors.end()) {
      wanted.errors.push_back(found->image);
    }
  }
  if (!others.empty() || wanted.errors.empty()) wanted.aovs = render::parseAovList(others);
  return wanted;
}

std::vector<render::Aov> drawnFor(const WantedImages& wanted) {
  std::vector<render::Aov> aovs = wanted.aovs;
  const auto has = [](const auto& list, auto image) { return std::ranges::find(list, image) != list.end(); };
  if (has(wanted.errors, ErrorImage::light) && !has(aovs, render::Aov::irradiance))
    aovs.push_back(render::Aov::irradiance);
  if (aovs.empty()) aovs.push_back(render::Aov::hit);
  return aovs;
}

std::vector<FloatChannel> channelsOf(const std::vector<render::AovImage>& drawn, const WantedImages& wanted,
                                     const PictureErrors& errors) {
  std::vector<FloatChannel> channels;
  for (const render::AovImage& image : drawn) {
    if (std::ranges::find(wanted.aovs, image.aov) == wanted.aovs.end()) continue;
    const auto info = std::ranges::find(render::aovs(), image.aov, &render::AovInfo::aov);
    const auto count = static_cast<std::size_t>(image.channels);
    for (std::size_t c = 0; c < count; ++c) {
      const std::string suffix = info->channels.at(c);
      FloatChannel channel{suffix.empty() ? info->name : info->name + ("." + suffix), {}};
      channel.values.reserve(image.values.size() / count);
      for (std::size_t i = c; i < image.values.size(); i += count) channel.values.push_back(image.values[i]);
      channels.push_back(std::move(channel));
    }
  }
  const auto pixels = volume::Extent2{errors.size}.count();
  for (const ErrorImage image : wanted.errors) {
    const ErrorImageInfo& info = errorImage(image);
    channels.push_back({info.name, errors.*info.bounds});
    channels.back().values.resize(pixels, std::numeric_limits<float>::quiet_NaN());  // light: none
  }
  return channels;
}

}  // namespace isolux::app
