// isolux-reader-vtk: what VTK parses.
#include <vtkVersion.h>

#include "readers/serve.h"
#include "readers/vtk/vtk_files.h"

int main() {
  using namespace isolux;
  readers::Abilities abilities;
  abilities.volume = readers::decodeVti;
  abilities.mesh = readers::decodePolyData;
  abilities.versions = [] { return std::string("VTK ") + vtkVersion::GetVTKVersion(); };
  return readers::serve(abilities);
}
