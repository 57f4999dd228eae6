#include "ui/panels/panel.h"

#include "ui/panels/passes_panel.h"
#include "ui/panels/settings_panel.h"
#include "ui/panels/volume_panel.h"

namespace isolux::ui {

namespace {

template <class P>
Panel* make(QWidget* parent) {
  return new P(parent);
}

constexpr PanelInfo table[] = {
    {"Settings", make<SettingsPanel>}, {"Volume", make<VolumePanel>}, {"Passes", make<PassesPanel>}};

}  // namespace

std::span<const PanelInfo> panels() {
  return table;
}

}  // namespace isolux::ui
