#include "ui/document/picture_request.h"

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

QSize PictureRequest::pixels(QSize window) const {
  const QSize most(app::kLargestPicture, app::kLargestPicture);
  QSize wanted = factor > 0.0 ? (QSizeF(window) * factor).toSize() : size;
  if (wanted.width() > most.width() || wanted.height() > most.height())
    wanted.scale(most, Qt::KeepAspectRatio);
  return wanted.expandedTo({1, 1});
}

double PictureRequest::pixelRatio(QSize window, double screenRatio) const {
  return std::clamp(screenRatio * pixels(window).height() / std::max(1, window.height()), 0.1, 32.0);
}

PictureRequest savedPictureRequest() {
  const QSettings kept;
  PictureRequest request;
  request.factor = kept.value(factorKey, request.factor).toDouble();
  if (!(request.factor >= 0.0 && request.factor <= largestFactor)) request.factor = 1.0;
  request.size = kept.value(sizeKey, request.size).toSize();
  const QRect allowed(1, 1, app::kLargestPicture, app::kLargestPicture);
  if (!allowed.contains(request.size.width(), request.size.height())) request.size = PictureRequest{}.size;
  request.session = kept.value(sessionKey, request.session).toBool();
  request.fullPaths = kept.value(fullPathsKey, request.fullPaths).toBool();
  return request;
}

void savePictureRequest(const PictureRequest& request) {
  QSettings kept;
  kept.setValue(factorKey, request.factor);
  kept.setValue(sizeKey, request.size);
  kept.setValue(sessionKey, request.session);
  kept.setValue(fullPathsKey, request.fullPaths);
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
