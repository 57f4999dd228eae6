# How every Isolux library, test and benchmark is compiled.

add_library(isolux_warnings INTERFACE)
target_compile_options(isolux_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wold-style-cast -Wcast-align
  -Woverloaded-virtual -Wnull-dereference -Wimplicit-fallthrough -Wformat=2
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>  # GCC 12 sees overlaps in "x" + std::string (GCC bug 105651)
  # Files that are compiled as one hide each other's names; GCC 12 sees null pointers in their vectors, and takes what a
  # test's file keeps to itself for a header's.
  $<$<BOOL:${ISOLUX_UNITY}>:-Wno-shadow $<$<CXX_COMPILER_ID:GNU>:-Wno-null-dereference -Wno-subobject-linkage>>
  $<$<BOOL:${ISOLUX_WERROR}>:-Werror>)

add_library(isolux_options INTERFACE)
# No contraction of a*b+c: results must not depend on the compiler's choice of fused operations.
target_compile_options(isolux_options INTERFACE -ffp-contract=off)
target_include_directories(isolux_options INTERFACE ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/generated)
target_link_libraries(isolux_options INTERFACE isolux_warnings)
if(ISOLUX_SANITIZE)
  target_compile_options(isolux_options INTERFACE -fsanitize=${ISOLUX_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all
    # A third of the time of compiling, for what AddressSanitizer stops at as well, but for alignment; the fuzzers, by Clang,
    # keep them all.
    $<$<CXX_COMPILER_ID:GNU>:-fno-sanitize=null,alignment,object-size,vptr>)
  target_link_options(isolux_options INTERFACE -fsanitize=${ISOLUX_SANITIZE})
endif()
if(ISOLUX_SANITIZE STREQUAL thread)
  # Before oneTBB's own headers: tests/tsan/tbb/stand_in.h says why.
  target_include_directories(isolux_options BEFORE INTERFACE ${PROJECT_SOURCE_DIR}/tests/tsan)
endif()
if(ISOLUX_FUZZ)
  target_compile_options(isolux_options INTERFACE -fsanitize=fuzzer-no-link)
endif()

# How layers are compiled that wait for people and call the long loops of others, and how tests are, many lines that run
# once: -O1 is a quarter of the time less than -O2, -O0 half of what -O1 takes under sanitizers.
set(ISOLUX_WAITS -O1 CACHE STRING "Optimisation of what waits for people, and of tests")

# isolux_library(NAME SOURCES ... LINK ...): one directory = one library = one namespace.
function(isolux_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
  add_library(isolux_${name} STATIC ${ARG_SOURCES})
  add_library(isolux::${name} ALIAS isolux_${name})
  target_link_libraries(isolux_${name} PUBLIC isolux_options ${ARG_LINK})
  isolux_compile_together(isolux_${name} ${ARG_SOURCES})
endfunction()

# isolux_compile_together(TARGET SOURCE ...): with ISOLUX_UNITY sources are compiled as one, folder after folder, about
# ISOLUX_UNITY_FILES of them: reading the headers once costs as much as compiling some ten sources. So names in the
# anonymous namespaces of neighbouring folders must differ.
set(ISOLUX_UNITY_FILES 40 CACHE STRING "Sources that are compiled as one with ISOLUX_UNITY")
function(isolux_compile_together target)
  if(NOT ISOLUX_UNITY)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  set(count ${ISOLUX_UNITY_FILES})
  set(before)
  list(SORT ARGN)
  foreach(source IN LISTS ARGN)
    cmake_path(ABSOLUTE_PATH source OUTPUT_VARIABLE path)
    cmake_path(GET path PARENT_PATH folder)
    if(count GREATER_EQUAL ISOLUX_UNITY_FILES AND NOT folder STREQUAL before)
      cmake_path(RELATIVE_PATH folder BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE group)
      string(REPLACE / _ group ${group})
      set(count 0)
    endif()
    set(before ${folder})
    math(EXPR count "${count} + 1")
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

# isolux_test_entries(TARGET PREFIX [SUITES all] [FILTER FILTER] [LAUNCHER FILE] [PROPERTY NAME VALUE]...): CTest entries of
# a GoogleTest program, with labels by folder (cmake/list_tests.py), made whenever it is linked.
function(isolux_test_entries target prefix)
  cmake_parse_arguments(ARG "" "SUITES;FILTER;LAUNCHER" "PROPERTY" ${ARGN})
  set(entries ${CMAKE_CURRENT_BINARY_DIR}/${target}_${prefix}.cmake)
  set(options --property TIMEOUT 900)  # against hanging alone
  foreach(name IN ITEMS SUITES FILTER LAUNCHER)
    if(ARG_${name})
      string(TOLOWER ${name} option)
      list(APPEND options --${option}=${ARG_${name}})
    endif()
  endforeach()
  if(ARG_PROPERTY)
    list(APPEND options --property ${ARG_PROPERTY})
  endif()
  add_custom_command(TARGET ${target} POST_BUILD VERBATIM BYPRODUCTS ${entries}
    COMMAND ${PROJECT_SOURCE_DIR}/cmake/list_tests.py --program $<TARGET_FILE:${target}> --out ${entries} --prefix ${prefix}.
      --reports ${PROJECT_BINARY_DIR}/reports ${options})
  if(NOT EXISTS ${entries})
    file(WRITE ${entries} "")
  endif()
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${entries})
endfunction()

# isolux_tests(LAYER [BARE] [SUITES all] [FOLDERS ...] [EXCLUDE ...] LINK ...): one GoogleTest program from all sources in
# tests/LAYER (or FOLDERS and sources of tests/), and its entries. EXCLUDE: folders of tests/, or sources, that are left out. BARE: without
# tests/support, which needs the volume. Tests read the shared data folder from ISOLUX_DATA (tests/support/test_data.h).
function(isolux_tests layer)
  cmake_parse_arguments(ARG "BARE" "SUITES" "LINK;FOLDERS;EXCLUDE" ${ARGN})
  set(sources)
  if(NOT ARG_FOLDERS)
    set(ARG_FOLDERS ${layer})
  endif()
  foreach(folder IN LISTS ARG_FOLDERS)
    if(folder MATCHES "[.]cpp$")
      list(APPEND sources ${CMAKE_CURRENT_SOURCE_DIR}/${folder})
    else()
      file(GLOB_RECURSE found CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*.cpp)
      list(APPEND sources ${found})
    endif()
  endforeach()
  foreach(excluded IN LISTS ARG_EXCLUDE)
    list(FILTER sources EXCLUDE REGEX "^${CMAKE_CURRENT_SOURCE_DIR}/${excluded}(/|$)")
  endforeach()
  add_executable(${layer}_tests ${sources})
  # At -O1 GCC 12 takes a new std::stop_source for one that is not initialised.
  target_compile_options(${layer}_tests PRIVATE $<$<NOT:$<CONFIG:Release>>:${ISOLUX_WAITS}> $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  isolux_compile_together(${layer}_tests ${sources})
  target_link_libraries(${layer}_tests PRIVATE ${ARG_LINK} GTest::gtest_main GTest::gmock)
  if(NOT ARG_BARE)
    target_link_libraries(${layer}_tests PRIVATE isolux_test_support)
  endif()
  isolux_test_entries(${layer}_tests ${layer} SUITES ${ARG_SUITES})
endfunction()

# The instruction sets that kernels are compiled for, the widest first; the machine chooses among them at run time.
# With ISOLUX_SIMD=one only what most machines have: for builds that are made often.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|amd64|AMD64)$")
  set(isolux_simd_sets AVX3 AVX2 SSE4)
  set(isolux_simd_usual AVX2)
elseif(CMAKE_SYSTEM_PROCESSOR MATCHES "^(aarch64|arm64)$")
  set(isolux_simd_sets NEON)
  set(isolux_simd_usual NEON)
else()
  set(isolux_simd_sets)
  set(isolux_simd_usual)
endif()
if(ISOLUX_SIMD STREQUAL one)
  set(isolux_simd_sets ${isolux_simd_usual})
endif()
list(TRANSFORM isolux_simd_sets REPLACE "(.+)" "X(\\1)" OUTPUT_VARIABLE SIMD_SETS)
list(JOIN SIMD_SETS " " SIMD_SETS)
list(TRANSFORM isolux_simd_sets PREPEND " | HWY_" OUTPUT_VARIABLE SIMD_TARGETS)
list(JOIN SIMD_TARGETS "" SIMD_TARGETS)
configure_file(${CMAKE_CURRENT_LIST_DIR}/simd_sets.h.in ${PROJECT_BINARY_DIR}/generated/volume/simd_sets.h @ONLY)

# isolux_simd_sources(TARGET KERNELS [SCALAR]): an object of TARGET for each instruction set from a header of kernels, so
# that they are compiled side by side. SCALAR: for processors without any of them, too.
function(isolux_simd_sources target kernels)
  cmake_path(ABSOLUTE_PATH kernels OUTPUT_VARIABLE SIMD_KERNELS)
  cmake_path(RELATIVE_PATH SIMD_KERNELS BASE_DIRECTORY ${PROJECT_SOURCE_DIR})
  string(REPLACE "-inl.h" "" stem ${SIMD_KERNELS})
  foreach(SIMD_SET IN LISTS isolux_simd_sets ARGN)
    string(TOLOWER ${SIMD_SET} suffix)
    set(source ${PROJECT_BINARY_DIR}/generated/${stem}_${suffix}.cpp)
    configure_file(${PROJECT_SOURCE_DIR}/cmake/simd_kernels.cpp.in ${source} @ONLY)
    # GCC compiles functions of kernels twice for arguments that it knows: twice the time for nothing that is measured.
    set_source_files_properties(${source} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON SKIP_PRECOMPILE_HEADERS ON
      COMPILE_OPTIONS $<$<CXX_COMPILER_ID:GNU>:-fno-ipa-cp-clone>)
    target_sources(${target} PRIVATE ${source})
  endforeach()
endfunction()
