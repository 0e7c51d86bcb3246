# armlet_add_room(NAME USES ROOM... SOURCES ... PRIVATE ... UNITY ...) adds the room NAME of the interpreter, which may use the rooms
# named before it and those that these use: ARMLET_ROOMS of the target armlet_room_NAME are it and all of them. PRIVATE is what else it
# is linked with.
function(armlet_add_room name)
  cmake_parse_arguments(ARG "" "" "USES;SOURCES;PRIVATE;UNITY" ${ARGN})
  set(room armlet_room_${name})
  add_library(${room} OBJECT)
  armlet_target_sources(${room} ${ARG_SOURCES})
  armlet_compile_options(${room})
  target_include_directories(${room} PRIVATE include src)
  target_link_libraries(${room} PUBLIC armlet::core PRIVATE ${ARG_PRIVATE})
  # A switch over kinds lists them all, so one that is added is not forgotten.
  target_compile_options(${room} PRIVATE -Wswitch-enum)
  if(ARMLET_CHECKED)
    target_compile_definitions(${room} PRIVATE ARMLET_CHECKED)
  endif()
  armlet_group_sources(${room} ${ARG_UNITY})
  if(name STREQUAL "base")
    target_precompile_headers(${room} PRIVATE <algorithm> <functional> <map> <memory> <optional> <span> <string> <unordered_map> <vector>)
  else()
    target_precompile_headers(${room} REUSE_FROM armlet_room_base)
  endif()
  set(rooms ${room})
  foreach(used IN LISTS ARG_USES)
    get_target_property(below armlet_room_${used} ARMLET_ROOMS)
    list(APPEND rooms ${below})
  endforeach()
  list(REMOVE_DUPLICATES rooms)
  set_target_properties(${room} PROPERTIES ARMLET_ROOMS "${rooms}")
endfunction()

# A room whose headers or sources read what ANTLR has made of the grammar. SYSTEM, because its headers are not ours to keep free of
# warnings.
function(armlet_read_grammar room)
  target_link_libraries(armlet_room_${room} PRIVATE antlr4_static)
  target_include_directories(armlet_room_${room} SYSTEM PRIVATE $<TARGET_PROPERTY:armlet_grammar,INTERFACE_INCLUDE_DIRECTORIES>)
endfunction()
