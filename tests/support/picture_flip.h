// How different two pictures look (app/image_metrics/flip.h), for tests of pictures: those that link
// isolux::app.
#pragma once

#include "app/image_metrics/flip.h"
#include "render/graph/frame.h"

namespace isolux::test {

// Mean FLIP, 0 to 1; both of one size.
inline double flipOf(const render::ColorImage& a, const render::ColorImage& b) {
  return app::meanFlip(app::comparedPicture(a), app::comparedPicture(b));
}

}  // namespace isolux::test
