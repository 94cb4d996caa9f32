# cmake -DPACKAGE=name -DFOLDER=folder -DUSES=a,b -DSTAMP=file -P CheckDependencies.cmake: fails unless the package includes
# headers of the packages that it declares, of every one of them, and of no other.
cmake_minimum_required(VERSION 3.25)
string(REPLACE "," ";" uses "${USES}")
file(GLOB_RECURSE files "${FOLDER}/include/*.hpp" "${FOLDER}/src/*.hpp" "${FOLDER}/src/*.cpp")
set(unused ${uses})
foreach(file IN LISTS files)
  file(STRINGS "${file}" includes REGEX "^ *#include \"toile/")
  foreach(line IN LISTS includes)
    string(REGEX REPLACE ".*\"toile/([a-z]+)/.*" "\\1" used "${line}")
    list(REMOVE_ITEM unused "${used}")
    if(NOT used STREQUAL PACKAGE AND NOT used IN_LIST uses)
      message(FATAL_ERROR "${file} includes a header of package '${used}', but package '${PACKAGE}' may use only: "
        "${USES}. See ${FOLDER}/CMakeLists.txt")
    endif()
  endforeach()
endforeach()
if(unused)
  message(FATAL_ERROR "${FOLDER}/CMakeLists.txt: package '${PACKAGE}' declares that it uses '${unused}', but includes no "
    "header of it. Remove it from USES")
endif()
file(TOUCH "${STAMP}")
