// isolux-reader-surface: meshes of isosurfaces, which VTK extracts.
#include <vtkVersion.h>

#include "readers/serve.h"
#include "readers/surface/flying_edges.h"

int main() {
  using namespace isolux;
  readers::Abilities abilities;
  abilities.contour = readers::flyingEdges;
  abilities.versions = [] { return std::string("VTK ") + vtkVersion::GetVTKVersion() + " (flying edges)"; };
  return readers::serve(abilities);
}
