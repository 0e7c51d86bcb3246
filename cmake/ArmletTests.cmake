# armlet_add_unit_tests(LAYER LIBRARY [INCLUDE...]) adds the program test_LAYER from tests/unit/LAYER.
# armlet_add_script_tests(FOLDER) adds one test for every .rbt file below it, except those in folders called modules.

function(armlet_add_unit_tests layer library)
  file(GLOB sources CONFIGURE_DEPENDS unit/${layer}/*_test.cpp)
  if(NOT sources)
    return()
  endif()
  add_executable(test_${layer} ${sources})
  armlet_compile_options(test_${layer})
  target_link_libraries(test_${layer} PRIVATE armlet_test_main ${library})
  target_include_directories(test_${layer} PRIVATE ${ARGN})
  add_test(NAME unit.${layer} COMMAND test_${layer})
endfunction()

function(armlet_add_script_tests folder)
  file(GLOB_RECURSE scripts CONFIGURE_DEPENDS ${folder}/*.rbt)
  list(FILTER scripts EXCLUDE REGEX "/modules/")
  foreach(script IN LISTS scripts)
    cmake_path(RELATIVE_PATH script BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE name)
    add_test(NAME ${name} COMMAND script_runner $<TARGET_FILE:armlet> ${script})
  endforeach()
endfunction()
