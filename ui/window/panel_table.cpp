#include "ui/window/panel_table.h"

#include "ui/accuracy/accuracy_panel.h"
#include "ui/panels/marks_panel.h"
#include "ui/panels/passes_panel.h"
#include "ui/panels/pieces_panel.h"
#include "ui/panels/settings_panel.h"
#include "ui/panels/volume_panel.h"
#include "ui/presets/looks_panel.h"

namespace isolux::ui {

namespace {

template <class P>
Panel* makePanel(QWidget* parent) {
  return new P(parent);
}

constexpr PanelInfo panelTable[] = {
    {"Settings", QT_TRANSLATE_NOOP("QObject", "Settings"), makePanel<SettingsPanel>},
    {"Looks", QT_TRANSLATE_NOOP("QObject", "Looks"), makePanel<LooksPanel>},
    {"Marks", QT_TRANSLATE_NOOP("QObject", "Measure"), makePanel<MarksPanel>},
    {"Volume", QT_TRANSLATE_NOOP("QObject", "Volume"), makePanel<VolumePanel>},
    {"Pieces", QT_TRANSLATE_NOOP("QObject", "Pieces"), makePanel<PiecesPanel>},
    {"Passes", QT_TRANSLATE_NOOP("QObject", "Timing"), makePanel<PassesPanel>},
    {"Accuracy", QT_TRANSLATE_NOOP("QObject", "Accuracy"), makePanel<AccuracyPanel>, false}};

}  // namespace

std::span<const PanelInfo> panels() {
  return panelTable;
}

}  // namespace isolux::ui
