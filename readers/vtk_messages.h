// Collects what VTK would print: while one lives, VTK's errors and warnings of this thread go into it.
// Outside of one they are dropped; nothing of VTK's reaches stderr.
#pragma once

#include <string>
#include <vector>

#include "base/progress.h"

class vtkAlgorithm;

namespace isolux::readers {

// Passes VTK's progress on and stops VTK when asked to.
void watch(vtkAlgorithm* algorithm, base::Progress& progress);

class VtkMessages {
 public:
  VtkMessages();
  ~VtkMessages();
  VtkMessages(const VtkMessages&) = delete;
  VtkMessages& operator=(const VtkMessages&) = delete;

  // One line each, without VTK's file names and addresses.
  const std::vector<std::string>& errors() const { return errors_; }
  const std::vector<std::string>& warnings() const { return warnings_; }
  void add(const char* text, bool isError);

 private:
  VtkMessages* outer_;
  std::vector<std::string> errors_, warnings_;
};

}  // namespace isolux::readers
