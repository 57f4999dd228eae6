#include "ui/panels/source_panel.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QPushButton>

#include "ui/editors/setting_editor.h"
#include "ui/language/translated.h"
#include "volume/read/reader.h"

namespace isolux::ui {

SourcePanel::SourcePanel(QWidget* parent) : QWidget(parent), form_(new QFormLayout(this)) {
  form_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form_->setContentsMargins(0, 0, 0, 8);
  addEditor("source.mesh_voxels", tr("Mesh voxels"));
  addEditor("source.csg", tr("Boolean operation"));
  addEditor("source.csg_path", tr("Second volume"));
  choose_ = new QPushButton(tr("Choose file…"), this);
  choose_->setAutoDefault(false);
  form_->addRow(QString(), choose_);
  addEditor("source.csg_value", tr("Second isovalue"));
  addEditor("source.csg_weight", tr("Second weight"));
  connect(choose_, &QPushButton::clicked, this, &SourcePanel::chooseSecond);
}

void SourcePanel::addEditor(const char* path, const QString& label) {
  auto* editor = new SettingEditor(scene::setting(path), this);
  form_->addRow(label, editor);
  editors_.push_back(editor);
  connect(editor, &SettingEditor::edited, this, &SourcePanel::edited);
  connect(editor, &SettingEditor::failed, this, &SourcePanel::failed);
}

SettingEditor* SourcePanel::editor(const QString& path) const {
  for (SettingEditor* editor : editors_) {
    if (QString::fromStdString(editor->setting().path) == path) return editor;
  }
  return nullptr;
}

void SourcePanel::show(const scene::Scene& scene, const VolumePointer& volume) {
  scene_ = scene;
  const scene::Scene resolved = scene::resolve(scene, volume ? volume->facts : scene::VolumeFacts{});
  for (SettingEditor* editor : editors_) editor->setScene(scene, resolved);
  const bool mesh = volume && volume->volume.format.find("mesh") != std::string::npos;
  const bool second = scene.source.csg != scene::Csg::none;
  form_->setRowVisible(editor("source.mesh_voxels"), mesh);
  form_->setRowVisible(editor("source.csg_path"), second);
  form_->setRowVisible(choose_, second);
  form_->setRowVisible(editor("source.csg_value"), second);
  form_->setRowVisible(editor("source.csg_weight"), scene.source.csg == scene::Csg::blend);
}

void SourcePanel::chooseSecond() {
  QStringList filters;
  for (const std::string& filter : volume::fileFilters()) filters += translatedFilter(filter);
  const QString folder = QFileInfo(QString::fromStdString(scene_.source.path)).absolutePath();
  const QString path =
      QFileDialog::getOpenFileName(this, tr("Choose the second volume"), folder, filters.join(";;"));
  if (path.isEmpty()) return;
  Edit edit{scene_, tr("Choose second volume")};
  edit.scene.source.csgPath = path.toStdString();
  Q_EMIT edited(edit);
}

}  // namespace isolux::ui
