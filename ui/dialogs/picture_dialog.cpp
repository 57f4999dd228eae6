#include "ui/dialogs/picture_dialog.h"

#include <algorithm>
#include <array>

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>

#include "app/files/image_io.h"
#include "ui/widgets/parts.h"

namespace isolux::ui {

namespace {

constexpr std::array factors{1.0, 2.0, 4.0, 0.0};  // in the order of the list; 0: a size of one's own
constexpr QSize previewSize(400, 280);

QCheckBox* newCheck(const QString& text, bool on, const QString& tip) {
  auto* box = new QCheckBox(text);
  box->setChecked(on);
  box->setToolTip(tip);
  return box;
}

QGroupBox* newGroup(const QString& title, QBoxLayout* rows) {
  auto* group = new QGroupBox(title);
  layOut(group, rows);
  return group;
}

}  // namespace

PictureDialog::PictureDialog(const PictureChoices& choices, QSize window, bool hasLegend, QWidget* parent)
    : QDialog(parent), given_(choices), window_(window) {
  setWindowTitle(tr("Save image"));
  setAttribute(Qt::WA_DeleteOnClose);

  letters = newCheck(tr("&Orientation labels"), choices.picture.letters,
                     tr("Side of the patient at each edge, if the patient orientation is known"));
  scaleBar = newCheck(tr("Scale &bar"), choices.picture.scaleBar, tr("Bar of a round length in millimetres"));
  isovalue = newCheck(tr("&Isovalue"), choices.picture.isovalue,
                      tr("Isovalues of the surfaces shown, with their unit"));
  caveats = newCheck(tr("&Hidden and interpolated data"), choices.picture.caveats,
                     tr("Lists hidden pieces and interpolated slices"));
  legend = newCheck(tr("Le&gend"), choices.legend && hasLegend,
                    hasLegend ? tr("Meaning of the colours; also shown in the window")
                              : tr("The colours of this look show no quantity"));
  legend->setEnabled(hasLegend);

  size = new QComboBox;
  size->setAccessibleName(tr("Size"));
  const auto times = [&](const QString& name, double factor) {
    const QSize pixels = PictureRequest{factor, {}, true, false}.pixels(window);
    return QString("%1 – %2 × %3").arg(name).arg(pixels.width()).arg(pixels.height());
  };
  size->addItems(
      {times(tr("As in the window"), 1.0), times(tr("2×"), 2.0), times(tr("4×"), 4.0), tr("Custom")});
  const auto at = std::find(factors.begin(), factors.end(), choices.request.factor);
  size->setCurrentIndex(at == factors.end() ? 0 : static_cast<int>(at - factors.begin()));
  width = spinBox(1, app::kLargestPicture, choices.request.size.width(), tr("Width"));
  height = spinBox(1, app::kLargestPicture, choices.request.size.height(), tr("Height"));
  auto* sides = lineOf({width, new QLabel("×"), height, new QLabel(tr("pixels")), Cell::room()});
  transparent = newCheck(tr("&Transparent background"), choices.picture.transparent,
                         tr("Surface only, with anti-aliased edges, for slides and posters"));

  session = newCheck(tr("Embed &session"), choices.request.session,
                     tr("The image opens again as a session: view, isovalue, look, measurements"));
  fullPaths = newCheck(tr("Include full &paths"), choices.request.fullPaths,
                       tr("Stores the folders of its files, which may identify you or the patient. Without "
                          "them, the image opens as a session on this computer or next to its volume."));

  preview = new QLabel;
  preview->setObjectName("preview");
  preview->setAccessibleName(tr("Preview"));
  preview->setAlignment(Qt::AlignCenter);
  preview->setMinimumSize(previewSize);

  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
  save = buttons->addButton(tr("&Save…"), QDialogButtonBox::AcceptRole);
  copy = buttons->addButton(tr("&Copy"), QDialogButtonBox::ActionRole);
  copy->setToolTip(tr("Copy to the clipboard, without the session"));
  save->setDefault(true);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(save, &QPushButton::clicked, this, [this] { answer(&PictureDialog::saveAsked); });
  connect(copy, &QPushButton::clicked, this, [this] { answer(&PictureDialog::copyAsked); });

  auto* words = newGroup(tr("Annotations"), columnOf({letters, scaleBar, isovalue, caveats, legend}));
  auto* form = newGroup(tr("Size and background"), columnOf({size, sides, transparent}));
  auto* file = newGroup(tr("File contents"), columnOf({session, fullPaths}));
  auto* left = columnOf({words, form, file, Cell::room()});
  layOut(this, columnOf({{lineOf({left, {preview, 1}}), 1}, buttons}));

  for (QCheckBox* box : {letters, scaleBar, isovalue, caveats, legend, transparent, session})
    connect(box, &QCheckBox::toggled, this, &PictureDialog::showChoices);
  connect(size, &QComboBox::currentIndexChanged, this, &PictureDialog::showChoices);
  showChoices();
}

PictureChoices PictureDialog::choices() const {
  PictureChoices chosen = given_;
  chosen.picture.letters = letters->isChecked();
  chosen.picture.scaleBar = scaleBar->isChecked();
  chosen.picture.isovalue = isovalue->isChecked();
  chosen.picture.caveats = caveats->isChecked();
  chosen.picture.transparent = transparent->isChecked();
  if (legend->isEnabled()) chosen.legend = legend->isChecked();
  chosen.request.factor = factors.at(static_cast<std::size_t>(size->currentIndex()));
  chosen.request.size = {width->value(), height->value()};
  chosen.request.session = session->isChecked();
  chosen.request.fullPaths = fullPaths->isChecked();
  return chosen;
}

void PictureDialog::setPreview(Draw draw) {
  draw_ = std::move(draw);
  showChoices();
}

void PictureDialog::showChoices() {
  const bool own = factors.at(static_cast<std::size_t>(size->currentIndex())) == 0.0;
  width->setEnabled(own);
  height->setEnabled(own);
  fullPaths->setEnabled(session->isChecked());
  if (!draw_) return;
  const qreal ratio = devicePixelRatioF();
  const QImage whole = draw_(choices());
  if (whole.isNull()) return;
  QImage image = whole.scaled(previewSize * ratio, Qt::KeepAspectRatio, Qt::SmoothTransformation);
  image.setDevicePixelRatio(ratio);
  preview->setPixmap(QPixmap::fromImage(image));
}

void PictureDialog::answer(void (PictureDialog::*asked)(const PictureChoices&)) {
  const PictureChoices chosen = choices();
  accept();
  Q_EMIT(this->*asked)(chosen);
}

}  // namespace isolux::ui
