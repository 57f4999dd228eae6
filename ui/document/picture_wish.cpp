#include "ui/document/picture_wish.h"

#include <algorithm>

#include <QRect>
#include <QSettings>

#include "app/files/image_io.h"

namespace isolux::ui {

namespace {
constexpr auto factorKey = "picture/factor", sizeKey = "picture/size", sessionKey = "picture/session",
               fullPathsKey = "picture/fullPaths", lettersKey = "picture/letters",
               scaleBarKey = "picture/scaleBar", isovalueKey = "picture/isovalue",
               caveatsKey = "picture/caveats", transparentKey = "picture/transparent";
constexpr double largestFactor = 8.0;
}  // namespace

QSize PictureWish::pixels(QSize window) const {
  const QSize most(app::kLargestPicture, app::kLargestPicture);
  QSize wanted = factor > 0.0 ? (QSizeF(window) * factor).toSize() : size;
  if (wanted.width() > most.width() || wanted.height() > most.height())
    wanted.scale(most, Qt::KeepAspectRatio);
  return wanted.expandedTo({1, 1});
}

double PictureWish::pixelRatio(QSize window, double screenRatio) const {
  return std::clamp(screenRatio * pixels(window).height() / std::max(1, window.height()), 0.1, 32.0);
}

PictureWish keptPictureWish() {
  const QSettings kept;
  PictureWish wish;
  wish.factor = kept.value(factorKey, wish.factor).toDouble();
  if (!(wish.factor >= 0.0 && wish.factor <= largestFactor)) wish.factor = 1.0;
  wish.size = kept.value(sizeKey, wish.size).toSize();
  const QRect allowed(1, 1, app::kLargestPicture, app::kLargestPicture);
  if (!allowed.contains(wish.size.width(), wish.size.height())) wish.size = PictureWish{}.size;
  wish.session = kept.value(sessionKey, wish.session).toBool();
  wish.fullPaths = kept.value(fullPathsKey, wish.fullPaths).toBool();
  return wish;
}

void keepPictureWish(const PictureWish& wish) {
  QSettings kept;
  kept.setValue(factorKey, wish.factor);
  kept.setValue(sizeKey, wish.size);
  kept.setValue(sessionKey, wish.session);
  kept.setValue(fullPathsKey, wish.fullPaths);
}

scene::Picture withKeptWords(scene::Picture picture) {
  const QSettings kept;
  picture.letters = kept.value(lettersKey, true).toBool();
  picture.scaleBar = kept.value(scaleBarKey, true).toBool();
  picture.isovalue = kept.value(isovalueKey, true).toBool();
  picture.caveats = kept.value(caveatsKey, true).toBool();
  picture.transparent = kept.value(transparentKey, false).toBool();
  return picture;
}

void keepWords(const scene::Picture& picture) {
  QSettings kept;
  kept.setValue(lettersKey, picture.letters);
  kept.setValue(scaleBarKey, picture.scaleBar);
  kept.setValue(isovalueKey, picture.isovalue);
  kept.setValue(caveatsKey, picture.caveats);
  kept.setValue(transparentKey, picture.transparent);
}

scene::Picture asInWindow(scene::Picture picture) {
  const scene::Picture plain;
  picture.letters = plain.letters;
  picture.scaleBar = plain.scaleBar;
  picture.isovalue = plain.isovalue;
  picture.caveats = plain.caveats;
  picture.transparent = plain.transparent;
  picture.pixelRatio = plain.pixelRatio;
  return picture;
}

}  // namespace isolux::ui
