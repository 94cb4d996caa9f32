# toile_test(<name> SOURCES <files...> USES <packages...> [RANKS 1 3] [ON_SEVERAL <cases>] [LABELS ...] [TIMEOUT s])
#
# One GoogleTest executable. Without RANKS it runs as it is; with RANKS it is registered once per number of ranks
# under mpirun, and its main initialises MPI. ON_SEVERAL: the cases, as gtest's filter, that run on more than one rank too,
# where all would only repeat what these show. Target tests_<label> builds what has a label; "sanitized" marks what the
# sanitizer build runs: every package that handles data is in it, mathematics alone is not.
# Tests run side by side: ranks must not be bound to the same cores, nor spin while they wait.
set(TOILE_MPIRUN ${MPIEXEC_EXECUTABLE} --allow-run-as-root --oversubscribe --bind-to none --mca mpi_yield_when_idle 1)

if(TOILE_ENABLE_TESTS)
  find_package(GTest REQUIRED)
  include(GoogleTest)
endif()

# toile_test_support(<name> SOURCES <files...> USES <packages...>): what several tests share, compiled once. A test names
# it in its USES.
function(toile_test_support name)
  cmake_parse_arguments(arg "" "" "SOURCES;USES" ${ARGN})
  add_library(toile_${name} STATIC ${arg_SOURCES})
  list(TRANSFORM arg_USES PREPEND toile_)
  target_link_libraries(toile_${name} PUBLIC ${arg_USES} GTest::gtest PRIVATE toile_options)
  target_include_directories(toile_${name} PRIVATE "${PROJECT_SOURCE_DIR}/test")
  target_compile_definitions(toile_${name} PRIVATE TOILE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
endfunction()

function(toile_test name)
  cmake_parse_arguments(arg "" "TIMEOUT;ON_SEVERAL" "SOURCES;USES;RANKS;LABELS" ${ARGN})
  if(NOT arg_TIMEOUT)
    set(arg_TIMEOUT 300)
  endif()
  add_executable(${name} ${arg_SOURCES})
  # What is measured is in the packages: the tests themselves need to compile quickly.
  if(CMAKE_BUILD_TYPE STREQUAL Release)
    target_compile_options(${name} PRIVATE -O1)
  elseif(TOILE_SANITIZERS)
    target_compile_options(${name} PRIVATE -O0)
  endif()
  # Every source of a test has small helpers of its own, whose names it need not share.
  set_target_properties(${name} PROPERTIES UNITY_BUILD OFF)
  foreach(label IN LISTS arg_LABELS)
    if(NOT TARGET tests_${label})
      add_custom_target(tests_${label})
    endif()
    add_dependencies(tests_${label} ${name})
  endforeach()
  list(TRANSFORM arg_USES PREPEND toile_)
  target_link_libraries(${name} PRIVATE ${arg_USES} GTest::gtest GTest::gmock toile_options)
  target_include_directories(${name} PRIVATE "${PROJECT_SOURCE_DIR}/test")
  target_compile_definitions(${name} PRIVATE TOILE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  if(NOT arg_RANKS)
    target_link_libraries(${name} PRIVATE GTest::gtest_main)
    add_test(NAME ${name} COMMAND ${name})
    set_tests_properties(${name} PROPERTIES TIMEOUT ${arg_TIMEOUT} LABELS "${arg_LABELS}"
      ENVIRONMENT "OPENBLAS_NUM_THREADS=1;OMP_NUM_THREADS=1")
    return()
  endif()
  target_link_libraries(${name} PRIVATE toile_mpi_main)
  foreach(ranks IN LISTS arg_RANKS)
    set(cases "*")
    if(ranks GREATER 1 AND arg_ON_SEVERAL)
      set(cases "${arg_ON_SEVERAL}")
    endif()
    add_test(NAME ${name}_np${ranks}
      COMMAND ${TOILE_MPIRUN} -n ${ranks} $<TARGET_FILE:${name}> --gtest_filter=${cases})
    set_tests_properties(${name}_np${ranks} PROPERTIES TIMEOUT ${arg_TIMEOUT} PROCESSORS ${ranks} LABELS "${arg_LABELS}"
      FAIL_REGULAR_EXPRESSION "Running 0 tests"
      # MPI does not give back all of its memory.
      ENVIRONMENT "OPENBLAS_NUM_THREADS=1;OMP_NUM_THREADS=1;ASAN_OPTIONS=detect_leaks=0")
  endforeach()
endfunction()
