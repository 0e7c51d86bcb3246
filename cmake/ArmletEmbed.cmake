# armlet_embed(TARGET NAME FILE...) compiles the texts of the files into TARGET. Its sources may then
#   #include "NAME.hpp"   and call   armlet::NAME("file.ext"): the text, or nothing if no file has that name.

function(armlet_embed target name)
  string(CONCAT header "#pragma once\n\n#include <optional>\n#include <string_view>\n\nnamespace armlet {\n"
    "std::optional<std::string_view> ${name}(std::string_view file);\n}  // namespace armlet\n")
  string(CONCAT code "#include \"${name}.hpp\"\n\n"
    "std::optional<std::string_view> armlet::${name}(std::string_view file) {\n")
  foreach(file IN LISTS ARGN)
    cmake_path(ABSOLUTE_PATH file)
    cmake_path(GET file FILENAME key)
    file(READ ${file} text)
    string(APPEND code "  if (file == \"${key}\") return R\"text(${text})text\";\n")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  endforeach()
  string(APPEND code "  return std::nullopt;\n}\n")
  armlet_write_if_different(${CMAKE_CURRENT_BINARY_DIR}/${name}.hpp "${header}")
  armlet_write_if_different(${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp "${code}")
  target_sources(${target} PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_BINARY_DIR})
endfunction()

function(armlet_write_if_different file content)
  if(EXISTS ${file})
    file(READ ${file} old)
  endif()
  if(NOT old STREQUAL content)
    file(WRITE ${file} "${content}")
  endif()
endfunction()
