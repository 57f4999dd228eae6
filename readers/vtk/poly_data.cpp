// VTK XML PolyData (.vtp), read by VTK, which knows all its encodings, after a check of what it claims.
#include <array>

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include "base/error.h"
#include "readers/limits.h"
#include "readers/vtk/vtk_files.h"
#include "readers/vtk_messages.h"
#include "volume/read/input/streams.h"
#include "volume/read/input/text.h"
#include "volume/read/mesh/mesh_formats.h"
#include "volume/read/vtk/xml_tags.h"

namespace isolux::readers {

using namespace volume;
using base::throwInput;

namespace {

// VTK allocates what the pieces announce: no more than the file can hold at the best ratio of compression.
void checkClaims(const Bytes& bytes, const base::Progress& progress) {
  constexpr std::uint64_t leastBytes = 8;  // of a cell; a point has 12
  const std::string text = wholeText(bytes, progress);
  const std::string_view tagged = std::string_view(text).substr(0, text.find("<AppendedData"));
  Tags tags(tagged, bytes.name());
  bool hasPiece = false;
  while (const auto tag = tags.next()) {
    if (tag->name == "VTKFile" && tag->find("type") != "PolyData")
      throwInput(bytes.name(), "VTKFile type",
                 "is " + volume::inQuotes(tag->find("type").value_or("")) + ", not PolyData");
    if (tag->name == "DataArray" || tag->name == "Array") checkArrayClaims(*tag, bytes);
    if (tag->name != "Piece") continue;
    hasPiece = true;
    for (const char* key :
         {"NumberOfPoints", "NumberOfVerts", "NumberOfLines", "NumberOfStrips", "NumberOfPolys"}) {
      const auto claim = tag->find(key);
      if (!claim) continue;
      const auto count = integerOf(*claim);
      if (!count || *count < 0)
        throwInput(bytes.name(), std::string("Piece ") + key, inQuotes(*claim) + " is not a count");
      if (static_cast<std::uint64_t>(*count) > bytes.size() * kBestDeflateRatio / leastBytes)
        throwInput(bytes.name(), std::string("Piece ") + key,
                   "truncated: the file is too short for " + std::string(*claim));
    }
  }
  if (!hasPiece) throwInput(bytes.name(), "Piece", "truncated: is missing");
}

// The cells of one array, each given to `add`; VTK does not check that its offsets grow.
template <typename Add>
void forEachCell(vtkCellArray* cells, const std::string& file, const char* name, Add&& add) {
  if (!cells || cells->GetNumberOfCells() == 0) return;
  vtkDataArray* const offsets = cells->GetOffsetsArray();
  vtkDataArray* const corners = cells->GetConnectivityArray();
  const auto end = static_cast<std::int64_t>(corners->GetNumberOfValues());
  std::vector<std::int64_t> cell;
  for (vtkIdType i = 0; i + 1 < offsets->GetNumberOfTuples(); ++i) {
    const auto first = static_cast<std::int64_t>(offsets->GetComponent(i, 0));
    const auto behind = static_cast<std::int64_t>(offsets->GetComponent(i + 1, 0));
    const std::string place = std::string(name) + " " + std::to_string(i);
    if (first < 0 || behind < first || behind > end) throwInput(file, place, "its offsets make no sense");
    cell.clear();
    for (std::int64_t k = first; k < behind; ++k)
      cell.push_back(static_cast<std::int64_t>(corners->GetComponent(k, 0)));
    add(cell, place);
  }
}

}  // namespace

TriangleMesh decodePolyData(const std::filesystem::path& path, base::Progress& progress) {
  const std::string file = path.string();
  {
    const FileBytes bytes(path);
    checkClaims(bytes, progress);
    allowDecoding(bytes.size());
  }
  VtkMessages messages;
  vtkNew<vtkXMLPolyDataReader> reader;
  watch(reader, progress);
  reader->SetFileName(path.c_str());
  reader->Update();
  progress.throwIfStopped();
  if (!messages.errors().empty()) throwInput(file, "", "VTK cannot read it: " + messages.errors().front());

  TriangleMesh mesh;
  vtkPolyData* const data = reader->GetOutput();
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) {
    std::array<double, 3> p{};
    data->GetPoint(i, p.data());
    addPoint(mesh, {p[0], p[1], p[2]}, file, "point " + std::to_string(i));
  }
  forEachCell(data->GetPolys(), file, "polygon",
              [&](const auto& cell, const auto& place) { addPolygon(mesh, cell, file, place); });
  forEachCell(data->GetStrips(), file, "strip", [&](const auto& cell, const auto& place) {
    if (cell.size() < 3) throwInput(file, place, "has fewer than three corners");
    for (std::size_t i = 2; i < cell.size(); ++i) {  // every second triangle is turned
      const bool turned = i % 2 == 1;
      addPolygon(mesh, {cell[i - 2], cell[turned ? i : i - 1], cell[turned ? i - 1 : i]}, file, place);
    }
  });
  return mesh;
}

}  // namespace isolux::readers
