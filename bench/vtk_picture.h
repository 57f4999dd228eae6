// VTK drawing the same scene: its GPU isosurface mapper, or the mesh of its flying edges. Benchmarks only.
//
// Debian's VTK opens its windows through GLX, so all of this needs an X display (Xvfb is one). Nothing is
// shown: VTK draws into framebuffers of its own.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bench/subjects.h"
#include "render/gl/gl.h"
#include "scene/scene.h"

namespace isolux::bench {

// Why VTK cannot draw here, if so.
std::optional<std::string> vtkObstacle();
std::string vtkVersion();  // and how its filters are threaded

// A GL context as VTK makes it, for Isolux to draw in: so that both are sure to use one driver.
class VtkContext {
 public:
  VtkContext();
  ~VtkContext();
  void makeCurrent();
  std::shared_ptr<const render::Gl> gl() const { return gl_; }

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
  std::shared_ptr<const render::Gl> gl_;
};

enum class VtkWay {
  gpu_mapper,  // vtkOpenGLGPUVolumeRayCastMapper, isosurface blending, a sample every half voxel
  mesh,        // vtkFlyingEdges3D with normals, vtkPolyDataMapper
};

// What is on screen and where: row 0 is the top row.
struct VtkSurface {
  std::vector<bool> covered;
  std::vector<double> depth;  // of the hit along the view direction, mm; where covered
};

class VtkPicture {
 public:
  // `scene` must be resolved; its camera, isovalue and material are used.
  VtkPicture(VtkWay way, VolumePointer volume, const scene::Scene& scene, glm::ivec2 size);
  ~VtkPicture();

  void setCamera(const scene::Camera& camera);
  void setIsovalue(double isovalue);  // data units
  void extract();                     // the mesh, without drawing it; nothing to do for the mapper
  void render();                      // returns when GL has finished
  VtkSurface surface();               // of the camera and isovalue set
  std::string driver();               // GL_RENDERER of its context
  std::size_t triangles() const;      // of the mesh

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace isolux::bench
