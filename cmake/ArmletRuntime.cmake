# What the runtime needs besides its sources.

# Sources that differ: what a platform provides (core/platform.hpp), and what reads robot descriptions. That of WebAssembly
# is a C++ library and nothing else.
if(EMSCRIPTEN)
  set(platform src/core/bare/)
  set(urdf_read urdf_none)
else()
  set(platform src/core/posix/ ample_stack)
  set(urdf_read urdf_read)
endif()

# Kernels for wider registers, chosen at run time; -ffp-contract=off keeps their bits the same.
function(armlet_compile_wide_kernels)
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    foreach(kernels kinematics/batch/batch kinematics/closed_form/closed dynamics/batch/dynamics)
      set_source_files_properties(src/${kernels}_avx2.cpp PROPERTIES
        COMPILE_OPTIONS -mavx2 SKIP_PRECOMPILE_HEADERS ON)
      set_source_files_properties(src/${kernels}_avx512.cpp PROPERTIES
        COMPILE_OPTIONS "-mavx512f;-mavx512dq" SKIP_PRECOMPILE_HEADERS ON)
    endforeach()
  else()  # other processors have no such registers
    foreach(kernels kinematics/batch/batch kinematics/closed_form/closed dynamics/batch/dynamics)
      set_source_files_properties(src/${kernels}_avx2.cpp src/${kernels}_avx512.cpp PROPERTIES HEADER_FILE_ONLY ON)
    endforeach()
  endif()
endfunction()

# Only the headers are needed here; the library is loaded when the first robot description is read.
function(armlet_use_urdf)
  if(urdf_read STREQUAL "urdf_none")
    return()
  endif()
  find_path(ARMLET_URDFDOM_HEADERS urdf_model/model.h PATH_SUFFIXES urdfdom_headers REQUIRED)
  find_library(ARMLET_URDFDOM_MODEL urdfdom_model REQUIRED)
  mark_as_advanced(ARMLET_URDFDOM_HEADERS ARMLET_URDFDOM_MODEL)
  file(REAL_PATH ${ARMLET_URDFDOM_MODEL} urdfdom_library)
  cmake_path(GET urdfdom_library FILENAME urdfdom_library)
  set_source_files_properties(src/model/urdf_read.cpp PROPERTIES
    COMPILE_DEFINITIONS ARMLET_URDFDOM_LIBRARY="${urdfdom_library}")
  target_include_directories(armlet_layer_model SYSTEM PRIVATE ${ARMLET_URDFDOM_HEADERS})
  target_link_libraries(armlet_layer_model PRIVATE ${CMAKE_DL_LIBS})
  target_link_libraries(armlet_runtime PRIVATE ${CMAKE_DL_LIBS})
endfunction()
