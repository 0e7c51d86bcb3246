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

foreach(headers Eigen3::Eigen nlohmann_json::nlohmann_json)
  string(REGEX REPLACE ".*:" "armlet_wasm_" target ${headers})
  add_library(${target} INTERFACE)
  add_library(${headers} ALIAS ${target})
  target_include_directories(${target} SYSTEM INTERFACE ${ARMLET_WASM_SOURCES}/include)
endforeach()

add_library(armlet_wasm_fmt STATIC ${ARMLET_WASM_SOURCES}/fmt/src/format.cc ${here}/missing_charconv.cpp)
add_library(fmt::fmt ALIAS armlet_wasm_fmt)
target_include_directories(armlet_wasm_fmt SYSTEM PUBLIC ${ARMLET_WASM_SOURCES}/fmt/include)
target_compile_features(armlet_wasm_fmt PUBLIC cxx_std_20)
target_compile_options(armlet_wasm_fmt PRIVATE ${ARMLET_COMPILE_OPTIONS})

set(antlr4-runtime_VERSION 4.9)
set(ANTLR4_INCLUDE_DIR ${ARMLET_WASM_SOURCES}/antlr4/runtime/src)
file(GLOB_RECURSE sources ${ANTLR4_INCLUDE_DIR}/*.cpp)
add_library(antlr4_static STATIC ${sources})
set_target_properties(antlr4_static PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 16)
# Its constructor from text is declared in one way for C++14 and in two for C++17.
set_source_files_properties(${ANTLR4_INCLUDE_DIR}/ANTLRInputStream.cpp PROPERTIES
  COMPILE_OPTIONS -std=c++14 SKIP_UNITY_BUILD_INCLUSION ON)
target_compile_options(antlr4_static PRIVATE -w)
target_compile_features(antlr4_static PRIVATE cxx_std_17)
target_include_directories(antlr4_static SYSTEM PUBLIC ${ANTLR4_INCLUDE_DIR} ${ARMLET_WASM_SOURCES}/include)

# A page waits for the module to arrive, so what is not said here is compiled to be as small as can be: texts, checks and bindings, which
# call much and compute little. (emscripten says -fno-inline-functions with -Oz, which makes C++ larger; the preset says otherwise.) The
# layers that compute are small where calls are worth it, and quick where programs spend their time: kinematics, dynamics, the
# machine's instructions and its heap, and the search for habits of other languages in a text that is wrong.
function(armlet_hurry_hot_code)
  set(calls_are_worth_it "SHELL:-mllvm -inline-threshold=250")
  # Nested loops that are written to be unrolled would be 60 to 140 kB of code for each kernel of any number of joints.
  foreach(layer math chain kinematics dynamics)
    target_compile_options(armlet_layer_${layer} PRIVATE -O2 ${calls_are_worth_it} "SHELL:-mllvm -pragma-unroll-threshold=150")
  endforeach()
  foreach(layer model trajectory world collision planning grasp backend cell)
    target_compile_options(armlet_layer_${layer} PRIVATE -Os ${calls_are_worth_it})
  endforeach()
  set(machine ${PROJECT_SOURCE_DIR}/interpreter/src/vm)
  file(GLOB hot ${machine}/heap/*.cpp ${machine}/instructions/*.cpp ${machine}/host/natives.cpp ${machine}/host/host_calls.cpp
    ${PROJECT_SOURCE_DIR}/interpreter/src/habits/pattern.cpp)
  set_source_files_properties(${hot} TARGET_DIRECTORY armlet_interpreter PROPERTIES
    COMPILE_OPTIONS -O2 SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()
