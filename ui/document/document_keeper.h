// Keeps the open document on disk while the window lives, and holds what windows that were killed have left.
//
// Every change is on disk within a second of its end: nothing is written on the window's thread, and while
// changes follow one another (a drag) they are gathered. What could not be written is tried again every
// minute.
#pragma once

#include <filesystem>
#include <vector>

#include <QObject>
#include <QTimer>

#include "app/documents/autosave.h"

namespace isolux::ui {

class Document;

class DocumentKeeper : public QObject {
  Q_OBJECT
 public:
  // Autosaves go into `folder`, made when the first is written.
  DocumentKeeper(Document* document, const std::filesystem::path& folder, QObject* parent);

  void save();                       // starts writing what is open now
  void finish() { file_.finish(); }  // waits until it is on disk
  void forget();                     // the user has closed the document: nothing is left behind

  // The newest autosave without a window, or null. It stays on disk until it is restored or discarded.
  const app::Autosave* lost() const;
  void restoreLost();
  void discardLost();  // then lost() is the next
  // Autosaves that could not be read, as they are named now.
  const std::vector<std::filesystem::path>& damaged() const { return lost_.damaged; }

 Q_SIGNALS:
  void failed(const QString& message);  // autosaves cannot be written; said once until one succeeds
  void noted(const QString& message);   // what did not come back with a restored document

 private:
  void tellProblem();
  void finishRestoring();

  Document* document_;
  app::AutosaveFile file_;
  app::LostAutosaves lost_;
  QTimer soon_, minute_;
  bool restoring_ = false, told_ = false;
};

}  // namespace isolux::ui
