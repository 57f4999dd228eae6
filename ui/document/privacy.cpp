#include "ui/document/privacy.h"

#include <QSettings>

#include "app/documents/anonymous.h"

namespace isolux::ui {

namespace {

constexpr auto screenKey = "privacy/hideOnScreen", savedKey = "privacy/hideInSaved";

QString hiddenText(const QString& text, const VolumePointer& volume) {
  if (!volume) return text;
  const volume::Patient patient = volume::patientOf(volume->volume.grid);
  return patient.known() ? QString::fromStdString(app::withoutPatient(text.toStdString(), patient)) : text;
}

}  // namespace

Privacy savedPrivacy() {
  const QSettings kept;
  const Privacy standard;
  return {kept.value(screenKey, standard.hideOnScreen).toBool(),
          kept.value(savedKey, standard.hideInSaved).toBool()};
}

void keepPrivacy(const Privacy& privacy) {
  QSettings kept;
  kept.setValue(screenKey, privacy.hideOnScreen);
  kept.setValue(savedKey, privacy.hideInSaved);
}

void keepHiddenOnScreen(bool hide) {
  Privacy privacy = savedPrivacy();
  privacy.hideOnScreen = hide;
  keepPrivacy(privacy);
}

QString shownText(const QString& text, const VolumePointer& volume) {
  return savedPrivacy().hideOnScreen ? hiddenText(text, volume) : text;
}

QString savedText(const QString& text, const VolumePointer& volume) {
  const Privacy privacy = savedPrivacy();
  return privacy.hideInSaved || privacy.hideOnScreen ? hiddenText(text, volume) : text;
}

volume::Patient hiddenInSaved(const VolumePointer& volume) {
  return volume && savedPrivacy().hideInSaved ? volume::patientOf(volume->volume.grid) : volume::Patient{};
}

}  // namespace isolux::ui
