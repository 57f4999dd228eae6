#include "ui/viewport/pointed_piece.h"

#include <cmath>

#include "ui/language/number_text.h"
#include "volume/pieces/pieces.h"

namespace isolux::ui {

namespace {
constexpr int pointerRestMilliseconds = 250;
}  // namespace

QString volumeText(double mm3) {
  constexpr double wholeFrom = 1000.0;
  if (mm3 < wholeFrom || mm3 >= 1e15) return valueText(mm3, "mm³", 3);
  return groupedText(static_cast<std::uint64_t>(std::llround(mm3))) + " mm³";
}

PointedPiece::PointedPiece(QObject* parent) : QObject(parent) {
  callOnce(restTimer_, pointerRestMilliseconds, this, &PointedPiece::find);
}

void PointedPiece::point(const VolumePointer& volume, const scene::Scene& resolved,
                         const std::optional<app::Pick>& pick) {
  if (volume_ != volume) {
    task_.reset();
    asked_.reset();
  }
  volume_ = volume;
  scene_ = resolved;
  pick_ = pick;
  restTimer_.stop();
  const bool known = !pick_ || volume_->pieces->find(pick_->isovalue, scene_.isosurface.inside);
  if (!known) restTimer_.start();
}

QString PointedPiece::text() const {
  if (!pick_ || !volume_) return {};
  const auto pieces = volume_->pieces->find(pick_->isovalue, scene_.isosurface.inside);
  if (!pieces) return {};
  const std::uint32_t id = volume::pieceOfSurface(*pieces, pick_->voxel);
  if (id == volume::Pieces::kNone) return {};
  const volume::Piece& piece = pieces->list()[id];
  const QString whose = id == 0 ? tr("the largest of %1") : tr("of %1");
  return tr("piece %1 (%2): %3")
      .arg(QString::number(id), whose.arg(pieces->list().size()),
           pieces->hasVolume() ? volumeText(piece.volumeMm3) : tr("%1 voxels").arg(piece.voxels));
}

void PointedPiece::find() {
  if (!pick_ || !volume_) return;
  const app::PieceSubject wanted{volume_, pick_->isovalue, scene_.isosurface.inside};
  if (asked_ == wanted) return;
  asked_ = wanted;
  task_.watch(app::pieceTask(wanted, scene_, false), [this](auto& task) {
    // What is too large for this isovalue is not tried with every movement of the pointer.
    if (task.error()) return;
    asked_.reset();
    Q_EMIT changed();
  });
}

}  // namespace isolux::ui
