// The colours of the window: dark and light, and how well they read.
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

}  // namespace isolux::ui
