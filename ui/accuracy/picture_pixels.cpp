#include "ui/accuracy/picture_pixels.h"

#include <cstring>

namespace isolux::ui {

render::ColorImage colorImageOf(const QImage& image) {
  const QImage bytes = image.convertToFormat(QImage::Format_RGBA8888);
  render::ColorImage color;
  color.size = {bytes.width(), bytes.height()};
  const auto row = static_cast<std::size_t>(4) * static_cast<std::size_t>(bytes.width());
  color.rgba.resize(row * static_cast<std::size_t>(bytes.height()));
  for (int y = 0; y < bytes.height(); ++y)
    std::memcpy(&color.rgba[row * static_cast<std::size_t>(y)], bytes.constScanLine(y), row);
  return color;
}

QImage imageOf(const render::ColorImage& image) {
  return QImage(image.rgba.data(), image.size.x, image.size.y, QImage::Format_RGBX8888)
      .convertToFormat(QImage::Format_RGB32);
}

}  // namespace isolux::ui
