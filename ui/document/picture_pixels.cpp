#include "ui/document/picture_pixels.h"

#include <cstddef>

namespace isolux::ui {

render::ColorImage colorImageOf(const QImage& image) {
  const QImage bytes = image.convertToFormat(QImage::Format_RGBA8888);
  render::ColorImage colors{{bytes.width(), bytes.height()}, {}, false};
  for (int y = 0; y < bytes.height(); ++y)
    colors.rgba.insert(colors.rgba.end(), bytes.constScanLine(y),
                       bytes.constScanLine(y) + std::ptrdiff_t{4} * bytes.width());
  return colors;
}

QImage imageOf(const render::ColorImage& image) {
  const QImage view(image.rgba.data(), image.size.x, image.size.y, qsizetype{4} * image.size.x,
                    image.transparent ? QImage::Format_RGBA8888 : QImage::Format_RGBX8888);
  return view.copy();
}

}  // namespace isolux::ui
