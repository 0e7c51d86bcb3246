# What the runtime needs besides its sources.

# Sources that differ: what a platform provides (core/platform.hpp), and what reads robot descriptions. That of
# WebAssembly is a C++ library and nothing else, and small.
if(EMSCRIPTEN)
  set(platform src/core/bare/ fork_lock)
  set(urdf_read urdf_none)
  set(urdf_library)
else()
  set(platform src/core/posix/ ample_stack fork_lock)
  set(urdf_read urdf_read)
  set(urdf_library urdf_library)
endif()

# The runtime library is made of these layers.
function(armlet_join_layers)
  foreach(layer IN LISTS ARGN)
    target_sources(armlet_runtime PRIVATE $<TARGET_OBJECTS:armlet_layer_${layer}>)
  endforeach()
endfunction()

# Kernels for wider registers, chosen at run time; -ffp-contract=off keeps their bits the same.
function(armlet_compile_wide_kernels)
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    foreach(kernels kinematics/batch/batch kinematics/closed_form/closed dynamics/batch/dynamics vision/susan)
      set_source_files_properties(src/${kernels}_avx2.cpp PROPERTIES
        COMPILE_OPTIONS -mavx2 SKIP_PRECOMPILE_HEADERS ON)
      set_source_files_properties(src/${kernels}_avx512.cpp PROPERTIES
        COMPILE_OPTIONS "-mavx512f;-mavx512dq" SKIP_PRECOMPILE_HEADERS ON)
    endforeach()
  else()  # other processors have no such registers
    foreach(kernels kinematics/batch/batch kinematics/closed_form/closed dynamics/batch/dynamics vision/susan)
      set_source_files_properties(src/${kernels}_avx2.cpp src/${kernels}_avx512.cpp PROPERTIES HEADER_FILE_ONLY ON)
    endforeach()
  endif()
endfunction()

# g++ 12 knows no Zen 4 and tunes for Zen 3 with -march=native, which makes inverse dynamics 4 to 9 % and inertia matrices 8 %
# slower there. Without -march the tuning is this one anyway.
function(armlet_tune_native_kernels)
  if(CMAKE_CXX_FLAGS_RELEASE MATCHES "-march=native" AND CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    set_source_files_properties(src/dynamics/newton_euler_kernels.cpp src/dynamics/inverse_dynamics.cpp
      src/dynamics/mass_kernels.cpp src/dynamics/forward_dynamics.cpp PROPERTIES
      COMPILE_OPTIONS -mtune=generic)
  endif()
endfunction()

# Libraries for pictures, meshes and robot descriptions. Of urdfdom only the headers are needed here; the library is loaded when the
# first robot description is read.
function(armlet_use_file_formats)
  target_link_libraries(armlet_layer_mesh PRIVATE nlohmann_json::nlohmann_json)
  if(EMSCRIPTEN)
    armlet_target_sources(armlet_layer_image src/image/ without_files)
    return()
  endif()
  find_package(PNG REQUIRED)
  find_path(ARMLET_STB_HEADERS stb/stb_image.h REQUIRED)
  target_link_libraries(armlet_layer_image PRIVATE PNG::PNG)
  armlet_target_sources(armlet_layer_image src/image/ jpeg_frame jpeg_write netpbm png_frame png_write read_image stb_decode)
  # Of corrupt files it adds numbers that overflow.
  set_source_files_properties(src/image/stb_decode.cpp PROPERTIES COMPILE_OPTIONS -fwrapv SKIP_PRECOMPILE_HEADERS ON)
  target_link_libraries(armlet_runtime PRIVATE PNG::PNG)
  find_path(ARMLET_URDFDOM_HEADERS urdf_model/model.h PATH_SUFFIXES urdfdom_headers REQUIRED)
  find_library(ARMLET_URDFDOM_MODEL urdfdom_model REQUIRED)
  mark_as_advanced(ARMLET_STB_HEADERS ARMLET_URDFDOM_HEADERS ARMLET_URDFDOM_MODEL)
  file(REAL_PATH ${ARMLET_URDFDOM_MODEL} urdfdom_library)
  cmake_path(GET urdfdom_library FILENAME urdfdom_library)
  set_source_files_properties(src/model/descriptions/urdf_library.cpp PROPERTIES
    COMPILE_DEFINITIONS ARMLET_URDFDOM_LIBRARY="${urdfdom_library}")
  target_include_directories(armlet_layer_model SYSTEM PRIVATE ${ARMLET_URDFDOM_HEADERS})
  target_link_libraries(armlet_layer_model PRIVATE ${CMAKE_DL_LIBS})
  target_link_libraries(armlet_runtime PRIVATE ${CMAKE_DL_LIBS})
endfunction()

# A library that is loaded at run time lies in lib beside the folder of the command, and of the tests.
function(armlet_place_module module)
  set_target_properties(${module} PROPERTIES LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib DISABLE_PRECOMPILE_HEADERS ON)
  cmake_path(GET ARMLET_COMMAND_DIR PARENT_PATH beside)
  if(NOT beside STREQUAL PROJECT_BINARY_DIR)
    add_custom_command(TARGET ${module} POST_BUILD
      COMMAND ${CMAKE_COMMAND} -E make_directory ${beside}/lib
      COMMAND ${CMAKE_COMMAND} -E copy_if_different $<TARGET_FILE:${module}> ${beside}/lib)
  endif()
endfunction()

# The room of the sampling planners, loaded when the first path is searched (runtime/src/planning/sampling_door.hpp). Without OMPL,
# everything else is built all the same.
function(armlet_add_sampling_library)
  if(EMSCRIPTEN OR NOT ARMLET_PLANNING)
    return()
  endif()
  find_path(ARMLET_OMPL_HEADERS ompl/geometric/planners/rrt/RRTConnect.h PATH_SUFFIXES ompl-1.6 ompl-1.5 ompl)
  find_library(ARMLET_OMPL ompl)
  mark_as_advanced(ARMLET_OMPL_HEADERS ARMLET_OMPL)
  if(NOT ARMLET_OMPL_HEADERS OR NOT ARMLET_OMPL)
    message(STATUS "OMPL was not found (Debian package libompl-dev): paths around obstacles will not be searched")
    return()
  endif()
  add_library(armlet_planning MODULE src/planning/ompl/search.cpp)
  armlet_compile_options(armlet_planning)
  target_include_directories(armlet_planning PRIVATE src)
  target_include_directories(armlet_planning SYSTEM PRIVATE ${ARMLET_OMPL_HEADERS})
  target_link_libraries(armlet_planning PRIVATE Eigen3::Eigen ${ARMLET_OMPL})
  armlet_place_module(armlet_planning)
  add_dependencies(armlet_runtime armlet_planning)
  if(PROJECT_IS_TOP_LEVEL)
    install(TARGETS armlet_planning LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT planning)
  endif()
endfunction()

# The room of OpenCV, loaded when one of its functions is first called (runtime/src/vision/opencv_door.hpp). Unlike that of the
# planners it is not made with the command: the first run of a program does not wait for it.
option(ARMLET_OPENCV "Functions of pictures by OpenCV, where it is installed" ON)
function(armlet_add_opencv_library)
  if(EMSCRIPTEN OR NOT ARMLET_OPENCV)
    return()
  endif()
  find_path(ARMLET_OPENCV_HEADERS opencv2/aruco.hpp PATH_SUFFIXES opencv4)
  mark_as_advanced(ARMLET_OPENCV_HEADERS)
  set(found ${ARMLET_OPENCV_HEADERS})
  foreach(part core imgproc features2d calib3d video aruco)
    find_library(ARMLET_OPENCV_${part} opencv_${part})
    mark_as_advanced(ARMLET_OPENCV_${part})
    list(APPEND libraries ${ARMLET_OPENCV_${part}})
    if(NOT ARMLET_OPENCV_${part})
      set(found FALSE)
    endif()
  endforeach()
  if(NOT found)
    message(STATUS "OpenCV was not found (Debian package libopencv-contrib-dev): picture functions that need it are refused")
    return()
  endif()
  add_library(armlet_vision MODULE src/vision/opencv/door.cpp src/vision/opencv/features.cpp
    src/vision/opencv/geometry.cpp src/vision/opencv/shapes.cpp)
  armlet_compile_options(armlet_vision)
  target_include_directories(armlet_vision PRIVATE src)
  target_include_directories(armlet_vision SYSTEM PRIVATE ${ARMLET_OPENCV_HEADERS})
  target_link_libraries(armlet_vision PRIVATE ${libraries})
  armlet_place_module(armlet_vision)
  if(PROJECT_IS_TOP_LEVEL)
    install(TARGETS armlet_vision LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT vision OPTIONAL)
  endif()
endfunction()
