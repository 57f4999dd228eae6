# Every third-party library, found once, and only where it is needed. docs/developers/dependencies.md says why each is here.

# --- the program and its readers
find_package(Threads REQUIRED)
find_package(PkgConfig REQUIRED)
find_package(ZLIB REQUIRED)
find_package(BZip2 REQUIRED)
find_package(PNG REQUIRED)
pkg_check_modules(OpenEXR REQUIRED IMPORTED_TARGET OpenEXR)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(TBB REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
pkg_check_modules(libzstd REQUIRED IMPORTED_TARGET libzstd)
pkg_check_modules(libtiff REQUIRED IMPORTED_TARGET libtiff-4)
pkg_check_modules(liblz4 REQUIRED IMPORTED_TARGET liblz4)
pkg_check_modules(blosc REQUIRED IMPORTED_TARGET blosc)
pkg_check_modules(hdf5 REQUIRED IMPORTED_TARGET hdf5-serial)
pkg_check_modules(glm REQUIRED IMPORTED_TARGET glm)
pkg_check_modules(freetype2 REQUIRED IMPORTED_TARGET freetype2)
pkg_check_modules(libhwy REQUIRED IMPORTED_TARGET libhwy)
# OpenImageIO's CMake package wants OpenCV's headers; its pkg-config file does not.
pkg_check_modules(OpenImageIO REQUIRED IMPORTED_TARGET OpenImageIO)
set(vtk_modules CommonCore CommonDataModel CommonExecutionModel FiltersCore IOImage IOXML)  # IOImage: vtk-dicom's
if(ISOLUX_BENCH)  # what Isolux is compared with
  list(APPEND vtk_modules RenderingCore RenderingOpenGL2 RenderingVolume RenderingVolumeOpenGL2)
endif()
find_package(VTK 9.1 REQUIRED COMPONENTS ${vtk_modules})
find_package(DICOM REQUIRED)  # vtk-dicom
find_package(Qt6 6.4 REQUIRED COMPONENTS Core Gui Widgets OpenGLWidgets Svg Charts)

if(ISOLUX_PYTHON)
  # Debian's Python, for which its pybind11 and NumPy are, whatever other one is on PATH.
  set(Python_EXECUTABLE /usr/bin/python3 CACHE FILEPATH "The Python that the module is for")
  find_package(Python 3.11 REQUIRED COMPONENTS Interpreter Development.Module NumPy)
  find_package(pybind11 2.10 REQUIRED)
endif()

# Third-party headers are not ours to warn about.
add_library(isolux_glm INTERFACE)
target_link_libraries(isolux_glm INTERFACE PkgConfig::glm)
target_compile_definitions(isolux_glm INTERFACE GLM_FORCE_CTOR_INIT GLM_ENABLE_EXPERIMENTAL)

# --- tests
if(ISOLUX_TESTS OR ISOLUX_BENCH)  # tests/support, which benchmarks use, too
  find_package(GTest REQUIRED)
endif()
if(ISOLUX_TESTS)
  find_package(Qt6 6.4 REQUIRED COMPONENTS Test)
  find_program(XVFB Xvfb REQUIRED)
  # Teem's own CMake package changes the flags of the whole project.
  find_path(TEEM_INCLUDE_DIR teem/gage.h REQUIRED)
  find_library(TEEM_LIBRARY teem REQUIRED)
  add_library(isolux_teem INTERFACE)
  target_include_directories(isolux_teem SYSTEM INTERFACE ${TEEM_INCLUDE_DIR})
  target_link_libraries(isolux_teem INTERFACE ${TEEM_LIBRARY})
endif()

# --- benchmarks
if(ISOLUX_BENCH)
  find_package(benchmark REQUIRED)
  find_package(embree REQUIRED)  # 3 or 4: bench/embree_scene.h
endif()
