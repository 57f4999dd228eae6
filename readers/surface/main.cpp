// isolux-reader-surface: meshes of isosurfaces, which VTK extracts.
#include <vtkVersion.h>

#include "readers/serve.h"
#include "readers/surface/flying_edges.h"

int main() {
  using namespace isolux;
  const auto versions = [] { return std::string("VTK ") + vtkVersion::GetVTKVersion() + " (flying edges)"; };
  return readers::serve({.contour = readers::flyingEdges, .versions = versions});
}
