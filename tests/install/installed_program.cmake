# Installs BUILD into PREFIX and uses what is there: the launcher, the program, a reader, and what desktops read.
file(REMOVE_RECURSE ${PREFIX})

function(run)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${PREFIX} RESULT_VARIABLE status OUTPUT_VARIABLE output
    ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGN}\nended with ${status}:\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

function(expect pattern)
  if(NOT output MATCHES "${pattern}")
    message(FATAL_ERROR "no \"${pattern}\" in:\n${output}")
  endif()
endfunction()

file(MAKE_DIRECTORY ${PREFIX})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${PREFIX})
set(isolux ${PREFIX}/bin/isolux)

run(${isolux} --version)
expect("^isolux [0-9.]+\n$")
run(${isolux} phantom ball --size 16 --out ball.vti)
run(${isolux} info ball.vti)  # by a reader
expect("16")
run(${isolux} mesh ball.vti --out ball.stl)  # by another
run(${isolux} render phantom:ball:16 --size 64x48 --out ball.png)
file(READ ${PREFIX}/ball.png mark LIMIT 8 HEX)
if(NOT mark STREQUAL "89504e470d0a1a0a")
  message(FATAL_ERROR "ball.png is no PNG")
endif()

if(PYTHON)  # the module, which finds a reader, too
  run(${CMAKE_COMMAND} -E env PYTHONPATH=${PREFIX}/lib/python3/dist-packages ${PYTHON} -c
    "import isolux\nv = isolux.open('ball.vti')\nprint(v)\nv.render(look='lambert', size=(64, 48)).save('python.png')")
  expect("16 x 16 x 16 voxels .z, y, x.")
  if(NOT EXISTS ${PREFIX}/python.png)
    message(FATAL_ERROR "the module drew nothing")
  endif()
endif()

foreach(reader vtk dicom images hdf5 surface)
  if(NOT EXISTS ${PREFIX}/libexec/isolux/isolux-reader-${reader})
    message(FATAL_ERROR "isolux-reader-${reader} is not installed")
  endif()
endforeach()

if(NOT EXISTS ${PREFIX}/libexec/isolux/isolux-mpi.so)
  message(FATAL_ERROR "isolux-mpi.so is not installed")
endif()
set(ENV{OMPI_ALLOW_RUN_AS_ROOT} 1)
set(ENV{OMPI_ALLOW_RUN_AS_ROOT_CONFIRM} 1)
run(mpirun --oversubscribe --bind-to none -n 2 ${isolux} bake phantom:ball:16 --set gi.samples=4 --out light.vti --stats light.json)
file(READ ${PREFIX}/light.json output)
expect("ranks")

run(desktop-file-validate ${PREFIX}/share/applications/isolux.desktop)
run(update-mime-database ${PREFIX}/share/mime)
foreach(type x-isolux-session x-nifti x-metaimage x-nrrd x-vtk-image-data)
  if(NOT EXISTS ${PREFIX}/share/mime/application/${type}.xml)
    message(FATAL_ERROR "application/${type} is no file type")
  endif()
endforeach()
foreach(file share/icons/hicolor/scalable/apps/isolux.svg share/doc/isolux/copyright)
  if(NOT EXISTS ${PREFIX}/${file})
    message(FATAL_ERROR "${file} is not installed")
  endif()
endforeach()
file(READ ${PREFIX}/share/man/man1/isolux.1 output)
expect("^.TH ISOLUX 1")
