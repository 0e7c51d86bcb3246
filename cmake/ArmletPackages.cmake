# The libraries that ours are built on.
if(EMSCRIPTEN)
  include(ArmletWasm)
  return()
endif()
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(fmt 9 REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(antlr4-runtime CONFIG REQUIRED)
