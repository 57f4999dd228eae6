#include "ui/slices/slice_board.h"

#include <QGridLayout>

namespace isolux::ui {

SliceBoard::SliceBoard(QWidget* picture, QWidget* parent) : QWidget(parent) {
  auto* layout = new QGridLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(picture, 0, 1);
  constexpr std::array<std::pair<int, int>, 3> places{{{0, 0}, {1, 0}, {1, 1}}};
  for (std::size_t i = 0; i < views_.size(); ++i) {
    views_[i] = new SliceView(static_cast<volume::SliceDirection>(i), this);
    views_[i]->hide();
    layout->addWidget(views_[i], places[i].first, places[i].second);
    connect(views_[i], &SliceView::edited, this, &SliceBoard::edited);
    connect(views_[i], &SliceView::gestureEnded, this, &SliceBoard::gestureEnded);
    connect(views_[i], &SliceView::failed, this, &SliceBoard::failed);
  }
  layout->setRowStretch(0, 1);
  layout->setColumnStretch(1, 1);
}

void SliceBoard::setVolume(const VolumePointer& volume) {
  for (SliceView* view : views_) view->setVolume(volume);
}

void SliceBoard::setScene(const scene::Scene& scene, const scene::Scene& resolved) {
  for (SliceView* view : views_) view->setScene(scene, resolved);
}

void SliceBoard::setFourUp(bool on) {
  fourUp_ = on;
  auto* grid = static_cast<QGridLayout*>(layout());
  grid->setSpacing(on ? 2 : 0);
  grid->setRowStretch(1, on ? 1 : 0);
  grid->setColumnStretch(0, on ? 1 : 0);
  for (SliceView* view : views_) view->setVisible(on);
}

}  // namespace isolux::ui
