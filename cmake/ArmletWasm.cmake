# What the WebAssembly build has instead of Debian's packages of libraries: the sources of the same packages, which
# tools/wasm_sources.sh has put into ARMLET_WASM_SOURCES. Defines the targets fmt::fmt, nlohmann_json::nlohmann_json,
# Eigen3::Eigen and antlr4_static as the packages do.
set(ARMLET_WASM_SOURCES ${PROJECT_SOURCE_DIR}/build/wasm-sources CACHE PATH "Where tools/wasm_sources.sh has put the sources")
set(here ${CMAKE_CURRENT_LIST_DIR}/wasm)
set(CMAKE_POSITION_INDEPENDENT_CODE OFF)

foreach(part fmt antlr4 include/Eigen include/nlohmann include/utf8.h)
  if(NOT EXISTS ${ARMLET_WASM_SOURCES}/${part})
    message(FATAL_ERROR "${ARMLET_WASM_SOURCES}/${part} is missing; tools/wasm_sources.sh ${ARMLET_WASM_SOURCES} fetches it")
  endif()
endforeach()

# In front of every source of ours: what emscripten's C++ library lacks.
set(ARMLET_COMPILE_OPTIONS "SHELL:-include ${here}/missing_cxx20.hpp")

# Streams without locales, in front of those of emscripten's C++ library; paths do without them.
set(streams ${PROJECT_BINARY_DIR}/streams)
function(armlet_write_header name)
  list(JOIN ARGN "\n" lines)
  file(CONFIGURE OUTPUT ${streams}/${name} CONTENT "#pragma once\n#pragma GCC system_header\n${lines}\n" @ONLY)
endfunction()
foreach(header ios iomanip iostream istream ostream sstream streambuf fstream)
  armlet_write_header(${header} "#include <bare_streams.hpp>")
endforeach()
armlet_write_header(iosfwd "#include <bare_iosfwd.hpp>")
armlet_write_header(locale "#include <bare_locale.hpp>")
armlet_write_header(codecvt "#include <bare_locale.hpp>")
armlet_write_header(filesystem "#define _LIBCPP_HAS_NO_LOCALIZATION" "#include_next <filesystem>" "#undef _LIBCPP_HAS_NO_LOCALIZATION")
include_directories(BEFORE SYSTEM ${streams} ${here} ${ARMLET_WASM_SOURCES}/include)

foreach(headers Eigen3::Eigen nlohmann_json::nlohmann_json)
  string(REGEX REPLACE ".*:" "armlet_wasm_" target ${headers})
  add_library(${target} INTERFACE)
  add_library(${headers} ALIAS ${target})
  target_include_directories(${target} SYSTEM INTERFACE ${ARMLET_WASM_SOURCES}/include)
endforeach()

# Texts to the screen or a file, and streams of JSON, are not wanted here.
target_compile_definitions(armlet_wasm_nlohmann_json INTERFACE JSON_NO_IO)

add_library(armlet_wasm_fmt STATIC ${ARMLET_WASM_SOURCES}/fmt/src/format.cc ${here}/missing_charconv.cpp ${here}/missing_sorting.cpp)
add_library(fmt::fmt ALIAS armlet_wasm_fmt)
target_include_directories(armlet_wasm_fmt SYSTEM PUBLIC ${ARMLET_WASM_SOURCES}/fmt/include)
target_compile_features(armlet_wasm_fmt PUBLIC cxx_std_20)
target_compile_options(armlet_wasm_fmt PRIVATE ${ARMLET_COMPILE_OPTIONS})
# No locale has a say in how numbers are written.
target_compile_definitions(armlet_wasm_fmt PRIVATE FMT_STATIC_THOUSANDS_SEPARATOR=',')

set(antlr4-runtime_VERSION 4.9)
set(ANTLR4_INCLUDE_DIR ${ARMLET_WASM_SOURCES}/antlr4/runtime/src)
file(GLOB_RECURSE sources ${ANTLR4_INCLUDE_DIR}/*.cpp)
# What reads streams and files, which nothing here does.
list(FILTER sources EXCLUDE REGEX "/(ANTLRFileStream|UnbufferedCharStream|InterpreterDataReader|TokenStreamRewriter)\\.cpp$")
add_library(antlr4_static STATIC ${sources})
set_target_properties(antlr4_static PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 16)
# Its constructor from text is declared in one way for C++14 and in two for C++17.
set_source_files_properties(${ANTLR4_INCLUDE_DIR}/ANTLRInputStream.cpp PROPERTIES
  COMPILE_OPTIONS -std=c++14 SKIP_UNITY_BUILD_INCLUSION ON)
target_compile_options(antlr4_static PRIVATE -w)
target_compile_features(antlr4_static PRIVATE cxx_std_17)
target_include_directories(antlr4_static SYSTEM PUBLIC ${ANTLR4_INCLUDE_DIR} ${ARMLET_WASM_SOURCES}/include)

# A page waits for the module to arrive, so what is not said here is compiled to be as small as can be: texts, checks, bindings, plans,
# reports and decompositions, which call much or are seldom called. (emscripten says -fno-inline-functions with -Oz, which makes C++
# larger; the preset says otherwise.)
# Quick is where programs spend their time: what kinematics and dynamics compute for each instant, what happens while time passes, the
# machine's instructions and its heap, and the search for habits of other languages in a text that is wrong.
function(armlet_hurry_hot_code)
  set(ARMLET_QUICK -O2)
  armlet_hurry(layer_trajectory runtime/src/trajectory/ trajectory roots motion_forces part sample_table)
  armlet_hurry(layer_collision runtime/src/collision/ nearest_point solid gap scene_pose segment_check)
  armlet_hurry(layer_cell runtime/src/cell/ cell_time contacts carried_load)
  armlet_hurry(layer_backend runtime/src/backend/ event fan_out run_hash)
  # What the linker would inline into the machine makes it a sixth slower.
  set(ARMLET_QUICK -O2 -fno-lto)
  armlet_hurry(room_habits interpreter/src/habits/ pattern)
  armlet_hurry(room_vm interpreter/src/vm/host/ natives host_calls)
  armlet_hurry(room_vm interpreter/src/vm/heap/ heap heap_text memory)
  armlet_hurry(room_vm interpreter/src/vm/values/ equality map map_values)
  armlet_hurry(room_vm interpreter/src/vm/instructions/ *)
  # Calls are worth inlining there; nested loops that are written to be unrolled would be 60 to 140 kB of code for each kernel of any
  # number of joints.
  list(APPEND ARMLET_QUICK -mllvm -inline-threshold=250 -mllvm -pragma-unroll-threshold=150)
  armlet_hurry(layer_math runtime/src/math/ matrix_product pose rotation twist)
  armlet_hurry(layer_chain runtime/src/chain/ *)
  armlet_hurry(layer_kinematics runtime/src/kinematics/forward/ forward *_kernels jacobian)
  armlet_hurry(layer_kinematics runtime/src/kinematics/closed_form/ branches closed_*)
  armlet_hurry(layer_kinematics runtime/src/kinematics/ik/ ik_free ik_numeric ik_steps)
  armlet_hurry(layer_kinematics runtime/src/kinematics/batch/ batch_baseline)
  armlet_hurry(layer_dynamics runtime/src/dynamics/ *_kernels inverse_dynamics plan_dynamics)
  armlet_hurry(layer_dynamics runtime/src/dynamics/simulation/ *)

  # All else is linked as a whole: the linker sees what throws nothing, and leaves out what would be done if it did.
  set(rooms base vocabulary ast habits hir program syntax check lower vm driver editor format host values rules moves numbers robot world
    motion trajectory dynamics plot vision laboratory session controls workspace)
  list(TRANSFORM rooms PREPEND armlet_room_)
  foreach(target antlr4_static armlet_grammar ${rooms} armlet_laboratory armlet_module armlet_layer_math armlet_layer_chain
      armlet_layer_model armlet_layer_kinematics armlet_layer_dynamics armlet_layer_trajectory armlet_layer_world armlet_layer_collision
      armlet_layer_planning armlet_layer_grasp armlet_layer_backend armlet_layer_cell armlet_layer_mesh armlet_layer_plot)
    target_compile_options(${target} PRIVATE -flto)
  endforeach()
endfunction()

# Sources of the library armlet_TARGET, in FOLDER, that have to be quick: compiled with ARMLET_QUICK. Clang refuses headers that were
# precompiled with -Oz in a source with -O2, so the preset switches precompiled headers off.
function(armlet_hurry target folder)
  list(TRANSFORM ARGN PREPEND ${PROJECT_SOURCE_DIR}/${folder})
  list(TRANSFORM ARGN APPEND .cpp)
  file(GLOB sources ${ARGN})
  set_source_files_properties(${sources} TARGET_DIRECTORY armlet_${target} PROPERTIES
    COMPILE_OPTIONS "${ARMLET_QUICK}" SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()
