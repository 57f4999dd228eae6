// isolux-reader-vtk: what VTK parses.
#include <vtkVersion.h>

#include "readers/serve.h"
#include "readers/vtk/vtk_files.h"

int main() {
  using namespace isolux;
  return readers::serve({.volume = readers::decodeVti, .mesh = readers::decodePolyData, .versions = [] {
                           return std::string("VTK ") + vtkVersion::GetVTKVersion();
                         }});
}
