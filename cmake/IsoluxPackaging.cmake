# `cpack` in the build folder makes isolux_VERSION_ARCHITECTURE.deb (./dev deb).
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_CONTACT "The Isolux developers <isolux@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "explore scans and simulations as isosurfaces")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
  "Draws isosurfaces of voxel volumes directly from the voxels, in a window or\noffscreen, with global illumination. Reads NIfTI, MetaImage, NRRD, DICOM,\nVTK, TIFF and raw files, and triangle meshes.")
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# What is opened while running, so that no linker knows: EGL and Mesa's drivers, which draw without a GPU, too. OSMesa,
# taken before them there, is none of Mesa 25.1 and later.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libegl1, libgl1-mesa-dri")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libosmesa6, fonts-dejavu-core, qt6-translations-l10n, qt6-wayland, shared-mime-info")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "gnuplot-nox, ffmpeg, openmpi-bin")  # plots of `isolux study`, movies, bakes over MPI
# The Python module is a package of its own, of the same run.
if(ISOLUX_PYTHON)
  set(CPACK_DEB_COMPONENT_INSTALL ON)
  set(CPACK_COMPONENTS_ALL Unspecified python)
  set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_NAME isolux)
  set(CPACK_COMPONENT_PYTHON_DESCRIPTION
    "isosurfaces in Python\nThe module isolux: pictures, exact first hits with error bounds, and curvature in\ndouble precision, of NumPy arrays and volume files.")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-isolux)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  # The module is compiled for one Python, the one that was found.
  math(EXPR next_minor "${Python_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "isolux (= ${PROJECT_VERSION}), python3 (>= ${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}), python3 (<< ${Python_VERSION_MAJOR}.${next_minor}), python3-numpy, libegl1, libgl1-mesa-dri")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS " ")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-matplotlib, python3-nibabel, ffmpeg")
endif()
include(CPack)
