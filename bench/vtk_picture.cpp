#include "bench/vtk_picture.h"

#include <dlfcn.h>

#include <algorithm>
#include <cstdlib>
#include <type_traits>

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkContourValues.h>
#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkOpenGLGPUVolumeRayCastMapper.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSMP.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVersion.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include "base/error.h"
#include "scene/camera.h"

namespace isolux::bench {

namespace {

// No light and no material of ours is pure green: what is pure green was not drawn.
constexpr double background[3] = {0.0, 1.0, 0.0};

vtkSmartPointer<vtkOpenGLRenderWindow> makeWindow(glm::ivec2 size) {
  const auto made = vtkSmartPointer<vtkRenderWindow>::New();
  vtkSmartPointer<vtkOpenGLRenderWindow> window = vtkOpenGLRenderWindow::SafeDownCast(made);
  if (!window) throw base::Error(base::ErrorKind::graphics, "", "VTK", "it offers no OpenGL window");
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(size.x, size.y);
  return window;
}

// The voxels as they are in the grid (not copied) with its spacing; where they lie is poseOf().
vtkSmartPointer<vtkImageData> imageOf(const volume::Grid& grid) {
  auto image = vtkSmartPointer<vtkImageData>::New();
  const glm::ivec3 n = grid.dims();
  const glm::dvec3 spacing = grid.geometry().spacingMm();
  image->SetDimensions(n.x, n.y, n.z);
  image->SetSpacing(spacing.x, spacing.y, spacing.z);
  std::visit(
      [&](const auto& voxels) {
        using T = typename std::decay_t<decltype(voxels)>::value_type;
        const auto array = vtkSmartPointer<vtkAOSDataArrayTemplate<T>>::New();
        constexpr int keep = 1;  // VTK does not own them and only reads
        array->SetArray(const_cast<T*>(voxels.data()), static_cast<vtkIdType>(voxels.size()), keep);
        array->SetName("values");
        image->GetPointData()->SetScalars(array);
      },
      grid.voxels());
  return image;
}

// World from the image's millimetres: rotation and origin.
vtkSmartPointer<vtkMatrix4x4> poseOf(const volume::Grid& grid) {
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  const glm::dmat3 axes = grid.geometry().directions();
  const glm::dvec3 origin = grid.geometry().originMm();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) matrix->SetElement(row, column, axes[column][row]);
    matrix->SetElement(row, 3, origin[row]);
  }
  return matrix;
}

}  // namespace

std::optional<std::string> vtkObstacle() {
  const char* display = std::getenv("DISPLAY");
  if (!display || !*display)
    return "VTK needs an X display and DISPLAY is not set (./dev bench gives it one)";
  return std::nullopt;
}

std::string vtkVersion() {
  return std::string("VTK ") + vtkVersion::GetVTKVersion() + " (threads by " + VTK_SMP_BACKEND + ")";
}

struct VtkContext::Parts {
  vtkSmartPointer<vtkOpenGLRenderWindow> window = makeWindow({8, 8});
};

VtkContext::VtkContext() : parts_(std::make_unique<Parts>()) {
  parts_->window->Initialize();
  makeCurrent();
  void* library = dlopen("libGL.so.1", RTLD_NOW | RTLD_LOCAL);
  using GetProcAddress = void (*(*)(const unsigned char*))();
  const auto find =
      library ? reinterpret_cast<GetProcAddress>(dlsym(library, "glXGetProcAddressARB")) : nullptr;
  if (!find) throw base::Error(base::ErrorKind::graphics, "", "GLX", "libGL.so.1 cannot be opened");
  gl_ = render::Gl::load([&](const char* name) {
    return reinterpret_cast<void*>(find(reinterpret_cast<const unsigned char*>(name)));
  });
}
VtkContext::~VtkContext() = default;

void VtkContext::makeCurrent() {
  parts_->window->MakeCurrent();
}

struct VtkPicture::Parts {
  VtkWay way;
  VolumePointer volume;
  vtkSmartPointer<vtkOpenGLRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> rayMapper;
  vtkNew<vtkVolume> rayVolume;
  vtkNew<vtkFlyingEdges3D> edges;
  vtkNew<vtkPolyDataMapper> meshMapper;
  vtkNew<vtkActor> meshActor;

  void addRayMapper(const scene::Scene& scene);
  void addMesh(const scene::Scene& scene);
  std::vector<double> windowDepth();  // 0 near to 1 far; row 0 at the bottom
};

void VtkPicture::Parts::addRayMapper(const scene::Scene& scene) {
  const glm::dvec3 spacing = volume->grid().geometry().spacingMm(), albedo = scene.surfaces.front().albedo;
  rayMapper->SetInputData(imageOf(volume->grid()));
  rayMapper->SetBlendModeToIsoSurface();
  rayMapper->SetAutoAdjustSampleDistances(0);
  rayMapper->SetUseJittering(0);
  rayMapper->SetSampleDistance(static_cast<float>(0.5 * std::min({spacing.x, spacing.y, spacing.z})));
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.0, albedo.r, albedo.g, albedo.b);
  vtkNew<vtkPiecewiseFunction> opaque;
  opaque->AddPoint(0.0, 1.0);
  vtkVolumeProperty* property = rayVolume->GetProperty();
  property->SetColor(color);
  property->SetScalarOpacity(opaque);
  property->SetInterpolationTypeToLinear();
  property->ShadeOn();
  property->SetAmbient(scene.look.ambient);
  property->SetDiffuse(1.0);
  property->SetSpecular(scene.look.specular);
  property->SetSpecularPower(scene.look.shininess);
  rayVolume->SetMapper(rayMapper);
  rayVolume->SetUserMatrix(poseOf(volume->grid()));
  renderer->AddVolume(rayVolume);
}

void VtkPicture::Parts::addMesh(const scene::Scene& scene) {
  const glm::dvec3 albedo = scene.surfaces.front().albedo;
  edges->SetInputData(imageOf(volume->grid()));
  edges->ComputeNormalsOn();
  edges->ComputeScalarsOff();
  meshMapper->SetInputConnection(edges->GetOutputPort());
  meshMapper->ScalarVisibilityOff();
  vtkProperty* property = meshActor->GetProperty();
  property->SetColor(albedo.r, albedo.g, albedo.b);
  property->SetAmbient(scene.look.ambient);
  property->SetDiffuse(1.0);
  property->SetSpecular(scene.look.specular);
  property->SetSpecularPower(scene.look.shininess);
  meshActor->SetMapper(meshMapper);
  meshActor->SetUserMatrix(poseOf(volume->grid()));
  renderer->AddActor(meshActor);
}

VtkPicture::VtkPicture(VtkWay way, VolumePointer volume, const scene::Scene& scene, glm::ivec2 size)
    : parts_(std::make_unique<Parts>()) {
  parts_->way = way;
  parts_->volume = std::move(volume);
  parts_->window = makeWindow(size);
  parts_->renderer->SetBackground(background);
  if (way == VtkWay::gpu_mapper)
    parts_->addRayMapper(scene);
  else
    parts_->addMesh(scene);
  parts_->window->AddRenderer(parts_->renderer);
  setIsovalue(scene.surfaces.front().value.value());
  setCamera(scene.camera);
}
VtkPicture::~VtkPicture() = default;

void VtkPicture::setCamera(const scene::Camera& camera) {
  const scene::CameraFrame frame = scene::frameOf(camera);
  const glm::dvec3 target = frame.eye - frame.back * frame.distance;
  vtkCamera* vtk = parts_->renderer->GetActiveCamera();
  vtk->SetPosition(frame.eye.x, frame.eye.y, frame.eye.z);
  vtk->SetFocalPoint(target.x, target.y, target.z);
  vtk->SetViewUp(frame.up.x, frame.up.y, frame.up.z);
  vtk->SetViewAngle(camera.fov);
  parts_->renderer->ResetCameraClippingRange();
}

void VtkPicture::setIsovalue(double isovalue) {
  const double stored = parts_->volume->grid().storedOfValue(isovalue);
  if (parts_->way == VtkWay::gpu_mapper)
    parts_->rayVolume->GetProperty()->GetIsoSurfaceValues()->SetValue(0, stored);
  else
    parts_->edges->SetValue(0, stored);
}

void VtkPicture::extract() {
  if (parts_->way == VtkWay::mesh) parts_->edges->Update();
}

void VtkPicture::render() {
  parts_->window->Render();
  parts_->window->WaitForCompletion();
}

std::vector<double> VtkPicture::Parts::windowDepth() {
  const int* size = window->GetSize();
  std::vector<double> depth(static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]));
  if (way == VtkWay::mesh) {
    vtkNew<vtkFloatArray> values;
    window->GetZbufferData(0, 0, size[0] - 1, size[1] - 1, values);
    for (std::size_t i = 0; i < depth.size(); ++i) depth[i] = values->GetValue(static_cast<vtkIdType>(i));
    return depth;
  }
  // The mapper leaves no depth in the window's buffer; it gives it when asked to draw into images.
  rayMapper->SetRenderToImage(1);
  window->Render();
  vtkNew<vtkImageData> image;
  rayMapper->GetDepthImage(image);
  rayMapper->SetRenderToImage(0);
  vtkDataArray* values = image->GetPointData()->GetScalars();
  for (std::size_t i = 0; i < depth.size(); ++i)
    depth[i] = values->GetComponent(static_cast<vtkIdType>(i), 0);
  return depth;
}

VtkSurface VtkPicture::surface() {
  Parts& parts = *parts_;
  render();
  const int* size = parts.window->GetSize();
  const auto width = static_cast<std::size_t>(size[0]), height = static_cast<std::size_t>(size[1]);
  vtkNew<vtkUnsignedCharArray> pixels;
  parts.window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels.Get(), 0);
  const std::vector<double> depth = parts.windowDepth();
  double near = 0.0, far = 0.0;
  parts.renderer->GetActiveCamera()->GetClippingRange(near, far);
  VtkSurface surface{std::vector<bool>(width * height), std::vector<double>(width * height)};
  for (std::size_t y = 0; y < height; ++y)
    for (std::size_t x = 0; x < width; ++x) {
      const std::size_t from = (height - 1 - y) * width + x, to = y * width + x;
      const unsigned char* rgb = pixels->GetPointer(static_cast<vtkIdType>(3 * from));
      surface.covered[to] = rgb[0] != 0 || rgb[1] != 255 || rgb[2] != 0;
      surface.depth[to] = near * far / (far - depth[from] * (far - near));
    }
  return surface;
}

std::string VtkPicture::driver() {
  render();
  const std::string text = parts_->window->ReportCapabilities();
  const std::string key = "OpenGL renderer string:";
  const std::size_t at = text.find(key);
  if (at == std::string::npos) return "unknown";
  const std::size_t begin = text.find_first_not_of(' ', at + key.size());
  return text.substr(begin, text.find('\n', begin) - begin);
}

std::size_t VtkPicture::triangles() const {
  return static_cast<std::size_t>(parts_->edges->GetOutput()->GetNumberOfPolys());
}

}  // namespace isolux::bench
