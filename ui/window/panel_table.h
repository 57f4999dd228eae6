// Lists all panels: the window makes, docks and feeds them from the list, and knows none of them by name.
#pragma once

#include <span>

#include "ui/panels/panel.h"

namespace isolux::ui {

struct PanelInfo {
  const char* name;   // in saved layouts, for showPanel() and --panel; never translated
  const char* title;  // on its tab and in the View menu
  Panel* (*make)(QWidget* parent);
  bool atFirst = true;  // shown before the user has chosen; the rest waits in the View menu
};

// From left to right; the first is in front when the window opens.
std::span<const PanelInfo> panels();

}  // namespace isolux::ui
