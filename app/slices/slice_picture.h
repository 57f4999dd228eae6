// The picture of a slice: grey or coloured values, the noise band, isocontours. No letters (slice_labels.h).
#pragma once

#include "app/slices/slice_content.h"
#include "render/graph/frame.h"

namespace isolux::app {

// Row 0 is the top one. Values beyond the window take the colours of its ends; where there is no value the
// picture is kNoValue. Curves have the width slice.contour_width, antialiased by their exact distance from
// pixel centres, in their surface's colour on a thin dark rim; later surfaces lie on top. Multithreaded but
// for the curves. Throws Error: interrupted; memory.
render::ColorImage slicePicture(const SliceContent& content, const scene::Slice& slice,
                                const volume::GridGeometry& geometry, base::Progress& progress);

inline constexpr std::uint8_t kNoValue[3] = {24, 27, 32};  // sRGB
inline constexpr std::uint8_t kBand[3] = {255, 176, 32};   // what the noise band is tinted with, half

}  // namespace isolux::app
