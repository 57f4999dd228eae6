#include "ui/panels/panel.h"

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
    {QT_TRANSLATE_NOOP("QObject", "Settings"), makePanel<SettingsPanel>},
    {QT_TRANSLATE_NOOP("QObject", "Looks"), makePanel<LooksPanel>},
    {QT_TRANSLATE_NOOP("QObject", "Marks"), makePanel<MarksPanel>},
    {QT_TRANSLATE_NOOP("QObject", "Volume"), makePanel<VolumePanel>},
    {QT_TRANSLATE_NOOP("QObject", "Pieces"), makePanel<PiecesPanel>},
    {QT_TRANSLATE_NOOP("QObject", "Passes"), makePanel<PassesPanel>},
    {QT_TRANSLATE_NOOP("QObject", "Accuracy"), makePanel<AccuracyPanel>, false}};

}  // namespace

std::span<const PanelInfo> panels() {
  return panelTable;
}

}  // namespace isolux::ui
