# armlet_add_library(NAME SOURCES ... PUBLIC ... PRIVATE ... PRECOMPILE ... UNITY ...) adds the library armlet_NAME, alias
# armlet::NAME, linked to PUBLIC and PRIVATE; PRECOMPILE are headers that most of its sources include. SOURCES are
# folders, each followed by the names of its sources: src/check/calls/ calls printf stands for src/check/calls/calls.cpp and printf.cpp.
# UNITY is what armlet_group_sources needs.
# armlet_add_layer(NAME USES LAYER... SOURCES ... UNITY ...) adds the layer NAME of the runtime, which may use the layers
# named before it; ARMLET_LAYERS of the target armlet_layer_NAME are it and all that it uses, directly or not.
# armlet_group_sources(TARGET GROUPS SALT [GROUPS SALT PATTERN]) compiles the sources of TARGET as so many translation units if
# ARMLET_UNITY is on; sources that match PATTERN, which read headers that the others do not, are grouped by themselves.
# armlet_compile_apart(SOURCE...) keeps sources out of these groups.
# armlet_compile_options(TARGET) gives a target the flags that all of our own code is compiled with.

# A compiler cache when there is one that is not switched off; it and precompiled headers hinder each other.
find_program(ARMLET_CCACHE ccache)
if(ARMLET_CCACHE AND PROJECT_IS_TOP_LEVEL AND NOT CMAKE_CXX_COMPILER_LAUNCHER AND NOT DEFINED ENV{CCACHE_DISABLE})
  set(CMAKE_CXX_COMPILER_LAUNCHER ${ARMLET_CCACHE})
endif()
if(CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_DISABLE_PRECOMPILE_HEADERS ON)
endif()

set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)

function(armlet_compile_options target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  # -Wno-...: g++ 12 sees overflows inside its own std::string (gcc.gnu.org/PR105329, PR105651).
  # -Wno-pass-failed: clang says so where it does not unroll a loop that we would like to be unrolled.
  # Same bits on every machine: no fused multiply-add. Kernels start on a cache line.
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor -Wno-missing-field-initializers
    "$<$<CXX_COMPILER_ID:GNU>:-Wno-restrict;-Wno-stringop-overflow>"
    # g++ collects its garbage later, which makes it 5 to 10 % faster.
    "$<$<CXX_COMPILER_ID:GNU>:SHELL:--param=ggc-min-expand=400 --param=ggc-min-heapsize=600000>"
    $<$<CXX_COMPILER_ID:Clang>:-Wno-pass-failed>
    # Where addresses have four bytes, the heap compares sizes with its limits before they lose bits.
    "$<$<PLATFORM_ID:Emscripten>:-Wno-shorten-64-to-32;-Wno-unused-private-field>"
    -ffp-contract=off -falign-functions=64 $<$<BOOL:${ARMLET_WERROR}>:-Werror> ${ARMLET_COMPILE_OPTIONS})
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

# Sources as armlet_add_library takes them.
function(armlet_target_sources target)
  foreach(item IN LISTS ARGN)
    if(item MATCHES "/$")
      set(folder ${item})
    else()
      target_sources(${target} PRIVATE ${folder}${item}.cpp)
    endif()
  endforeach()
endfunction()

function(armlet_add_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;PUBLIC;PRIVATE;PRECOMPILE;UNITY" ${ARGN})
  add_library(armlet_${name} STATIC)
  armlet_target_sources(armlet_${name} ${ARG_SOURCES})
  set_target_properties(armlet_${name} PROPERTIES EXPORT_NAME ${name})
  add_library(armlet::${name} ALIAS armlet_${name})
  armlet_compile_options(armlet_${name})
  target_include_directories(armlet_${name}
    PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>
           $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/src)
  target_link_libraries(armlet_${name} PUBLIC ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE})
  target_precompile_headers(armlet_${name} PRIVATE ${ARG_PRECOMPILE})
  if(ARG_UNITY)
    armlet_group_sources(armlet_${name} ${ARG_UNITY})
  endif()
endfunction()

# Fixed alignment and the same bits whatever the instruction set of whoever includes the headers of TARGET.
function(armlet_use_eigen target)
  target_link_libraries(${target} PUBLIC Eigen3::Eigen)
  target_compile_definitions(${target} PUBLIC EIGEN_DONT_VECTORIZE)
endfunction()

# ARMLET_LAYERS are what armlet_add_layer_tests links: what a layer may not use is missing there.
function(armlet_add_layer name)
  cmake_parse_arguments(ARG "" "" "USES;SOURCES;UNITY" ${ARGN})
  add_library(armlet_layer_${name} OBJECT)
  armlet_target_sources(armlet_layer_${name} ${ARG_SOURCES})
  armlet_compile_options(armlet_layer_${name})
  target_include_directories(armlet_layer_${name} PRIVATE include src)
  target_link_libraries(armlet_layer_${name} PUBLIC armlet::core)
  armlet_use_eigen(armlet_layer_${name})
  armlet_group_sources(armlet_layer_${name} ${ARG_UNITY})
  if(name STREQUAL "math")
    target_precompile_headers(armlet_layer_math PRIVATE <Eigen/Geometry> <fmt/format.h>)
  else()
    target_precompile_headers(armlet_layer_${name} REUSE_FROM armlet_layer_math)
  endif()
  set(layers armlet_layer_${name})
  foreach(used IN LISTS ARG_USES)
    get_target_property(below armlet_layer_${used} ARMLET_LAYERS)
    list(APPEND layers ${below})
  endforeach()
  list(REMOVE_DUPLICATES layers)
  set_target_properties(armlet_layer_${name} PROPERTIES ARMLET_LAYERS "${layers}")
endfunction()

function(armlet_group_of file groups salt)
  string(MD5 hash "${salt}${file}")
  string(SUBSTRING ${hash} 0 6 hash)
  math(EXPR group "0x${hash} % ${groups}")
  set(group ${group} PARENT_SCOPE)
endfunction()

# A source's group follows from its name alone, so a new source changes one group. Two sources of a group share their
# anonymous namespace: where they use one name for two things, the compiler says so and one of them is renamed. SALT was
# chosen so that the sources of that day did not meet (docs/decisions/0029).
function(armlet_group_sources target groups salt)
  if(NOT ARMLET_UNITY)
    return()
  endif()
  get_target_property(sources ${target} SOURCES)
  set(pattern "^$")
  if(ARGN)
    list(GET ARGN 2 pattern)
  endif()
  foreach(source IN LISTS sources)
    cmake_path(GET source FILENAME file)
    if(source MATCHES "${pattern}")
      armlet_group_of(${file} ${ARGN})
      set(group apart_${group})
    else()
      armlet_group_of(${file} ${groups} ${salt})
    endif()
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${group})
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()

function(armlet_compile_apart)
  set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()
