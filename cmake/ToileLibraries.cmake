# Third-party libraries, each as one interface target that a package names in its USES_LIBRARIES.
# Their headers are system headers, so that our warnings are about our code.
find_package(MPI REQUIRED COMPONENTS C CXX)
find_package(Trilinos 13 REQUIRED COMPONENTS Teuchos Tpetra Belos Amesos2 Thyra NOX Sacado)

function(toile_library name)
  cmake_parse_arguments(arg "" "" "INCLUDE;LINK" ${ARGN})
  add_library(toile_lib_${name} INTERFACE)
  target_include_directories(toile_lib_${name} SYSTEM INTERFACE ${arg_INCLUDE})
  target_link_libraries(toile_lib_${name} INTERFACE ${arg_LINK})
endfunction()

toile_library(mpi INCLUDE ${MPI_CXX_INCLUDE_DIRS} LINK MPI::MPI_CXX)
toile_library(teuchos INCLUDE ${Trilinos_INCLUDE_DIRS}
  LINK trilinos_teuchosparameterlist trilinos_teuchoscomm trilinos_teuchosparser trilinos_teuchoscore MPI::MPI_CXX)
toile_library(sacado INCLUDE ${Trilinos_INCLUDE_DIRS} LINK trilinos_sacado trilinos_teuchoscore)
toile_library(tpetra INCLUDE ${Trilinos_INCLUDE_DIRS}
  LINK trilinos_tpetra trilinos_tpetraclassic trilinos_kokkoskernels trilinos_kokkoscontainers trilinos_kokkoscore
       trilinos_teuchoskokkoscomm trilinos_teuchoskokkoscompat trilinos_teuchosnumerics toile_lib_teuchos)
toile_library(nox INCLUDE ${Trilinos_INCLUDE_DIRS}
  LINK trilinos_locathyra trilinos_loca trilinos_nox trilinos_belostpetra trilinos_belos trilinos_amesos2
       trilinos_thyratpetra trilinos_thyracore trilinos_rtop toile_lib_tpetra)

find_path(EXPAT_INCLUDE expat.h REQUIRED)
find_library(EXPAT_LIBRARY expat REQUIRED)
toile_library(expat INCLUDE ${EXPAT_INCLUDE} LINK ${EXPAT_LIBRARY})

find_path(EIGEN_INCLUDE Eigen/Core PATH_SUFFIXES eigen3 REQUIRED)
toile_library(eigen INCLUDE ${EIGEN_INCLUDE})

find_path(PEGTL_INCLUDE tao/pegtl.hpp REQUIRED)
toile_library(pegtl INCLUDE ${PEGTL_INCLUDE})
find_package(Boost REQUIRED COMPONENTS serialization)
toile_library(boost LINK Boost::headers)
target_compile_definitions(toile_lib_boost INTERFACE BOOST_ALLOW_DEPRECATED_HEADERS)  # which it includes itself
find_library(GMSH_LIBRARY gmsh REQUIRED)
find_path(GMSH_INCLUDE gmsh.h REQUIRED)
toile_library(gmsh INCLUDE ${GMSH_INCLUDE} LINK ${GMSH_LIBRARY})
find_library(GSL_LIBRARY gsl REQUIRED)
find_path(GSL_INCLUDE gsl/gsl_spline.h REQUIRED)
toile_library(gsl INCLUDE ${GSL_INCLUDE} LINK ${GSL_LIBRARY})
find_library(PAGMO_LIBRARY pagmo REQUIRED)
find_path(PAGMO_INCLUDE pagmo/problem.hpp REQUIRED)
toile_library(pagmo INCLUDE ${PAGMO_INCLUDE} ${EIGEN_INCLUDE} LINK ${PAGMO_LIBRARY} Boost::serialization)

# Files of patterns: JSON, SVG, DXF.
find_package(nlohmann_json REQUIRED)
toile_library(json LINK nlohmann_json::nlohmann_json)
find_package(pugixml REQUIRED)
toile_library(pugixml LINK pugixml::pugixml)
find_library(DXFLIB_LIBRARY dxflib REQUIRED)
find_path(DXFLIB_INCLUDE dxflib/dl_dxf.h REQUIRED)
toile_library(dxflib INCLUDE ${DXFLIB_INCLUDE} LINK ${DXFLIB_LIBRARY})

find_path(METIS_INCLUDE metis.h REQUIRED)
find_library(METIS_LIBRARY metis REQUIRED)
toile_library(metis INCLUDE ${METIS_INCLUDE} LINK ${METIS_LIBRARY})

find_path(MUMPS_INCLUDE dmumps_c.h REQUIRED)
find_library(MUMPS_LIBRARY dmumps REQUIRED)
find_library(MUMPS_COMMON_LIBRARY mumps_common REQUIRED)
toile_library(mumps INCLUDE ${MUMPS_INCLUDE} LINK ${MUMPS_LIBRARY} ${MUMPS_COMMON_LIBRARY} MPI::MPI_C)

find_library(OPENBLAS_LIBRARY NAMES openblas PATH_SUFFIXES openblas-pthread REQUIRED)
find_path(OPENBLAS_INCLUDE cblas.h PATH_SUFFIXES openblas-pthread x86_64-linux-gnu/openblas-pthread REQUIRED)
toile_library(openblas INCLUDE ${OPENBLAS_INCLUDE} LINK ${OPENBLAS_LIBRARY})

if(TOILE_ENABLE_BODY)
  find_package(CGAL REQUIRED QUIET)
  find_path(CHOLMOD_INCLUDE cholmod.h PATH_SUFFIXES suitesparse REQUIRED)
  find_library(CHOLMOD_LIBRARY cholmod REQUIRED)
  find_library(SUITESPARSE_CONFIG_LIBRARY suitesparseconfig REQUIRED)
  toile_library(cgal LINK CGAL::CGAL)
  toile_library(cholmod INCLUDE ${CHOLMOD_INCLUDE} LINK ${CHOLMOD_LIBRARY} ${SUITESPARSE_CONFIG_LIBRARY})
endif()

if(TOILE_ENABLE_RESULT)
  find_library(EXODUS_LIBRARY exoIIv2c REQUIRED)
  find_path(EXODUS_INCLUDE exodusII.h REQUIRED)
  find_path(HDF5_INCLUDE hdf5.h PATH_SUFFIXES hdf5/openmpi REQUIRED)
  find_library(HDF5_LIBRARY NAMES hdf5 hdf5_openmpi PATH_SUFFIXES hdf5/openmpi REQUIRED)
  # The one that Exodus itself uses: there are two builds of it.
  get_filename_component(EXODUS_FOLDER "${EXODUS_LIBRARY}" DIRECTORY)
  find_path(NETCDF_INCLUDE netcdf.h HINTS "${EXODUS_FOLDER}/netcdf/mpi/include" REQUIRED)
  find_library(NETCDF_LIBRARY NAMES netcdf_mpi netcdf REQUIRED)
  toile_library(exodus INCLUDE ${EXODUS_INCLUDE} LINK ${EXODUS_LIBRARY})
  toile_library(netcdf INCLUDE ${NETCDF_INCLUDE} LINK ${NETCDF_LIBRARY})
  toile_library(hdf5 INCLUDE ${HDF5_INCLUDE} LINK ${HDF5_LIBRARY} MPI::MPI_C)
endif()
