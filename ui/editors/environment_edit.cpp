#include "ui/editors/environment_edit.h"

#include "scene/rules/relevance.h"

namespace isolux::ui {

namespace {
constexpr auto turnName = "Turn environment";
}

QString whyItCannotTurn(const scene::Scene& scene) {
  const std::string_view why = scene::whyInactive("light.environment.rotation", scene);
  return QString::fromUtf8(why.data(), static_cast<qsizetype>(why.size()));
}

Edit environmentTurned(const scene::Scene& scene, const glm::dvec4& rotation) {
  Edit edit{scene, turnName, "turn environment", false};
  edit.scene.light.environment.rotation = rotation;
  if (scene.gi.mode == scene::GiMode::automatic && !scene.light.environment.file.empty())
    edit.scene.light.environment.moves = true;
  return edit;
}

bool letsEnvironmentMove(const scene::Scene& before, const Edit& edit) {
  return edit.name == turnName && edit.scene.light.environment.moves && !before.light.environment.moves;
}

Edit lightProbeChosen(const scene::Scene& scene, const QString& file) {
  Edit edit{scene, "Choose light probe", {}, false};
  edit.scene.light.environment.file = file.toStdString();
  if (scene::shadingOf(scene) != scene::Shading::gi) edit.scene.look.mode = scene::LookMode::gi;
  return edit;
}

}  // namespace isolux::ui
