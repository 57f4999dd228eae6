#include "ui/editors/light_chooser.h"

#include <QTimer>

#include "app/light/light_thumbnail.h"
#include "scene/rules/environment.h"
#include "scene/settings/choice_names.h"
#include "ui/document/environment_edit.h"
#include "ui/document/picture_pixels.h"
#include "ui/language/number_text.h"
#include "ui/widgets/parts.h"

namespace isolux::ui {

namespace {

constexpr int thumbnailPixels = 56;

// In the order of scene::BuiltInLight.
constexpr const char* meanings[] = {
    QT_TRANSLATE_NOOP(
        "QObject",
        "a large soft light from the upper left, a weak light from the right and a rim light from behind"),
    QT_TRANSLATE_NOOP("QObject", "daylight through one window at the left of a room"),
    QT_TRANSLATE_NOOP("QObject", "a cloudy sky: soft light from above"),
    QT_TRANSLATE_NOOP("QObject", "a low warm sun at the left under a blue sky"),
    QT_TRANSLATE_NOOP("QObject", "the studio over a black floor")};

QIcon thumbnailOf(scene::BuiltInLight light, qreal ratio) {
  QImage image = imageOf(app::litBall(light, static_cast<int>(thumbnailPixels * ratio)));
  image.setDevicePixelRatio(ratio);
  return QIcon(QPixmap::fromImage(image));
}

}  // namespace

LightChooser::LightChooser(QWidget* parent) : QWidget(parent) {
  auto* row = lineOf({}, 4);
  layOut(this, row, {0, 2, 0, 2});
  for (const auto light : {scene::BuiltInLight::studio, scene::BuiltInLight::window,
                           scene::BuiltInLight::overcast, scene::BuiltInLight::sunset}) {
    const std::string_view word = scene::choiceName(light);
    const QString name = wordsOf(QString::fromUtf8(word.data(), static_cast<qsizetype>(word.size())));
    auto* button = textButton(name, {}, this);
    nameAndTip(button, tr("Light: %1").arg(name),
               name + ": " + QObject::tr(meanings[static_cast<std::size_t>(light)]));
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button->setIconSize({thumbnailPixels, thumbnailPixels});
    button->setCheckable(true);
    button->setAutoRaise(true);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(button, &QToolButton::clicked, this, [this, light] {
      Q_EMIT edited(builtInLightChosen(scene_, light));
      setScene(scene_);  // a click on the one that is chosen leaves it so
    });
    buttons_.push_back(button);
    row->addWidget(button);
  }
}

void LightChooser::setScene(const scene::Scene& scene) {
  scene_ = scene;
  const scene::Environment& environment = scene.light.environment;
  const bool builtIn = scene::kindOf(environment) == scene::EnvironmentKind::builtIn;
  for (std::size_t i = 0; i < buttons_.size(); ++i)
    buttons_[i]->setChecked(builtIn && environment.builtIn == static_cast<scene::BuiltInLight>(i));
}

void LightChooser::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (drawn_ == 0) drawNext();
}

// One in a turn of the event loop: a few milliseconds each.
void LightChooser::drawNext() {
  buttons_[drawn_]->setIcon(thumbnailOf(static_cast<scene::BuiltInLight>(drawn_), devicePixelRatioF()));
  if (++drawn_ < buttons_.size()) QTimer::singleShot(0, this, &LightChooser::drawNext);
}

}  // namespace isolux::ui
