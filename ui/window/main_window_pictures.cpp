// What leaves ui/window/main_window.h: pictures saved, copied and as a command, and meshes.
#include <algorithm>
#include <chrono>
#include <future>

#include <QClipboard>
#include <QFileInfo>
#include <QGuiApplication>
#include <QImage>

#include "app/documents/command_text.h"
#include "app/documents/session.h"
#include "app/documents/session_accuracy.h"
#include "app/files/image_io.h"
#include "app/overlay_text/annotation.h"
#include "scene/rules/automatic.h"
#include "scene/rules/relevance.h"
#include "ui/accuracy/accuracy_panel.h"
#include "ui/dialogs/mesh_dialog.h"
#include "ui/dialogs/picture_dialog.h"
#include "ui/document/baked_light.h"
#include "ui/document/picture_pixels.h"
#include "ui/document/picture_request.h"
#include "ui/document/privacy.h"
#include "ui/document/recent_files.h"
#include "ui/levels/full_resolution_view.h"
#include "ui/panels/light_status.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/save_dialog.h"
#include "ui/widgets/waiting.h"
#include "ui/window/main_window.h"
#include "ui/window/message_bar.h"

namespace isolux::ui {

namespace {

QSize sizeOf(glm::ivec2 size) {
  return {size.x, size.y};
}

bool endsWith(const QString& file, const char* suffix) {
  return QFileInfo(file).suffix().compare(QLatin1String(suffix), Qt::CaseInsensitive) == 0;
}

}  // namespace

void MainWindow::choosePicture() {
  const scene::Scene& scene = document_->scene();
  const bool hasLegend = scene::whyInactive("look.legend", scene).empty();
  const PictureChoices choices{savedPictureRequest(), scene.picture, scene.look.legend};
  auto* dialog = new PictureDialog(choices, sizeOf(viewport_->pixelSize()), hasLegend, this);
  dialog->setPreview([this](const PictureChoices& chosen) { return previewOf(chosen); });
  connect(dialog, &PictureDialog::saveAsked, this, [this](const PictureChoices& chosen) {
    takeChoices(chosen);
    const QString session = chosen.request.session ? tr(", with session") : QString();
    const QString png = tr("PNG%1 (*.png)").arg(session),
                  exr = tr("OpenEXR, linear colours%1 (*.exr)").arg(session);
    const QString file = askForFileToSave(this, tr("Save image"), proposedFile(".png"), {png, exr});
    if (file.isEmpty()) return;
    rememberFolder(file);
    savePicture(file, chosen.request.session);
  });
  connect(dialog, &PictureDialog::copyAsked, this, [this](const PictureChoices& chosen) {
    takeChoices(chosen);
    copyPicture();
  });
  dialog->open();
}

// The picture on screen with what is chosen written on it.
QImage MainWindow::previewOf(const PictureChoices& chosen) const {
  if (!document_->volume() || viewport_->shown().isNull()) return {};
  render::ColorImage picture =
      colorImageOf(fullResolution_->shows() ? fullResolution_->image() : viewport_->shown());
  scene::Scene resolved = document_->resolvedScene();
  resolved.picture = chosen.picture;
  resolved.picture.transparent = false;
  render::FrameReport report;
  report.legend = viewport_->legend();
  app::annotate(resolved, *document_->volume(), report, picture);
  return imageOf(picture);
}

// What is written on the picture is of the document, and a step of undo; its size is the user's.
void MainWindow::takeChoices(const PictureChoices& chosen) {
  savePictureRequest(chosen.request);
  keepWords(chosen.picture);
  Edit edit{document_->scene(), tr("Change image annotations")};
  edit.scene.picture = withWordsOf(chosen.picture, edit.scene.picture);
  edit.scene.look.legend = chosen.legend;
  if (!(edit.scene == document_->scene())) document_->edit(edit);
}

scene::Scene MainWindow::pictureScene(const PictureRequest& asked) const {
  scene::Scene shown = document_->shownScene();
  shown.picture.pixelRatio = asked.pixelRatio(sizeOf(viewport_->pixelSize()), viewport_->devicePixelRatioF());
  if (fullResolution_->shows()) shown.source.level = 0;
  // A view that fits by itself is written down as it is: what draws it again need not know of fitting.
  const scene::Camera camera =
      pictureCamera(asked.pixels(sizeOf(viewport_->pixelSize())), shown.picture.pixelRatio);
  if (!(camera == document_->camera())) shown.camera = camera;
  return shown;
}

scene::Camera MainWindow::pictureCamera(QSize pixels, double ratio) const {
  const glm::ivec2 size(pixels.width(), pixels.height());
  return document_->cameraOf(size, Viewport::letterEdges(size, ratio));
}

// Drawn as the kept request says, with everything on it.
render::StillPicture MainWindow::finishedPicture(bool linear, const QString& what) {
  const PictureRequest asked = savedPictureRequest();
  const QSize size = asked.pixels(sizeOf(viewport_->pixelSize()));
  scene::Scene resolved = document_->resolvedScene();
  const glm::ivec2 pixels(size.width(), size.height());
  const double ratio = pictureScene(asked).picture.pixelRatio;
  render::StillPicture picture;
  if (fullResolution_->shows()) {
    render::FrameRequest request;
    request.size = pixels;
    request.pixelRatio = ratio;
    request.supersampling = std::clamp(resolved.picture.supersampling, 1, 4);
    request.linear = linear;
    picture = fullResolution_->picture(request, document_->scene().picture.transparent, this, what);
  } else {
    resolved.camera = pictureCamera(size, ratio);
    picture = viewport_->picture({pixels, ratio, resolved.camera, linear, what});
  }
  app::annotate(resolved, *document_->volume(), picture.report, picture.color);
  return picture;
}

bool MainWindow::savePicture(const QString& file, bool withSession) {
  const auto work = [&] {
    const std::filesystem::path path = file.toStdString();
    const QString name = QFileInfo(file).fileName();
    if (!endsWith(file, "png") && !endsWith(file, "exr"))
      base::throwInput(path.filename().string(), "", "unknown image format; use .png or .exr");
    document_->checkOutput(file);
    const PictureRequest asked = savedPictureRequest();
    const scene::Scene scene = pictureScene(asked);
    const auto textOf = [&] {
      return asked.fullPaths
                 ? app::sessionText(scene, path.parent_path())
                 : app::pictureSessionText(scene, path.parent_path(), hiddenInSaved(document_->volume()));
    };
    std::string session = withSession ? textOf() : std::string();
    if (const auto& known = panel<AccuracyPanel>()->picture().known())
      session = app::sessionWithAccuracy(session, *known);
    const bool linear = endsWith(file, "exr");
    const render::StillPicture picture = finishedPicture(linear, tr("Saving %1").arg(name));
    const QString light = unfinishedLightText(light_->state(), light_->cancelled());
    // Where the system has no thread to give, get() writes.
    auto written = std::async(std::launch::async | std::launch::deferred, [&] {
      if (linear)
        app::writeExr(&picture.linear, {}, path, session);
      else
        app::writePng(picture.color, path, session);
    });
    waitFor(this, {tr("Writing %1").arg(name),
                   [&] { return written.wait_for(std::chrono::seconds(0)) != std::future_status::timeout; }});
    written.get();
    tellSaved(file, light);
  };
  return attempt(work, tr("The image was not saved (cancelled)"));
}

bool MainWindow::copyPicture() {
  if (!document_->volume()) return false;
  return attempt([&] {
    const render::StillPicture picture = finishedPicture(false, tr("Copying the image"));
    const QString light = unfinishedLightText(light_->state(), light_->cancelled());
    QGuiApplication::clipboard()->setImage(imageOf(picture.color));
    const QString size =
        tr("Copied the image: %1 × %2 pixels").arg(picture.color.size.x).arg(picture.color.size.y);
    message_->showNote(light.isEmpty() ? size : tr("%1, %2").arg(size, light));
  });
}

void MainWindow::chooseMesh() {
  auto* dialog = new MeshDialog(document_->volume(), document_->resolvedScene(), this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAskName([this] {
    const QString file = askForFileToSave(this, tr("Export mesh"), proposedFile(".stl"),
                                          {tr("STL, for printing (*.stl)"), tr("PLY, with normals (*.ply)"),
                                           tr("Wavefront OBJ (*.obj)"), tr("VTK, with curvature (*.vtp)")});
    if (file.isEmpty() || !attempt([&] { document_->checkOutput(file); })) return QString();
    rememberFolder(file);
    return file;
  });
  connect(dialog, &MeshDialog::exported, this, &MainWindow::tellSaved);
  connect(dialog, &MeshDialog::placeAsked, this, [this](const glm::dvec3& worldMm) {
    Edit edit{document_->scene(), tr("Centre on mesh position")};
    edit.scene.camera = app::centredOn(document_->resolvedScene().camera, worldMm);
    applyEdit(edit);
  });
  dialog->show();
}

QString MainWindow::commandText() const {
  if (!document_->volume()) return {};
  const PictureRequest asked = savedPictureRequest();
  const QSize size = asked.pixels(sizeOf(viewport_->pixelSize()));
  const std::string out = proposedFile(".png").section('/', -1).toStdString();
  return QString::fromStdString(
      app::renderCommand(pictureScene(asked), host_, {size.width(), size.height()}, out));
}

void MainWindow::copyCommand() {
  QGuiApplication::clipboard()->setText(commandText());
  message_->showNote(tr("Copied a command that renders this image"));
}

}  // namespace isolux::ui
