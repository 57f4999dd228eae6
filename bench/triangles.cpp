#include "bench/triangles.h"

#include <algorithm>

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkMassProperties.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace isolux::bench {

namespace {

vtkSmartPointer<vtkPolyData> meshOf(const volume::Grid& grid, double isovalue) {
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
  return edges->GetOutput();
}

}  // namespace

MeshSize massOf(const volume::Grid& grid, double isovalue) {
  const vtkSmartPointer<vtkPolyData> mesh = meshOf(grid, isovalue);
  vtkPoints* const points = mesh->GetPoints();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i) {
    double p[3];
    points->GetPoint(i, p);
    const glm::dvec4 world = grid.geometry().worldFromVoxel * glm::dvec4(p[0], p[1], p[2], 1.0);
    points->SetPoint(i, world.x, world.y, world.z);
  }
  vtkNew<vtkMassProperties> mass;
  mass->SetInputData(mesh);
  return {mass->GetSurfaceArea(), mass->GetVolume()};
}

Triangles trianglesOf(const volume::Grid& grid, double isovalue) {
  const vtkSmartPointer<vtkPolyData> mesh = meshOf(grid, isovalue);
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
