// The colours of the window (dark and light, and how well they read), and its scale.
//
// Text has a contrast of at least 4.5 : 1 against what it stands on, edges of controls and lines that tell
// something 3 : 1 (WCAG 2.1, AA); what is disabled is exempt. A test computes them.
#pragma once

#include <QColor>

namespace isolux::ui {

enum class Theme { dark, light, system };

struct ThemeColours {
  QColor window, base, raised;  // panels; fields and plots; buttons and tips
  QColor border;                // between areas
  QColor edge;                  // of fields, boxes and buttons
  QColor text, quietText, disabledText;
  QColor accent, onAccent;  // what is chosen, and text on it
  QColor isovalue, onIsovalue;
  QColor error, warning, good;
  QColor errorArea, noteArea;  // of messages
  QColor plotInside, plotOutside, plotInk;
};
const ThemeColours& coloursOf(Theme theme);  // system: what systemIsDark() says

// As Qt or the desktop say; dark where nobody does.
bool systemIsDark();

// (L1 + 0.05) / (L2 + 0.05) of the relative luminances, 1 to 21.
double contrast(const QColor& a, const QColor& b);

// How large the window's texts and controls are.
inline constexpr int smallestScale = 75, largestScale = 300;  // per cent

// Makes windows of this process so large, beside what the screen's own scale is; before the application is
// made. Above 100 % all of them is drawn at that size (QT_SCALE_FACTOR; what the environment says holds).
// Below, where Qt 6.4 leaves parts of a window unpainted, texts and the style's spaces alone are smaller:
// textScale().
void applyInterfaceScale(int percent);
double textScale();  // 0.75 to 1

}  // namespace isolux::ui
