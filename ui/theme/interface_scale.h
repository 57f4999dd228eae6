// How large the window's texts and controls are.
#pragma once

namespace isolux::ui {

inline constexpr int smallestScale = 75, largestScale = 300;  // per cent

// Makes windows of this process so large, beside what the screen's own scale is; before the application is
// made. Above 100 % all of them is drawn at that size (QT_SCALE_FACTOR; what the environment says holds).
// Below, where Qt 6.4 leaves parts of a window unpainted, texts and the style's spaces alone are smaller:
// textScale().
void applyInterfaceScale(int percent);
double textScale();  // 0.75 to 1

}  // namespace isolux::ui
