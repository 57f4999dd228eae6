#include "ui/panels/panel.h"

#include "ui/panels/marks_panel.h"
#include "ui/panels/passes_panel.h"
#include "ui/panels/pieces_panel.h"
#include "ui/panels/settings_panel.h"
#include "ui/panels/volume_panel.h"

namespace isolux::ui {

namespace {

template <class P>
Panel* makePanel(QWidget* parent) {
  return new P(parent);
}

constexpr PanelInfo panelTable[] = {{"Settings", makePanel<SettingsPanel>},
                                    {"Marks", makePanel<MarksPanel>},
                                    {"Volume", makePanel<VolumePanel>},
                                    {"Pieces", makePanel<PiecesPanel>},
                                    {"Passes", makePanel<PassesPanel>}};

}  // namespace

std::span<const PanelInfo> panels() {
  return panelTable;
}

}  // namespace isolux::ui
