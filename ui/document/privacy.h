// Whether the patient is named, kept for this user between runs: on the screen, and in what is saved.
#pragma once

#include <QString>

#include "ui/document/document.h"
#include "volume/read/input/patient.h"

namespace isolux::ui {

struct Privacy {
  bool hideOnScreen = false;
  bool hideInSaved = true;  // pictures and the sessions in them, exported marks, recordings, proposed names
  bool operator==(const Privacy&) const = default;
};
Privacy savedPrivacy();
void keepPrivacy(const Privacy& privacy);
void keepHiddenOnScreen(bool hide);

// The text as it may be shown, or saved: without what names the patient of the volume where the user wants
// it so. `volume` may be null.
QString shownText(const QString& text, const VolumePointer& volume);
QString savedText(const QString& text, const VolumePointer& volume);
// Whom to hide in what is saved: the volume's patient, or nobody.
volume::Patient hiddenInSaved(const VolumePointer& volume);

}  // namespace isolux::ui
