#include "readers/vtk_messages.h"

#include <algorithm>
#include <mutex>

#include <vtkAlgorithm.h>
#include <vtkCallbackCommand.h>
#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkOutputWindow.h>

#include "volume/read/input/text.h"

namespace isolux::readers {

using volume::trimmed;

namespace {

thread_local VtkMessages* current = nullptr;

class Window final : public vtkOutputWindow {
 public:
  void DisplayText(const char* text) override { pass(text, false); }
  void DisplayErrorText(const char* text) override { pass(text, true); }
  void DisplayWarningText(const char* text) override { pass(text, false); }
  void DisplayGenericWarningText(const char* text) override { pass(text, false); }
  void DisplayDebugText(const char*) override {}

 private:
  static void pass(const char* text, bool isError) {
    if (current && text) current->add(text, isError);
  }
};

void installOnce() {
  static std::once_flag once;
  std::call_once(once, [] {
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
    auto* window = new Window;
    window->InitializeObjectBase();
    vtkOutputWindow::SetInstance(window);
    window->Delete();
  });
}

// "ERROR: In file.cxx, line 12\nvtkReader (0x1234): reason\n\n" -> "reason".
std::string reasonOf(const char* text) {
  std::string reason(trimmed(text));
  if (const std::size_t line = reason.find('\n'); line != std::string::npos && reason.find(": In ") < line)
    reason.erase(0, line + 1);
  if (reason.starts_with("vtk"))
    if (const std::size_t colon = reason.find("): "); colon != std::string::npos) reason.erase(0, colon + 3);
  std::ranges::replace(reason, '\n', ' ');
  return std::string(trimmed(reason));
}

}  // namespace

void watch(vtkAlgorithm* algorithm, base::Progress& progress) {
  vtkNew<vtkCallbackCommand> observer;
  observer->SetCallback([](vtkObject* caller, unsigned long, void* clientData, void* callData) {
    auto& watched = *static_cast<base::Progress*>(clientData);
    watched.report(*static_cast<double*>(callData), "reading");
    if (watched.stopRequested()) static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
  });
  observer->SetClientData(&progress);
  algorithm->AddObserver(vtkCommand::ProgressEvent, observer);
}

VtkMessages::VtkMessages() : outer_(current) {
  installOnce();
  current = this;
}

VtkMessages::~VtkMessages() {
  current = outer_;
}

void VtkMessages::add(const char* text, bool isError) {
  constexpr std::size_t most = 100;
  auto& list = isError ? errors_ : warnings_;
  if (list.size() < most) list.push_back(reasonOf(text));
}

}  // namespace isolux::readers
