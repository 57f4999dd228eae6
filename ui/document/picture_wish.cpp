#include "ui/document/picture_wish.h"

#include <algorithm>

#include <QRect>
#include <QSettings>

#include "app/files/image_io.h"

namespace isolux::ui {

namespace {
constexpr auto factorKey = "picture/factor", sizeKey = "picture/size", sessionKey = "picture/session",
               fullPathsKey = "picture/fullPaths";
constexpr double largestFactor = 8.0;

// What the user chooses of a picture, and has it unless another was chosen.
struct Word {
  const char* key;
  bool scene::Picture::*member;
  bool atFirst;
};
constexpr Word words[] = {{"picture/letters", &scene::Picture::letters, true},
                          {"picture/scaleBar", &scene::Picture::scaleBar, true},
                          {"picture/isovalue", &scene::Picture::isovalue, true},
                          {"picture/caveats", &scene::Picture::caveats, true},
                          {"picture/transparent", &scene::Picture::transparent, false}};
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
  for (const Word& word : words) picture.*word.member = kept.value(word.key, word.atFirst).toBool();
  return picture;
}

void keepWords(const scene::Picture& picture) {
  QSettings kept;
  for (const Word& word : words) kept.setValue(word.key, picture.*word.member);
}

scene::Picture withWordsOf(const scene::Picture& chosen, scene::Picture picture) {
  for (const Word& word : words) picture.*word.member = chosen.*word.member;
  return picture;
}

scene::Picture asInWindow(scene::Picture picture) {
  picture.pixelRatio = scene::Picture{}.pixelRatio;
  return withWordsOf({}, picture);
}

}  // namespace isolux::ui
