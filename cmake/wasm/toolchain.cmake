# The toolchain file of emscripten, wherever its compiler is, and what has to be different for it here.
find_program(ARMLET_EMCC emcc REQUIRED)
file(REAL_PATH ${ARMLET_EMCC} emscripten)
cmake_path(GET emscripten PARENT_PATH emscripten)
include(${emscripten}/cmake/Modules/Platform/Emscripten.cmake)
# Exceptions of WebAssembly itself; those through JavaScript make everything slower.
# Instructions that every browser with these exceptions has: a double becomes an integer without a test around it, for one.
set(CMAKE_CXX_FLAGS_INIT "-fwasm-exceptions -mnontrapping-fptoint -msign-ext")
# Packages of headers are those of the system.
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE BOTH)
