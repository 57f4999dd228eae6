#include "ui/panels/volume_panel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QScrollArea>
#include <QSettings>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>
#include <QToolButton>

#include "scene/settings/choice_names.h"
#include "ui/document/privacy.h"
#include "ui/language/number_text.h"
#include "ui/language/sentences.h"
#include "ui/panels/source_panel.h"
#include "ui/theme/icons.h"
#include "ui/theme/style.h"
#include "ui/widgets/parts.h"

namespace isolux::ui {

namespace {

constexpr auto speedKey = "volume/stepsPerSecond";
constexpr std::size_t missingRow = 8;  // of the facts

QString triple(glm::dvec3 v, int significant, const char* between = " × ") {
  return numberText(v.x, significant) + between + numberText(v.y, significant) + between +
         numberText(v.z, significant);
}

// "x → L, y → P, z → S", with an angle where an axis is oblique; "x → +X" and so on where no side is known.
QString axesText(const glm::dmat3& directions, scene::WorldAxes axes) {
  const char* names[] = {"x", "y", "z"};
  QStringList parts;
  for (int axis = 0; axis < 3; ++axis) {
    const glm::dvec3& direction = directions[axis];
    const double largest = std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)});
    const double degrees = std::acos(std::min(1.0, largest)) * 180.0 / std::numbers::pi;
    QString part = QString("%1 → %2").arg(names[axis], QString::fromStdString(axisEnd(axes, direction)));
    if (degrees > 0.05) part += QObject::tr(" (tilted by %1°)").arg(numberText(degrees, 3));
    parts += part;
  }
  return parts.join(", ");
}
}  // namespace

VolumePanel::VolumePanel(QWidget* parent)
    : Panel(parent), facts_(new QFormLayout), choices_(new QFormLayout), choiceBox_(new QWidget(this)) {
  auto* scroll = new QScrollArea(this);
  scroll->setAccessibleName(tr("About the volume"));
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  layOut(this, columnOf({scroll}), {});
  setMinimumWidth(310);
  facts_->setHorizontalSpacing(14);
  facts_->setVerticalSpacing(6);
  facts_->setLabelAlignment(Qt::AlignLeft | Qt::AlignTop);
  for (const QString& name : {tr("Name"), tr("Format"), tr("Voxels"), tr("Type"), tr("Spacing"), tr("Extent"),
                              tr("Axes"), tr("Values"), tr("Missing"), tr("Memory"), tr("Time")})
    addRow(name);

  series_ = new QComboBox(choiceBox_);
  series_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  series_->setMinimumContentsLength(12);
  kind_ = new QComboBox(choiceBox_);
  kind_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  component_ = new QComboBox(choiceBox_);
  timeRow_ = new QWidget(choiceBox_);
  play_ = new QToolButton(timeRow_);
  timeSlider_ = new QSlider(Qt::Horizontal, timeRow_);
  timeSlider_->setTracking(false);
  timeSlider_->setPageStep(1);
  timeSlider_->setAccessibleName(tr("Time step"));
  const auto numberBox = [this](QWidget* parent) {
    auto* box = new NumberSpinBox(parent);
    connect(box, &NumberSpinBox::refused, this, &VolumePanel::failed);
    return box;
  };
  timeStep_ = numberBox(timeRow_);
  timeStep_->setToolTip(tr("A fraction blends a step with the next"));
  speed_ = numberBox(choiceBox_);
  speed_->setRange(0.05, 60.0);
  speed_->setSuffix(tr(" steps per second"));
  speed_->setOwnUndo();
  speed_->showValue(QSettings().value(speedKey, 2.0).toDouble());
  layOut(timeRow_, lineOf({play_, {timeSlider_, 1}, timeStep_}), {});
  level_ = new IntegerSpinBox(choiceBox_);
  connect(level_, &IntegerSpinBox::refused, this, &VolumePanel::failed);
  level_->setToolTip(
      tr("Level 0 is full resolution; each further level halves it along each axis, by averaging voxels"));
  for (QFormLayout* form : {facts_, choices_}) form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  choices_->setContentsMargins(0, 0, 0, 8);
  choices_->addRow(tr("Kind"), kind_);
  choices_->addRow(tr("Series"), series_);
  choices_->addRow(tr("Channel"), component_);
  choices_->addRow(tr("Time step"), timeRow_);
  choices_->addRow(tr("Speed"), speed_);
  choices_->addRow(tr("Level"), level_);
  choiceBox_->setLayout(choices_);

  source_ = new SourcePanel(this);
  connect(source_, &SourcePanel::edited, this, &VolumePanel::edited);
  connect(source_, &SourcePanel::failed, this, &VolumePanel::failed);

  warningTitle_ = new QLabel(tr("Import warnings"), this);
  makeBold(warningTitle_);
  setInk(warningTitle_, Ink::warning);
  warnings_ = new WrappedText(this);

  auto* content = new QWidget(this);
  layOut(content,
         columnOf({choiceBox_, facts_, Cell::gap(6), source_, Cell::gap(6), warningTitle_, warnings_,
                   Cell::room()},
                  8),
         {14, 12, 12, 12});
  scroll->setWidget(content);
  showFacts();
  showChoices();
  setPlaying(false);

  connect(kind_, &QComboBox::activated, this, [this](int index) {
    Edit edit{scene_, tr("Choose kind of data")};
    edit.scene.source.kind = static_cast<scene::DataKind>(index);
    Q_EMIT edited(edit);
  });
  connect(series_, &QComboBox::activated, this, [this] {
    Edit edit{scene_, tr("Choose series")};
    edit.scene.source.series = series_->currentData().toString().toStdString();
    edit.scene.source.level = 0;
    Q_EMIT edited(edit);
  });
  connect(component_, &QComboBox::activated, this, [this] {
    Edit edit{scene_, tr("Choose channel")};
    edit.scene.source.component = component_->currentData().toInt();
    Q_EMIT edited(edit);
  });
  connect(timeStep_, &NumberSpinBox::valueChanged, this, [this](double step) {
    Edit edit{scene_, tr("Choose time step")};
    edit.scene.source.timeStep = step;
    Q_EMIT edited(edit);
  });
  connect(timeSlider_, &QSlider::valueChanged, timeStep_, &NumberSpinBox::setValue);
  connect(play_, &QToolButton::clicked, this, &VolumePanel::playClicked);
  connect(speed_, &NumberSpinBox::valueChanged, this, [this](double speed) {
    QSettings().setValue(speedKey, speed);
    Q_EMIT speedChanged(speed);
  });
  connect(level_, &QSpinBox::valueChanged, this, [this](int level) {
    Edit edit{scene_, tr("Choose level")};
    edit.scene.source.level = level;
    Q_EMIT edited(edit);
  });
}

void VolumePanel::addRow(const QString& name) {
  auto* label = new QLabel(name, this);
  label->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  label->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Expanding);
  setInk(label, Ink::quiet);
  facts_->addRow(label, values_.emplace_back(new WrappedText(this)));
}

void VolumePanel::setVolume(const VolumePointer& volume) {
  volume_ = volume;
  firstPictureSeconds_.reset();
  showFacts();
  showChoices();
  source_->show(scene_, volume_);
}

void VolumePanel::setScene(const scene::Scene& scene, const scene::Scene&) {
  const bool changed = scene.source != scene_.source;
  scene_ = scene;
  if (changed) showChoices();
  source_->show(scene_, volume_);
}

void VolumePanel::setPlaying(bool playing) {
  play_->setIcon(icon(playing ? "pause" : "play"));
  nameAndTip(play_, playing ? tr("Pause") : tr("Play time steps"));
}

void VolumePanel::setFirstPicture(double seconds) {
  firstPictureSeconds_ = seconds;
  showFacts();
}

void VolumePanel::showFacts() {
  std::vector<Fact> known(values_.size(), {"–"});
  known[missingRow] = {};
  if (volume_) known = facts();
  for (std::size_t i = 0; i < values_.size(); ++i) {
    values_[i]->setText(known[i].text);
    values_[i]->setToolTip(known[i].tip);
    facts_->setRowVisible(values_[i], !known[i].text.isEmpty());
  }
  QStringList warnings;
  if (volume_)
    for (const std::string& warning : volume_->volume.warnings)
      warnings += "• " + shownText(QString::fromStdString(warning), volume_);
  warnings_->setText(warnings.join("\n\n"));
  warningTitle_->setVisible(!warnings.isEmpty());
  warnings_->setVisible(!warnings.isEmpty());
}

std::vector<VolumePanel::Fact> VolumePanel::facts() const {
  const volume::Volume& volume = volume_->volume;
  const volume::Grid& grid = *volume.grid;
  const volume::GridGeometry& geometry = grid.geometry();
  const glm::dvec3 spacing = geometry.spacingMm();
  const auto text = [this](std::string_view s) { return shownText(QString::fromUtf8(s), volume_); };
  QString type = text(volume::nameOf(volume.fileType));
  if (volume.fileType != grid.storedType())
    type = tr("%1, in memory as %2").arg(type, text(volume::nameOf(grid.storedType())));
  if (grid.slope() != 1.0 || grid.intercept() != 0.0) {
    type += '\n' + tr("value = %1 · stored").arg(numberText(grid.slope(), shownDigits));
    if (grid.intercept() != 0.0) {
      type += QString(" %1 %2").arg(grid.intercept() < 0.0 ? "−" : "+",
                                    numberText(std::abs(grid.intercept()), shownDigits));
    }
  }
  const glm::dvec3 extent = spacing * glm::dvec3(grid.dims() - 1);
  // Of a tilted series the distance of slices is not the length of the axis along which they are stacked.
  const glm::dmat3 directions = geometry.directions();
  const double across =
      spacing.z * std::abs(glm::dot(directions[2], glm::normalize(glm::cross(directions[0], directions[1]))));
  const bool tilted = across < 0.999 * spacing.z;
  const QString apart = tilted ? tr(" (slices %1 mm apart)").arg(numberText(across, shownDigits)) : QString();
  QString axes = axesText(geometry.directions(), volume.axes);
  if (geometry.leftHanded()) axes = tr("%1; left-handed").arg(axes);
  if (volume.axes != scene::WorldAxes::anatomical) axes += '\n' + tr("orientation not stated");
  const auto range = [&](int digits) {
    return numberText(grid.minimum(), digits) + " … " + valueText(grid.maximum(), text(volume.unit), digits);
  };
  const QString missing = grid.missingCount() > 0 ? tr("%1 voxels").arg(grid.missingCount()) : QString();
  const QString read = numberText(volume_->readSeconds, 2), prepared = numberText(volume_->prepareSeconds, 2);
  const QString time = firstPictureSeconds_ ? tr("read %1 s, prepared %2 s; first image %3 s after reading")
                                                  .arg(read, prepared, numberText(*firstPictureSeconds_, 2))
                                            : tr("read %1 s, prepared %2 s").arg(read, prepared);
  return {{text(volume.name)},
          {text(volume.format)},
          {triple(glm::dvec3(grid.dims()), 9)},
          {type},
          {triple(spacing, shownDigits) + " mm" + apart, triple(spacing, allDigits) + " mm"},
          {triple(extent, shownDigits) + " mm", triple(extent, allDigits) + " mm"},
          {axes},
          {range(shownDigits), range(allDigits)},
          {missing},
          {bytesText(static_cast<double>(grid.bytes()))},
          {time}};
}

void VolumePanel::showChoices() {
  const QSignalBlocker blockSeries(series_), blockComponent(component_), blockSlider(timeSlider_),
      blockLevel(level_), blockKind(kind_);
  kind_->clear();
  if (volume_) {
    const auto wordsFor = [](std::string_view name) {
      return wordsOf(QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size())));
    };
    for (const auto name : scene::choiceNames<scene::DataKind>()) kind_->addItem(wordsFor(name));
    if (scene_.source.kind == scene::DataKind::automatic)
      kind_->setItemText(0, tr("%1 (automatic)").arg(wordsFor(scene::choiceName(volume_->kind.kind))));
    kind_->setCurrentIndex(static_cast<int>(scene_.source.kind));
    kind_->setToolTip(tr("Kind of data; presets depend on it. Chosen because %1")
                          .arg(translatedSentence(volume_->kind.reason)));
  }
  series_->clear();
  component_->clear();
  const bool severalSeries = volume_ && volume_->volume.seriesChoices.size() > 1;
  const bool severalComponents = volume_ && volume_->volume.components > 1;
  const bool severalSteps = volume_ && volume_->volume.timeSteps > 1;
  const bool coarse =
      volume_ && scene_.source.level > 0;  // of a file that may have no more levels nothing is said
  if (severalSeries) {
    for (const std::string& choice : volume_->volume.seriesChoices) {  // "UID<TAB>description, N slices"
      const QString entry = QString::fromStdString(choice);
      series_->addItem(shownText(entry.section('\t', 1), volume_), entry.section('\t', 0, 0));
    }
    const int current = series_->findData(QString::fromStdString(scene_.source.series));
    series_->setCurrentIndex(std::max(0, current));
  }
  if (severalComponents) {
    for (int i = 0; i < volume_->volume.components; ++i) component_->addItem(QString("%1").arg(i), i);
    component_->addItem(tr("Magnitude"), -1);
    component_->setCurrentIndex(component_->findData(scene_.source.component));
  }
  if (severalSteps) {
    const int last = volume_->volume.timeSteps - 1;
    const QSignalBlocker blockTime(timeStep_);
    timeStep_->setRange(0, last);
    timeStep_->setSuffix(tr(" of %1").arg(last));
    timeStep_->showValue(scene_.source.timeStep);
    timeSlider_->setRange(0, last);
    timeSlider_->setValue(static_cast<int>(std::lround(scene_.source.timeStep)));
  }
  level_->setRange(0, volume_ ? volume_->volume.coarsestLevel : 0);
  level_->setValue(scene_.source.level);
  choices_->setRowVisible(series_, severalSeries);
  choices_->setRowVisible(component_, severalComponents);
  choices_->setRowVisible(timeRow_, severalSteps);
  choices_->setRowVisible(speed_, severalSteps);
  choices_->setRowVisible(level_, coarse);
  choiceBox_->setVisible(volume_ != nullptr);
}

}  // namespace isolux::ui
