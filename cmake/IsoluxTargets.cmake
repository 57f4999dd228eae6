# How every Isolux library, test and benchmark is compiled.

add_library(isolux_warnings INTERFACE)
target_compile_options(isolux_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wold-style-cast -Wcast-align
  -Woverloaded-virtual -Wnull-dereference -Wimplicit-fallthrough -Wformat=2
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>  # GCC 12 sees overlaps in "x" + std::string (GCC bug 105651)
  # Files that are compiled as one hide each other's names; GCC 12 sees null pointers in their vectors, and takes what a
  # test's file keeps to itself for a header's.
  $<$<BOOL:${ISOLUX_UNITY}>:-Wno-shadow -Wno-null-dereference -Wno-subobject-linkage>
  $<$<BOOL:${ISOLUX_WERROR}>:-Werror>)

add_library(isolux_options INTERFACE)
# No contraction of a*b+c: results must not depend on the compiler's choice of fused operations.
target_compile_options(isolux_options INTERFACE -ffp-contract=off)
target_include_directories(isolux_options INTERFACE ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/generated)
target_link_libraries(isolux_options INTERFACE isolux_warnings)
if(ISOLUX_SANITIZE)
  target_compile_options(isolux_options INTERFACE -fsanitize=${ISOLUX_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(isolux_options INTERFACE -fsanitize=${ISOLUX_SANITIZE})
endif()
if(ISOLUX_SANITIZE STREQUAL thread)
  # Before oneTBB's own headers: tests/tsan/tbb/stand_in.h says why.
  target_include_directories(isolux_options BEFORE INTERFACE ${PROJECT_SOURCE_DIR}/tests/tsan)
endif()
if(ISOLUX_FUZZ)
  target_compile_options(isolux_options INTERFACE -fsanitize=fuzzer-no-link)
endif()

# isolux_library(NAME SOURCES ... LINK ...): one directory = one library = one namespace.
function(isolux_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
  add_library(isolux_${name} STATIC ${ARG_SOURCES})
  add_library(isolux::${name} ALIAS isolux_${name})
  target_link_libraries(isolux_${name} PUBLIC isolux_options ${ARG_LINK})
  isolux_compile_by_folder(isolux_${name} ${ARG_SOURCES})
endfunction()

# isolux_compile_by_folder(TARGET SOURCE ...): with ISOLUX_UNITY all sources of a folder are compiled as one.
function(isolux_compile_by_folder target)
  if(NOT ISOLUX_UNITY)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  foreach(source IN LISTS ARGN)
    cmake_path(ABSOLUTE_PATH source OUTPUT_VARIABLE path)
    cmake_path(RELATIVE_PATH path BASE_DIRECTORY ${PROJECT_SOURCE_DIR})
    cmake_path(GET path PARENT_PATH folder)
    string(REPLACE / _ group ${folder})
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${group})
  endforeach()
endfunction()

# isolux_layer(NAME LINK ...): the library of this directory from all its .cpp files (subfolders included).
function(isolux_layer name)
  cmake_parse_arguments(ARG "" "" "LINK;EXCLUDE" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  foreach(excluded IN LISTS ARG_EXCLUDE)
    list(REMOVE_ITEM sources ${CMAKE_CURRENT_SOURCE_DIR}/${excluded})
  endforeach()
  if(sources)
    isolux_library(${name} SOURCES ${sources} LINK ${ARG_LINK})
  else()  # headers only
    add_library(isolux_${name} INTERFACE)
    add_library(isolux::${name} ALIAS isolux_${name})
    target_link_libraries(isolux_${name} INTERFACE isolux_options ${ARG_LINK})
  endif()
endfunction()

# isolux_tests(LAYER [BARE] [FOLDERS ...] [EXCLUDE ...] LINK ...): one GoogleTest program from all sources in tests/LAYER
# (or FOLDERS of tests/), found by CTest test by test. EXCLUDE: folders of tests/ that are left out. BARE: without
# tests/support, which needs the volume. Tests read the shared data folder from ISOLUX_DATA (tests/support/test_data.h).
function(isolux_tests layer)
  cmake_parse_arguments(ARG "BARE" "" "LINK;FOLDERS;EXCLUDE" ${ARGN})
  set(sources)
  if(NOT ARG_FOLDERS)
    set(ARG_FOLDERS ${layer})
  endif()
  foreach(folder IN LISTS ARG_FOLDERS)
    file(GLOB_RECURSE found CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*.cpp)
    list(APPEND sources ${found})
  endforeach()
  foreach(folder IN LISTS ARG_EXCLUDE)
    list(FILTER sources EXCLUDE REGEX "^${CMAKE_CURRENT_SOURCE_DIR}/${folder}/")
  endforeach()
  add_executable(${layer}_tests ${sources})
  isolux_compile_by_folder(${layer}_tests ${sources})
  target_link_libraries(${layer}_tests PRIVATE ${ARG_LINK} GTest::gtest_main GTest::gmock)
  if(NOT ARG_BARE)
    target_link_libraries(${layer}_tests PRIVATE isolux_test_support)
  endif()
  gtest_discover_tests(${layer}_tests TEST_PREFIX ${layer}. DISCOVERY_TIMEOUT 60
    PROPERTIES LABELS "${layer}" TIMEOUT 300)
endfunction()
