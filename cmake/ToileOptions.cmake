# Switches of the build. Optional packages are off only when somebody asks for it.
option(TOILE_ENABLE_TESTS "Build the tests" ON)
option(TOILE_ENABLE_BENCHMARKS "Build the benchmarks" ON)
option(TOILE_ENABLE_BODY "Bodies and contact (needs CGAL, CHOLMOD)" ON)
option(TOILE_ENABLE_RESULT "Exodus and HDF5 files; without them a run writes tables and plots only" ON)
option(TOILE_ENABLE_REPORT "Reports: one HTML page of a run (needs nlohmann_json, Boost)" ON)
# Debian's own Python has the headers and NumPy; another one is named by -DPython3_ROOT_DIR=...
set(Python3_FIND_STRATEGY LOCATION)
if(NOT DEFINED Python3_ROOT_DIR)
  set(Python3_ROOT_DIR /usr)
endif()
find_package(Python3 QUIET COMPONENTS Interpreter Development.Module NumPy)
find_package(pybind11 QUIET)
set(toile_python OFF)
if(Python3_FOUND AND pybind11_FOUND AND NOT TOILE_SANITIZERS)
  set(toile_python ON)
endif()
option(TOILE_ENABLE_PYTHON "The Python module (needs pybind11 and NumPy)" ${toile_python})
if(TOILE_ENABLE_PYTHON AND NOT (Python3_FOUND AND pybind11_FOUND))
  message(FATAL_ERROR "TOILE_ENABLE_PYTHON=ON needs pybind11 (Debian: pybind11-dev), Python's headers (python3-dev) and NumPy "
    "(python3-numpy); looked for Python in ${Python3_ROOT_DIR}")
endif()
# Cache variables outlive the mistake: a wrong one is dropped before it is refused.
get_cmake_property(toile_cache CACHE_VARIABLES)
list(FILTER toile_cache INCLUDE REGEX "^TOILE_ENABLE_")
foreach(switch IN LISTS toile_cache)
  if(NOT switch MATCHES "^TOILE_ENABLE_(TESTS|BENCHMARKS|BODY|RESULT|REPORT|PYTHON)$")
    unset(${switch} CACHE)
    message(FATAL_ERROR "${switch}: there is no such switch. Valid are TOILE_ENABLE_BODY, TOILE_ENABLE_RESULT, "
      "TOILE_ENABLE_REPORT (packages), TOILE_ENABLE_PYTHON, and TOILE_ENABLE_TESTS, TOILE_ENABLE_BENCHMARKS; the other packages are always needed")
  endif()
endforeach()
# Off for users: another compiler or processor may warn of what is none of theirs. CI switches it on.
option(TOILE_WARNINGS_AS_ERRORS "Treat compiler warnings as errors" OFF)
set(TOILE_PROCESSOR native CACHE STRING "Processor that the code is made for, as g++ -march names it: native (the one it \
is built on), x86-64 (any), x86-64-v2, x86-64-v3 (AVX2), x86-64-v4 (AVX-512)")
set(TOILE_SANITIZERS "" CACHE STRING "Sanitizers to build with, e.g. address,undefined")

add_library(toile_options INTERFACE)
# GCC 12 reports its own vector intrinsics as uninitialized (GCC bug 105593), with sanitizers even more of them.
target_compile_options(toile_options INTERFACE -Wall -Wextra -Wshadow -Wpedantic -Wno-maybe-uninitialized)
if(TOILE_WARNINGS_AS_ERRORS)
  target_compile_options(toile_options INTERFACE -Werror)
endif()
# Options that the code depends on: plug-ins are compiled with them too.
set(TOILE_CODE_OPTIONS "")
# The ABI of Eigen types depends on the vector width: one setting for every target.
list(APPEND TOILE_CODE_OPTIONS -march=${TOILE_PROCESSOR})
if(TOILE_SANITIZERS)
  # Checks of every single access by a pointer double the time to compile, and find what ends in a crash anyway.
  list(APPEND TOILE_CODE_OPTIONS -fsanitize=${TOILE_SANITIZERS} -fno-omit-frame-pointer -fno-sanitize-recover=all
    -fno-sanitize=null,alignment,vptr,object-size)
  target_compile_options(toile_options INTERFACE -Wno-uninitialized)
  target_link_options(toile_options INTERFACE -fsanitize=${TOILE_SANITIZERS})
endif()
target_compile_options(toile_options INTERFACE ${TOILE_CODE_OPTIONS})

find_program(TOILE_CCACHE ccache)
if(TOILE_CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${TOILE_CCACHE}")
endif()
