#include "ui/panels/light_status.h"

#include <algorithm>
#include <cmath>

#include <QProgressBar>
#include <QToolButton>

#include "ui/editors/elided_label.h"
#include "ui/language/number_text.h"
#include "ui/theme/icons.h"
#include "ui/theme/style.h"
#include "ui/widgets/parts.h"

namespace isolux::ui {

namespace {

using Phase = app::LightState::Phase;

double fractionOf(const gi::BakeCounters& counters) {
  if (counters.samplesWanted == 0) return 1.0;
  return std::clamp(static_cast<double>(counters.samplesDone) / static_cast<double>(counters.samplesWanted),
                    0.0, 1.0);
}

QString percentText(double fraction) {  // 100 % only when it is done
  return QString("%1 %").arg(static_cast<int>(std::floor(100.0 * fraction)));
}

QString stateText(const app::LightState& state, bool cancelled) {
  if (cancelled) return QObject::tr("Light stopped");
  const gi::BakeCounters& counters = state.counters;
  const QString percent = percentText(fractionOf(counters));
  const auto withTimeLeft = [&](QStringList parts) {
    if (counters.secondsLeft > 0.0) parts += QObject::tr("%1 left").arg(durationText(counters.secondsLeft));
    return parts.join(" · ");
  };
  switch (state.phase) {
    case Phase::off:
      return {};
    case Phase::preparing:
      return QObject::tr("Light: preparing…");
    case Phase::baking:
      return QObject::tr("Light: %1")
          .arg(withTimeLeft(counters.raysPerSecond > 0.0
                                ? QStringList{percent, rateText(counters.raysPerSecond)}
                                : QStringList{percent}));
    case Phase::paused:
      return withTimeLeft({QObject::tr("Light paused at %1").arg(percent)});
    case Phase::finished:
      return QObject::tr("Light complete");
    case Phase::failed:
      return QObject::tr("No light");
  }
  return {};
}

QString whyText(const app::LightState& state) {
  if (state.error) return QString::fromStdString(state.error->what());
  QString text = QObject::tr("Baked: %1").arg(QString::fromStdString(state.mode));
  if (!state.choice.reason.empty())
    text += "\n" + QString::fromStdString(state.choice.reason).replace("; ", ";\n");
  const gi::BakeCounters& counters = state.counters;
  if (counters.texelsLit > 0)
    text += '\n' + QObject::tr("%1 texels lit, %2 million rays in %3")
                       .arg(counters.texelsLit)
                       .arg(numberText(static_cast<double>(counters.rays) * 1e-6, 3),
                            durationText(counters.seconds));
  return text;
}

}  // namespace

QString rateText(double raysPerSecond) {
  if (raysPerSecond >= 1e6) return QObject::tr("%1 million rays/s").arg(numberText(raysPerSecond * 1e-6, 2));
  if (raysPerSecond >= 1e3) return QObject::tr("%1 thousand rays/s").arg(numberText(raysPerSecond * 1e-3, 2));
  return QObject::tr("%1 rays/s").arg(numberText(raysPerSecond, 2));
}

QString unfinishedLightText(const app::LightState& state, bool cancelled) {
  const bool onItsWay = state.phase == Phase::preparing || state.phase == Phase::baking ||
                        state.phase == Phase::paused || (cancelled && state.phase != Phase::off);
  if (!onItsWay) return {};
  // While it is prepared nothing is counted yet: no texel is there.
  const double fraction = state.phase == Phase::preparing ? 0.0 : fractionOf(state.counters);
  return fraction < 1.0 ? QObject::tr("light %1 complete").arg(percentText(fraction)) : QString();
}

QString unfinishedLightSentence(const app::LightState& state, bool cancelled) {
  if (unfinishedLightText(state, cancelled).isEmpty()) return {};
  const double fraction = fractionOf(state.counters), left = state.counters.secondsLeft;
  const QString percent = percentText(fraction);
  if (cancelled) return QObject::tr("Light computation stopped at %1").arg(percent);
  if (state.phase == Phase::paused) return QObject::tr("Light computation paused at %1").arg(percent);
  if (state.phase == Phase::preparing) return QObject::tr("Light computation starts soon");
  return left > 0.0 ? QObject::tr("Computing light: %1, %2 left").arg(percent, durationText(left))
                    : QObject::tr("Computing light: %1").arg(percent);
}

LightStatus::LightStatus(QWidget* parent)
    : QWidget(parent),
      label_(new ElidedLabel(this)),
      bar_(thinBar(this)),
      pause_(new QToolButton(this)),
      stop_(new QToolButton(this)) {
  static_cast<ElidedLabel*>(label_)->keepFirstPart();
  bar_->setFixedSize(90, 6);
  bar_->setAccessibleName(tr("Light"));
  for (QToolButton* button : {pause_, stop_}) {
    button->setAutoRaise(true);
    button->setIconSize({14, 14});
    button->setFixedSize(22, 22);
  }
  stop_->setIcon(icon("close"));
  nameAndTip(stop_, tr("Stop computing light"), tr("Stop computing light and keep the result so far"));
  layOut(this, lineOf({label_, bar_, pause_, stop_}, 6), {10, 0, 0, 0});
  connect(pause_, &QToolButton::clicked, this, [this] {
    Q_EMIT(this->*(halted_ ? &LightStatus::goOn : &LightStatus::paused))();
  });
  connect(stop_, &QToolButton::clicked, this, &LightStatus::cancelled);
  setState({}, false);
}

void LightStatus::setState(const app::LightState& state, bool cancelled) {
  const bool works = !cancelled && (state.phase == Phase::baking || state.phase == Phase::paused ||
                                    state.phase == Phase::preparing);
  halted_ = cancelled || state.phase == Phase::paused;
  label_->setText(stateText(state, cancelled));
  label_->setToolTip(whyText(state));
  setInk(label_, state.phase == Phase::failed ? Ink::error : Ink::quiet);
  bar_->setVisible(works);
  showFraction(bar_, state.phase == Phase::preparing ? 0.0 : fractionOf(state.counters));
  bar_->setToolTip(whyText(state));
  pause_->setVisible((works && state.phase != Phase::preparing) || cancelled);
  pause_->setIcon(icon(halted_ ? "play" : "pause"));
  nameAndTip(pause_, halted_ ? tr("Resume computing light") : tr("Pause computing light"));
  stop_->setVisible(works);
  setVisible(state.phase != Phase::off);
}

}  // namespace isolux::ui
