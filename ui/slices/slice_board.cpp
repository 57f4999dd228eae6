#include "ui/slices/slice_board.h"

#include <QGridLayout>

namespace isolux::ui {

namespace {

// Of the three planes, as 3D Slicer has them.
const QColor& colorOf(std::size_t view) {
  static const std::array<QColor, 3> colors{QColor(0xf3, 0x4a, 0x33), QColor(0x6e, 0xb0, 0x4b),
                                            QColor(0xed, 0xd5, 0x4c)};
  return colors[view];
}

struct Place {
  int row, column, rows;
};

}  // namespace

SliceBoard::SliceBoard(QWidget* picture, QWidget* parent) : QWidget(parent), picture_(picture) {
  auto* layout = new QGridLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  for (std::size_t i = 0; i < views_.size(); ++i) {
    views_[i] = new SliceView(static_cast<volume::SliceDirection>(i), colorOf(i), this);
    connect(views_[i], &SliceView::edited, this, &SliceBoard::edited);
    connect(views_[i], &SliceView::gestureBegan, this, [this] { setInteracting(true); });
    connect(views_[i], &SliceView::gestureEnded, this, [this] {
      setInteracting(false);
      Q_EMIT gestureEnded();
    });
    connect(views_[i], &SliceView::chosen, this, &SliceBoard::linkViews);
    connect(views_[i], &SliceView::failed, this, &SliceBoard::failed);
  }
  arrange(ViewLayout::picture);
}

void SliceBoard::setVolume(const VolumePointer& volume) {
  for (SliceView* view : views_) view->setVolume(volume);
  linkViews();
}

void SliceBoard::setScene(const scene::Scene& scene, const scene::Scene& resolved) {
  for (SliceView* view : views_) view->setScene(scene, resolved);
  linkViews();
}

void SliceBoard::setInteracting(bool interacting) {
  for (SliceView* view : views_) view->setInteracting(interacting);
}

// Each shows the lines of the others.
void SliceBoard::linkViews() {
  for (SliceView* view : views_) {
    std::vector<PlaneOfView> others;
    for (const SliceView* other : views_)
      if (const auto plane = other->planeOfView(); other != view && plane) others.push_back(*plane);
    view->setOthers(std::move(others));
  }
  Q_EMIT planesChanged();
}

std::vector<PlaneOfView> SliceBoard::planes() const {
  std::vector<PlaneOfView> all;
  if (!slicesShown()) return all;
  for (const SliceView* view : views_)
    if (const auto plane = view->planeOfView()) all.push_back(*plane);
  return all;
}

// Four-up: the picture at the upper right. Slices alone: the first as high as the other two.
void SliceBoard::arrange(ViewLayout arrangement) {
  arrangement_ = arrangement;
  const bool four = arrangement == ViewLayout::fourUp, slices = arrangement != ViewLayout::picture;
  auto* grid = static_cast<QGridLayout*>(layout());
  while (QLayoutItem* item = grid->takeAt(0)) delete item;
  grid->setSpacing(slices ? 2 : 0);
  constexpr std::array<Place, 3> besidePicture{{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}}},
      alone{{{0, 0, 2}, {0, 1, 1}, {1, 1, 1}}};
  if (four)
    grid->addWidget(picture_, 0, 1);
  else if (!slices)
    grid->addWidget(picture_, 0, 0, 2, 2);
  for (std::size_t i = 0; slices && i < views_.size(); ++i) {
    const Place& place = (four ? besidePicture : alone)[i];
    grid->addWidget(views_[i], place.row, place.column, place.rows, 1);
  }
  for (int i = 0; i < 2; ++i) {
    grid->setRowStretch(i, 1);
    grid->setColumnStretch(i, 1);
  }
  picture_->setVisible(arrangement != ViewLayout::slices);
  for (SliceView* view : views_) view->setVisible(slices);
  Q_EMIT arranged(arrangement);
  Q_EMIT planesChanged();
}

}  // namespace isolux::ui
