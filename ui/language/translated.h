// Texts of the layers below, which know no Qt, in the window's language.
//
// The text itself is the key, in the context of the list it stands in; without a translation it is shown as
// it is. tests/ui/language/listed_texts.h goes through the lists, so that none is forgotten.
#pragma once

#include <string_view>

#include <QString>

#include "scene/settings/setting.h"

namespace isolux::ui {

namespace texts {
inline constexpr auto words =
    "words";  // choices, labels, names of looks and phantoms: ui/language/number_text.h
inline constexpr auto settings = "settings";    // meanings of settings
inline constexpr auto units = "units";          // their units
inline constexpr auto reasons = "reasons";      // why settings do not act
inline constexpr auto looks = "looks";          // meanings of looks
inline constexpr auto phantoms = "phantoms";    // meanings of phantoms
inline constexpr auto presets = "presets";      // titles and meanings of presets, and why they do not apply
inline constexpr auto marks = "marks";          // kinds of marks, and what they measure
inline constexpr auto qualities = "qualities";  // of stills
inline constexpr auto views = "views";          // sides to look from
inline constexpr auto passes = "passes";        // states of passes
inline constexpr auto files = "files";          // kinds of files
inline constexpr auto help = "help";            // the table of mouse and keys
}  // namespace texts

QString translated(const char* context, std::string_view english);

// "Volumes (*.nii *.mhd)": what stands before the patterns.
QString translatedFilter(std::string_view filter);

// Returns the name of a setting in undo steps: "colour map" of look.colormap, "light colour"
// of lamps.key.color.
QString plainNameOf(const scene::SettingInfo& setting);  // as the translations know it
QString nameOf(const scene::SettingInfo& setting);

}  // namespace isolux::ui
