// The series of a DICOM folder, listed on a background thread; and a small picture of one slice. The owner
// polls and never waits.
#pragma once

#include <atomic>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/progress.h"
#include "base/retire.h"
#include "volume/read/process/dicom_index.h"

namespace isolux::app {

// Puts a series in the place of the one with the same UID, or at the end.
void addSeries(std::vector<volume::DicomSeries>& all, volume::DicomSeries series);

class IndexJob {
 public:
  explicit IndexJob(std::string folder);  // starts at once
  ~IndexJob();                            // stops

  const std::string& folder() const { return folder_; }
  base::Progress& progress() { return work_->progress; }
  bool finished() const { return work_->finished.load(std::memory_order_acquire); }
  // What was found, or became better known, since the last call.
  std::vector<volume::DicomSeries> take();
  // After finished(): what was looked at, or the error.
  const volume::DicomIndexEnd& end() const { return work_->end; }
  const std::optional<base::Error>& error() const { return work_->error; }

 private:
  struct Work {
    std::string folder;
    base::Progress progress;
    std::mutex mutex;
    std::vector<volume::DicomSeries> found;  // under the mutex
    volume::DicomIndexEnd end;
    std::optional<base::Error> error;
    std::atomic<bool> finished{false};
  };
  static void run(Work& work);

  std::string folder_;
  base::RetiringThread<Work> work_;
};

class PreviewJob {
 public:
  PreviewJob(std::string file, int frame);  // starts at once
  ~PreviewJob();                            // stops

  bool finished() const { return work_->finished.load(std::memory_order_acquire); }
  // After finished(): linear RGB, empty where there is no picture.
  const volume::DecodedImage& image() const { return work_->image; }

 private:
  struct Work {
    std::string file;
    int frame = 0;
    base::Progress progress;
    volume::DecodedImage image;
    std::atomic<bool> finished{false};
  };
  static void run(Work& work);

  base::RetiringThread<Work> work_;
};

}  // namespace isolux::app
