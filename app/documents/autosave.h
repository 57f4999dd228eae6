// Autosaves: what would be lost if the program ended now, as files in the user's state folder; how a window
// keeps its own, and how the next start finds those that a killed program has left behind.
//
// A window's autosave is NAME.autosave (JSON, below) with NAME.lock beside it. The lock is held (flock) for
// as long as the window lives and falls with the process however that ends: an autosave whose lock can be
// taken has lost its window. Whoever takes the lock owns the file, so no two windows offer the same.
//
// {"isolux_autosave": 1, "program": "0.2.0", "time": seconds since 1970, "name": "ct.nii.gz",
//  "session_file": "", "recording": "", "scene": {...}, "saved": {...}, "position": 2,
//  "steps": [{"name": "Rotate", "back": {"camera.eye": ...}, "forth": {"camera.eye": ...}}, ...]}
// Scenes as in sessions, but with absolute paths; steps as in recordings. Stored light is not part of it.
#pragma once

#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "app/documents/history.h"
#include "app/files/file_lock.h"
#include "base/error.h"

namespace isolux::app {

// All of a document but its volume, which is read again.
struct OpenDocument {
  std::string name;           // as the user knows it, for the offer to continue
  History history;            // and with it the scene
  scene::Scene saved;         // as it was opened or saved last
  std::string sessionFile;    // absolute; "": never saved
  std::string recordingFile;  // being recorded into; "": none
};

// False for what a click brings back: a built-in phantom in which nothing was changed.
bool worthKeeping(const OpenDocument& document);

struct Autosave {
  OpenDocument document;
  std::chrono::system_clock::time_point time;  // of writing
};
std::string autosaveText(const Autosave& autosave);
// `file` is for messages. Throws base::Error{input} for anything that is not whole and valid.
Autosave parseAutosave(const std::string& text, const std::string& file);

// "20 s ago", "5 min ago", "3 h ago", "2 days ago".
std::string agoText(std::chrono::system_clock::duration age);

// The autosave of one window. Called on the window's thread; files are written on a thread of its own. Its
// end waits for what is being written; the file stays.
class AutosaveFile {
 public:
  explicit AutosaveFile(std::filesystem::path folder);  // makes nothing yet

  void write(OpenDocument document);  // soon; of several that wait, only the newest is written
  void remove();                      // nothing needs to be kept (any more)
  void finish();                      // waits until the last request is fulfilled
  // Why the last writing failed; nothing when it succeeded.
  std::optional<base::Error> problem();
  const std::filesystem::path& path() const { return file_; }

 private:
  void request(std::optional<OpenDocument> document);
  void work(const std::stop_token& stop);
  void fulfil(const std::optional<OpenDocument>& document);

  std::filesystem::path folder_, file_, lockFile_;
  FileLock lock_;  // the worker's
  std::mutex mutex_;
  std::condition_variable_any changed_;
  bool requested_ = false, working_ = false;
  std::optional<OpenDocument> wanted_;  // what the file should hold; nothing: no file
  std::optional<base::Error> problem_;
  std::jthread worker_;  // last: it ends before the rest goes
};

// An autosave whose window is gone, ours alone until this object goes. It stays on disk unless discarded.
struct LostAutosave {
  Autosave content;
  std::filesystem::path file;
  FileLock lock;

  void discard();  // removes it from the disk
};

struct LostAutosaves {
  std::vector<LostAutosave> found;  // newest first
  std::vector<std::filesystem::path>
      damaged;  // could not be read: renamed to these, and left alone from now on
};
// Takes all that no living window owns. A missing folder holds none; never throws.
LostAutosaves takeLostAutosaves(const std::filesystem::path& folder);

}  // namespace isolux::app
