#include "bench/triangles.h"

#include <algorithm>

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

namespace isolux::bench {

Triangles trianglesOf(const volume::Grid& grid, double isovalue) {
  vtkNew<vtkFloatArray> values;
  values->SetNumberOfValues(static_cast<vtkIdType>(grid.geometry().voxelCount()));
  std::visit([&](const auto& voxels) { std::copy(voxels.begin(), voxels.end(), values->GetPointer(0)); },
             grid.voxels());
  vtkNew<vtkImageData> image;
  image->SetDimensions(grid.dims().x, grid.dims().y, grid.dims().z);
  image->GetPointData()->SetScalars(values);
  vtkNew<vtkFlyingEdges3D> edges;
  edges->SetInputData(image);
  edges->SetValue(0, grid.storedOfValue(isovalue));
  edges->ComputeNormalsOff();
  edges->ComputeScalarsOff();
  edges->Update();
  vtkPolyData* mesh = edges->GetOutput();
  Triangles result;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i) {
    double p[3];
    mesh->GetPoint(i, p);
    result.points.emplace_back(p[0], p[1], p[2]);
  }
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i) {
    mesh->GetCellPoints(i, corners);
    for (vtkIdType k = 0; k < 3; ++k) result.corners.push_back(static_cast<std::uint32_t>(corners->GetId(k)));
  }
  return result;
}

}  // namespace isolux::bench
