// How large the window's texts and controls are.
#pragma once

namespace isolux::ui {

inline constexpr int smallestScale = 75, largestScale = 300;  // per cent

// Makes windows of this process so large, beside what the screen's own scale is: whole pictures of the window
// at that size, no enlarged ones. Before the application is made; what the environment says (QT_SCALE_FACTOR)
// holds.
void applyInterfaceScale(int percent);

}  // namespace isolux::ui
