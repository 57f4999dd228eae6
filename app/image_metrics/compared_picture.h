// A picture as comparisons take it: linear colours, opaque, as a screen shows them.
#pragma once

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/graph/frame.h"

namespace isolux::app {

struct ComparedPicture {
  glm::ivec2 size{0};
  std::vector<glm::dvec3> linear;  // BT.709, each component in [0, 1]; row 0 at the top, x fastest
};

// Alpha is left out: colours that a transparent picture keeps are compared as if they were opaque.
ComparedPicture comparedPicture(const render::ColorImage& image);
// Cut off to [0, 1], as a screen does it.
ComparedPicture comparedPicture(const render::LinearImage& image);

// The mean of blocks of `block` x `block` pixels; the size is a multiple of it.
ComparedPicture blockMeans(const ComparedPicture& picture, int block);

// Which pixels of blockMeans() lie on edges: within their block the luma (of sRGB values, in parts of the
// full range) differs by more than `contrast`.
std::vector<bool> edgePixels(const ComparedPicture& picture, int block, double contrast);

// Root mean square of the differences of sRGB values over pixels and channels, in parts of the full range;
// `among`: of these pixels alone, where it is not empty. NaN without a pixel. Both of one size.
double rmsDifference(const ComparedPicture& a, const ComparedPicture& b, const std::vector<bool>& among = {});

}  // namespace isolux::app
