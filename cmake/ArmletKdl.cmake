# Orocos KDL, the peer of the benchmarks: kdl_arm calls it, kdl_origin says whose build of it.
set(ARMLET_KDL_SOURCE "" CACHE PATH "Folder orocos_kdl of the sources of Orocos KDL, compiled with our flags for the benchmarks")
set(kdl orocos-kdl)
set(kdl_origin "KDL from the system")
find_package(orocos_kdl REQUIRED)
if(ARMLET_KDL_SOURCE)
  set(kdl kdl_same_flags)
  set(kdl_origin "KDL with the same flags")
  file(GLOB kdl_sources ${ARMLET_KDL_SOURCE}/src/*.cpp ${ARMLET_KDL_SOURCE}/src/utilities/*.cpp
    ${ARMLET_KDL_SOURCE}/src/utilities/*.cxx)
  add_library(${kdl} STATIC EXCLUDE_FROM_ALL ${kdl_sources})
  target_link_libraries(${kdl} PRIVATE Eigen3::Eigen)
  if(CMAKE_CXX_FLAGS_RELEASE MATCHES "-march=native")
    target_compile_options(${kdl} PRIVATE -mtune=generic)  # as our kernels (ArmletRuntime.cmake)
  endif()
  find_path(ARMLET_KDL_HEADERS kdl/config.h REQUIRED)
  mark_as_advanced(ARMLET_KDL_HEADERS)
  target_include_directories(${kdl} PRIVATE ${ARMLET_KDL_HEADERS}/kdl)  # for config.h
endif()

# A shared library with hidden symbols, apart from our targets: the same functions of Eigen exist on both sides, with types
# laid out differently, and a linker that sees both would take either.
add_library(kdl_arm SHARED EXCLUDE_FROM_ALL kdl_arm.cpp kdl_dynamics.cpp)
armlet_compile_options(kdl_arm)
target_link_libraries(kdl_arm PRIVATE ${kdl} Eigen3::Eigen)
if(NOT ARMLET_KDL_SOURCE)  # whatever our flags, its Eigen types are aligned as in the installed one
  target_compile_definitions(kdl_arm PRIVATE EIGEN_MAX_ALIGN_BYTES=16)
endif()
