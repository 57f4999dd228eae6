// The look of the program: a calm Fusion theme, dark or light, and the few colours that widgets draw with
// themselves.
//
// What is painted takes the colours when it is painted, texts in a colour of their own by setInk(): then both
// follow when the theme changes. Qt tells widgets of it by QEvent::PaletteChange.
#pragma once

#include "ui/theme/theme.h"

class QWidget;

namespace isolux::ui {

inline ThemeColours colours;  // of the theme that is on

// After the QApplication is made, and whenever another theme is chosen.
void applyTheme(Theme theme);
Theme theme();  // the one that was chosen last

// The colour of a label's text.
enum class Ink { normal, quiet, error, warning, good };
void setInk(QWidget* widget, Ink ink);

}  // namespace isolux::ui
