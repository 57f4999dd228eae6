#include "readers/surface/flying_edges.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

namespace isolux::readers {

volume::TriangleMesh flyingEdges(std::span<const float> samples, glm::ivec3 dims, base::Progress& progress) {
  progress.throwIfStopped();
  vtkNew<vtkFloatArray> values;
  // VTK does not write into its input.
  values->SetArray(const_cast<float*>(samples.data()), static_cast<vtkIdType>(samples.size()), 1);
  vtkNew<vtkImageData> image;
  image->SetDimensions(dims.x, dims.y, dims.z);
  image->GetPointData()->SetScalars(values);
  vtkNew<vtkFlyingEdges3D> filter;
  filter->SetInputData(image);
  filter->SetValue(0, 0.0);
  filter->ComputeNormalsOff();
  filter->ComputeScalarsOff();
  filter->Update();
  vtkPolyData* const found = filter->GetOutput();

  volume::TriangleMesh mesh;
  mesh.points.reserve(static_cast<std::size_t>(found->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < found->GetNumberOfPoints(); ++i) {
    double point[3];
    found->GetPoint(i, point);
    mesh.points.emplace_back(point[0], point[1], point[2]);
  }
  mesh.triangles.reserve(static_cast<std::size_t>(found->GetNumberOfPolys()));
  vtkIdType count = 0;
  const vtkIdType* corners = nullptr;
  for (auto cell = vtk::TakeSmartPointer(found->GetPolys()->NewIterator()); !cell->IsDoneWithTraversal();
       cell->GoToNextCell()) {
    cell->GetCurrentCell(count, corners);
    mesh.triangles.emplace_back(static_cast<int>(corners[0]), static_cast<int>(corners[1]),
                                static_cast<int>(corners[2]));
  }
  return mesh;
}

}  // namespace isolux::readers
