#include "ui/document/environment_edit.h"

#include <cmath>

#include <QFileInfo>
#include <QObject>

#include "scene/rules/environment.h"
#include "scene/rules/relevance.h"
#include "ui/language/translated.h"

namespace isolux::ui {

namespace {
constexpr auto turnName = QT_TRANSLATE_NOOP("QObject", "Turn environment");

void showGi(scene::Scene& scene) {
  if (scene::shadingOf(scene) != scene::Shading::gi) scene.look.mode = scene::LookMode::gi;
}
}  // namespace

QString whyItCannotTurn(const scene::Scene& scene) {
  return translated(texts::reasons, scene::whyInactive("light.environment.rotation", scene));
}

Edit environmentTurned(const scene::Scene& scene, const glm::dvec4& rotation, scene::WorldAxes axes) {
  Edit edit{scene, QObject::tr(turnName), "turn environment", false};
  scene::setRotation(edit.scene.light.environment, rotation, axes);
  return lettingMove(edit);
}

Edit environmentTurnedBy(const scene::Scene& scene, double degrees) {
  Edit edit{scene, QObject::tr(turnName), "turn environment", false};
  double& azimuth = edit.scene.light.environment.azimuth;
  azimuth = std::remainder(azimuth + degrees, 360.0);
  return lettingMove(edit);
}

Edit lettingMove(Edit turned) {
  scene::Environment& environment = turned.scene.light.environment;
  if (turned.scene.gi.mode == scene::GiMode::automatic && !scene::hasOneColor(environment))
    environment.moves = true;
  return turned;
}

bool letsEnvironmentMove(const scene::Scene& before, const Edit& edit) {
  const scene::Environment &was = before.light.environment, &is = edit.scene.light.environment;
  const bool turns =
      was.rotation != is.rotation || was.azimuth != is.azimuth || was.elevation != is.elevation;
  return turns && is.moves && !was.moves;
}

bool isLightProbe(const QString& file) {
  const QString suffix = QFileInfo(file).suffix().toLower();
  return suffix == "hdr" || suffix == "exr";
}

Edit lightProbeChosen(const scene::Scene& scene, const QString& file) {
  Edit edit{scene, QObject::tr("Choose environment map")};
  edit.scene.light.environment.file = file.toStdString();
  showGi(edit.scene);
  return edit;
}

Edit builtInLightChosen(const scene::Scene& scene, scene::BuiltInLight light) {
  Edit edit{scene, QObject::tr("Choose light")};
  scene::chooseBuiltIn(edit.scene.light.environment, light);
  showGi(edit.scene);
  return edit;
}

}  // namespace isolux::ui
