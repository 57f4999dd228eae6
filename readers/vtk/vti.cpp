#include <optional>

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataArraySelection.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkXMLImageDataReader.h>

#include "base/error.h"
#include "readers/limits.h"
#include "readers/vtk/vtk_files.h"
#include "readers/vtk_messages.h"
#include "volume/read/input/payload.h"
#include "volume/read/vtk/vti.h"

namespace isolux::readers {

using namespace volume;
using base::throwInput;

namespace {

// Only the chosen array is read; the others stay in the file.
void select(vtkDataArraySelection* selection, const char* name) {
  selection->DisableAllArrays();
  if (name) selection->EnableArray(name);
}

}  // namespace

DecodedVolume decodeVti(const std::filesystem::path& path, const ReadOptions& options,
                        base::Progress& progress) {
  progress.report(0.0, "reading");
  std::optional<FileBytes> file(std::in_place, path);
  const std::string name = file->name();
  VtiHeader header = parseVtiHeader(*file, options);
  const std::uint64_t fileBytes = file->size();
  file.reset();
  checkChoices(header.image, name, options);
  ReadOptions whole = options;  // VTK holds all components at once
  whole.budgetBytes /= static_cast<std::size_t>(header.image.components);
  checkBudget(header.image, name, whole);

  allowDecoding(fileBytes);
  VtkMessages messages;
  vtkNew<vtkXMLImageDataReader> reader;
  watch(reader, progress);
  reader->SetFileName(path.c_str());
  reader->UpdateInformation();
  if (messages.errors().empty()) {
    select(reader->GetPointDataArraySelection(), header.cells ? nullptr : header.array.c_str());
    select(reader->GetCellDataArraySelection(), header.cells ? header.array.c_str() : nullptr);
    reader->Update();
  }
  progress.throwIfStopped();
  if (!messages.errors().empty())
    throwInput(name, "DataArray " + header.array, "VTK cannot read it: " + messages.errors().front());
  vtkImageData* image = reader->GetOutput();
  vtkDataSetAttributes* data = header.cells ? static_cast<vtkDataSetAttributes*>(image->GetCellData())
                                            : static_cast<vtkDataSetAttributes*>(image->GetPointData());
  vtkDataArray* array = data->GetArray(header.array.c_str());
  const ImageHeader& claim = header.image;
  if (!array || static_cast<std::uint64_t>(array->GetNumberOfTuples()) != claim.voxels() ||
      array->GetNumberOfComponents() != claim.components ||
      static_cast<std::size_t>(array->GetDataTypeSize()) != bytesOf(claim.type))
    throwInput(name, "DataArray " + header.array, "could not be read whole");
  for (const std::string& warning : messages.warnings()) header.image.warnings.push_back("VTK: " + warning);

  const auto bytes = static_cast<std::size_t>(claim.elements()) * bytesOf(claim.type);
  FileVoxels voxels = decodePayload(
      header.image, MemoryBytes(name, {static_cast<const std::byte*>(array->GetVoidPointer(0)), bytes}),
      openBeside(path), options, progress, header.image.warnings);
  image->ReleaseData();  // before the voxels are handed over
  return {std::move(header.image), std::move(voxels), {}, {}, {}};
}

}  // namespace isolux::readers
