// isolux._isolux: what python/isolux has of C++. Users see python/isolux only, which says what arguments
// mean.
#include <cstring>
#include <new>
#include <sstream>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "app/documents/session.h"
#include "app/documents/session_accuracy.h"
#include "app/files/image_io.h"
#include "app/report/machine_report.h"
#include "app/report/settings_report.h"
#include "app/runtime/program_store.h"
#include "app/version.h"
#include "base/error.h"
#include "base/number_text.h"
#include "python/questions.h"
#include "scene/settings/choice_names.h"
#include "volume/read/process/reader_process.h"

namespace isolux::python {

namespace {

namespace py = pybind11;
namespace fs = std::filesystem;
using base::Error;
using base::ErrorKind;

// The line that the command prints, as the exception that Python has for it.
void setError(const Error& error) {
  const ErrorKind kind = error.kind();
  PyObject* const type = kind == ErrorKind::graphics                         ? PyExc_RuntimeError
                         : kind == ErrorKind::memory                         ? PyExc_MemoryError
                         : kind == ErrorKind::interrupted                    ? PyExc_KeyboardInterrupt
                         : kind == ErrorKind::input && !error.file().empty() ? PyExc_OSError
                                                                             : PyExc_ValueError;
  ::PyErr_SetString(type, error.what());
}

void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(std::move(thrown));
  } catch (const Error& error) {
    setError(error);
  } catch (const std::bad_alloc&) {
    ::PyErr_SetString(PyExc_MemoryError, "not enough memory");
  } catch (const fs::filesystem_error& error) {
    ::PyErr_SetString(PyExc_OSError, error.what());
  } catch (const std::system_error& error) {
    ::PyErr_SetString(PyExc_MemoryError,
                      ("the system provides no more threads or memory: " + error.code().message()).c_str());
  }
}

// Memory that NumPy sees and the owner frees.
template <class T, class Element>
py::array viewOf(std::vector<T>&& values, std::vector<py::ssize_t> shape) {
  auto kept = std::make_unique<std::vector<T>>(std::move(values));
  const auto* data = reinterpret_cast<const Element*>(kept->data());
  const py::capsule owner(kept.release(), [](void* held) { delete static_cast<std::vector<T>*>(held); });
  return py::array_t<Element>(std::move(shape), data, owner);
}

template <class T>
py::array numbers(std::vector<T>&& values, std::vector<py::ssize_t> rest = {}) {
  rest.insert(rest.begin(), static_cast<py::ssize_t>(values.size()));
  return viewOf<T, double>(std::move(values), std::move(rest));
}

std::vector<glm::dvec3> pointsOf(const py::array_t<double, py::array::c_style>& rows) {
  if (rows.ndim() != 2 || rows.shape(1) != 3) base::throwUsage("", "points", "are rows of x, y, z");
  static_assert(sizeof(glm::dvec3) == 3 * sizeof(double));
  std::vector<glm::dvec3> points(static_cast<std::size_t>(rows.shape(0)));
  std::memcpy(static_cast<void*>(points.data()), rows.data(), points.size() * sizeof(glm::dvec3));
  return points;
}

glm::dvec3 vectorOf3(const std::array<double, 3>& v) {
  return {v[0], v[1], v[2]};
}

py::dict hitsOf(Core& core, const app::SceneOptions& options,
                const py::array_t<double, py::array::c_style>& origins,
                const py::array_t<double, py::array::c_style>& directions, const py::object& told) {
  Hits found = hits(core, options, pointsOf(origins), pointsOf(directions), told);
  py::dict dict;
  dict["t"] = numbers(std::move(found.t));
  dict["position"] = numbers(std::move(found.position), {3});
  dict["normal"] = numbers(std::move(found.normal), {3});
  dict["error"] = numbers(std::move(found.error));
  dict["value_error"] = numbers(std::move(found.valueError));
  const auto count = static_cast<py::ssize_t>(found.entering.size());
  dict["entering"] = viewOf<std::uint8_t, std::uint8_t>(std::move(found.entering), {count});
  return dict;
}

py::dict probedOf(Core& core, const app::SceneOptions& options,
                  const py::array_t<double, py::array::c_style>& points, const py::object& told) {
  Probed found = probe(core, options, pointsOf(points), told);
  py::dict dict;
  dict["value"] = numbers(std::move(found.value));
  dict["gradient"] = numbers(std::move(found.gradient), {3});
  dict["normal"] = numbers(std::move(found.normal), {3});
  dict["hessian"] = numbers(std::move(found.hessian), {3, 3});
  dict["kappa"] = numbers(std::move(found.kappa), {2});
  dict["confidence"] = numbers(std::move(found.confidence));
  dict["scale_mm"] = found.scaleMm;
  return dict;
}

// A view of an image whose picture stays as long as it does; read-only.
template <class T>
py::array imageView(const std::vector<T>& values, glm::ivec2 size, int channels, const py::object& owner) {
  std::vector<py::ssize_t> shape{size.y, size.x};
  if (channels > 1) shape.push_back(channels);
  py::array_t<T> array(std::move(shape), values.data(), owner);
  array.attr("flags").attr("writeable") = false;
  return array;
}

py::dict imagesOf(const py::object& self) {
  const auto& picture = self.cast<const Picture&>();
  py::dict dict;
  for (const render::AovImage& image : picture.images)
    for (const render::AovInfo& info : render::aovs())
      if (info.aov == image.aov) dict[info.name] = imageView(image.values, image.size, image.channels, self);
  for (const app::FloatChannel& channel : picture.errors)
    if (!channel.values.empty())
      dict[channel.name.c_str()] = imageView(channel.values, picture.size, 1, self);
  return dict;
}

std::string sessionOf(const Picture& picture, const fs::path& folder) {
  const std::string text = app::sessionText(picture.scene, folder);
  return picture.accuracy ? app::sessionWithAccuracy(text, *picture.accuracy) : text;
}

void save(const Picture& picture, const std::string& name) {
  const fs::path file(name);
  app::OutputGuard guard;
  if (!picture.scene.source.path.empty()) guard.reads(picture.scene);
  std::error_code ignored;
  if (fs::is_regular_file(picture.opened, ignored))
    guard.reads(picture.opened, "what the volume was opened from");
  app::checkOutput(guard, name, "save");
  const std::string session = sessionOf(picture, file.parent_path());
  if (file.extension() == ".png") {
    if (picture.color.rgba.empty()) base::throwUsage(name, "", "no image: image=False");
    app::writePng(picture.color, file, session);
  } else if (file.extension() != ".exr") {
    base::throwUsage(name, "", "the name of an image must end in .png or .exr");
  } else if (!picture.exr.empty()) {
    app::writeExr(picture.size, picture.exr, file, session);
  } else if (!picture.images.empty() || picture.linear) {
    app::writeExr(picture.images.empty() ? &*picture.linear : nullptr, picture.images, file, session);
  } else {
    base::throwUsage(name, "", ".exr files require aovs= or linear=True");
  }
}

void defineWishes(py::module_& module) {
  py::class_<app::SceneOptions>(module, "Scene")
      .def(py::init<>())
      .def_readwrite("session", &app::SceneOptions::session)
      .def_readwrite("assignments", &app::SceneOptions::assignments)
      .def_readwrite("preset", &app::SceneOptions::preset)
      .def_readwrite("shift", &app::SceneOptions::shift)
      .def_property(
          "view", [](const app::SceneOptions& scene) { return scene.camera.view; },
          [](app::SceneOptions& scene, const std::string& view) { scene.camera.view = view; })
      .def("camera", [](app::SceneOptions& scene, double azimuth, double elevation, double roll, double zoom,
                        const std::string& fit) {
        scene.camera.azimuth = azimuth;
        scene.camera.elevation = elevation;
        scene.camera.roll = roll;
        scene.camera.zoom = zoom;
        if (fit == "surface") scene.camera.fit = app::Framing::surface;
        if (fit == "volume") scene.camera.fit = app::Framing::volume;
      });
  py::class_<PictureRequest>(module, "Wish")
      .def(py::init<>())
      .def_readwrite("scene", &PictureRequest::scene)
      .def_property(
          "size", [](const PictureRequest&) { return py::none(); },
          [](PictureRequest& request, const std::array<int, 2>& size) {
            request.size = app::parseSize(std::to_string(size[0]) + "x" + std::to_string(size[1]));
          })
      .def_readwrite("images", &PictureRequest::images)
      .def_readwrite("color", &PictureRequest::color)
      .def_readwrite("linear", &PictureRequest::linear)
      .def_readwrite("explain", &PictureRequest::explain)
      .def_readwrite("accuracy", &PictureRequest::accuracy)
      .def_readwrite("light_around", &PictureRequest::lightAround)
      .def_readwrite("light", &PictureRequest::light)
      .def_property(
          "context", [](const PictureRequest&) { return py::none(); },
          [](PictureRequest& request, const std::string& name) {
            request.context = render::contextChoiceNamed(name);
          });
}

void definePicture(py::module_& module) {
  py::class_<Picture, std::shared_ptr<Picture>>(module, "Picture")
      .def_property_readonly(
          "size", [](const Picture& picture) { return py::make_tuple(picture.size.x, picture.size.y); })
      .def_property_readonly("transparent", [](const Picture& picture) { return picture.color.transparent; })
      .def("rgba",
           [](const py::object& self) -> py::object {
             const auto& color = self.cast<const Picture&>().color;
             if (color.rgba.empty()) return py::none();
             return imageView(color.rgba, color.size, 4, self);
           })
      .def("linear",
           [](const py::object& self) -> py::object {
             const auto& linear = self.cast<const Picture&>().linear;
             if (!linear) return py::none();
             return imageView(linear->rgba, linear->size, 4, self);
           })
      .def("images", imagesOf)
      .def_readonly("stats", &Picture::stats)
      .def_readonly("notes", &Picture::notes)
      .def(
          "session", [](const Picture& picture) { return sessionOf(picture, fs::current_path()); },
          py::call_guard<py::gil_scoped_release>())
      .def("save", save, py::call_guard<py::gil_scoped_release>())
      .def("png", [](const Picture& picture) {
        std::string bytes;
        {
          const py::gil_scoped_release released;
          bytes = app::pngBytes(picture.color, sessionOf(picture, fs::current_path()));
        }
        return py::bytes(bytes);
      });
}

py::dict factsOf(const Core& core) {
  const volume::PreparedVolume& prepared = *core.prepared();
  const volume::Volume& volume = prepared.volume;
  const volume::Grid& grid = prepared.grid();
  const volume::GridGeometry& geometry = grid.geometry();
  const auto three = [](glm::dvec3 v) { return py::make_tuple(v.x, v.y, v.z); };
  const glm::dmat3 directions = geometry.directions();
  py::dict dict;
  dict["name"] = volume.name;
  dict["format"] = volume.format;
  dict["dims"] = py::make_tuple(grid.dims().x, grid.dims().y, grid.dims().z);
  dict["type"] = std::string(nameOf(volume.fileType));
  dict["stored_type"] = std::string(nameOf(grid.storedType()));
  dict["spacing_mm"] = three(geometry.spacingMm());
  dict["origin_mm"] = three(geometry.originMm());
  dict["directions"] = py::make_tuple(three(directions[0]), three(directions[1]), three(directions[2]));
  dict["unit"] = volume.unit;
  dict["kind"] = scene::choiceName(prepared.kind.kind);
  dict["range"] = py::make_tuple(grid.minimum(), grid.maximum());
  dict["missing"] = grid.missingCount();
  dict["suggested_isovalue"] = prepared.facts.suggestedIsovalue;
  dict["data_hash"] = base::hexText(grid.hash());
  dict["warnings"] = volume.warnings;
  return dict;
}

void defineVolume(py::module_& module) {
  py::class_<Core, std::shared_ptr<Core>>(module, "Core")
      .def_static("open", &Core::open)
      .def_static(
          "of_array",
          [](const py::array& array, const std::array<double, 3>& spacing,
             const std::array<double, 3>& origin, const std::array<std::array<double, 3>, 3>& columns,
             const std::string& name, const std::string& unit, bool anatomical, const py::object& told) {
            return Core::ofArray(
                array, vectorOf3(spacing), vectorOf3(origin),
                glm::dmat3(vectorOf3(columns[0]), vectorOf3(columns[1]), vectorOf3(columns[2])), name, unit,
                anatomical, told);
          })
      .def("facts", factsOf)
      .def("render",
           [](Core& core, const PictureRequest& request, const py::object& told) {
             return std::const_pointer_cast<Picture>(core.render(request, told));
           })
      .def("hits", hitsOf)
      .def("probe", probedOf)
      .def("measure", measure)
      .def("measure_labels", measureLabels)
      .def("bake",
           [](Core& core, const app::SceneOptions& options, const std::string& file, bool overwrite,
              bool mixArithmetic, const py::object& told) {
             const Baked baked = core.bake(options, file, overwrite, mixArithmetic, told);
             return py::make_tuple(baked.stats, baked.notes);
           })
      .def("study",
           [](Core& core, const app::SceneOptions& options, const std::string& qualities,
              const std::array<int, 2>& size, int repeat, const py::object& told) {
             return core.study(options, qualities, glm::ivec2(size[0], size[1]), repeat, told);
           })
      .def("forget_light", &Core::forgetLight);
}

std::string doctor(const py::object& told) {
  const auto text = std::make_shared<std::ostringstream>();
  VolumeThread desk([] {});
  desk.run([text](base::Progress& progress) { app::printDoctor(*text, "", progress); }, told);
  return text->str();
}

}  // namespace

}  // namespace isolux::python

PYBIND11_MODULE(_isolux, module) {
  using namespace isolux::python;
  namespace py = pybind11;
  isolux::app::storePrograms();
  module.doc() = "What isolux has of C++; use the module isolux.";
  py::register_exception_translator(translate);
  defineWishes(module);
  definePicture(module);
  defineVolume(module);
  module.def("version", [] { return std::string(isolux::app::version()); });
  module.def("settings", [] { return isolux::app::settingsJson("").dump(); });
  module.def("doctor", doctor);
  module.def("image_names", [] { return isolux::app::imageNames(); });
  module.def("set_reader_folder", [](const std::string& folder) { isolux::volume::setReaderFolder(folder); });
  // Before Python goes: what volumes leave behind may still be ending.
  module.def("await_ends", [](double seconds) {
    const py::gil_scoped_release released;
    return isolux::base::awaitDestroyed(seconds);
  });
  module.def("end", endPython);
}
