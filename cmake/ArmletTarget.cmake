# armlet_add_library(NAME SOURCES ... PUBLIC ... PRIVATE ...) adds the library armlet_NAME, alias armlet::NAME.
# armlet_compile_options(TARGET) gives a target the flags that all of our own code is compiled with.

set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)

function(armlet_compile_options target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  # Same bits on every machine: no fused multiply-add. Kernels start on a cache line.
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor
    -ffp-contract=off -falign-functions=64 $<$<BOOL:${ARMLET_WERROR}>:-Werror>)
  armlet_sanitize(${target})
endfunction()

# Sanitizers are a matter of this build tree: installed targets do not mention them.
function(armlet_sanitize target)
  if(ARMLET_SANITIZE)
    set(flags -fsanitize=${ARMLET_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_compile_options(${target} PRIVATE ${flags})
    target_link_options(${target} PUBLIC $<BUILD_INTERFACE:-fsanitize=${ARMLET_SANITIZE}>)
  endif()
endfunction()

function(armlet_add_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  add_library(armlet_${name} STATIC)
  # BOOTSTRAP: tolerate files listed before they are written
  file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/empty.cpp "")
  target_sources(armlet_${name} PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/empty.cpp)
  foreach(source IN LISTS ARG_SOURCES)
    if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${source})
      target_sources(armlet_${name} PRIVATE ${source})
    endif()
  endforeach()
  set_target_properties(armlet_${name} PROPERTIES EXPORT_NAME ${name} LINKER_LANGUAGE CXX)
  add_library(armlet::${name} ALIAS armlet_${name})
  armlet_compile_options(armlet_${name})
  target_include_directories(armlet_${name}
    PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>
           $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/src)
  target_link_libraries(armlet_${name} PUBLIC ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE})
endfunction()
