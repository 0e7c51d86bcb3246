# armlet_uncounted is the command without the counting of steps: its own copy of the loop replaces the library's.
find_package(CLI11 REQUIRED)
get_target_property(command_sources armlet SOURCES)
get_target_property(command_folder armlet SOURCE_DIR)
list(TRANSFORM command_sources PREPEND ${command_folder}/ REGEX "^[^/]")  # all but generated ones
add_executable(armlet_uncounted EXCLUDE_FROM_ALL
  ${command_sources} ${PROJECT_SOURCE_DIR}/interpreter/src/vm/instructions/interpret.cpp)
armlet_compile_options(armlet_uncounted)
target_compile_definitions(armlet_uncounted PRIVATE ARMLET_VERSION="${PROJECT_VERSION}" ARMLET_UNCOUNTED)
target_include_directories(armlet_uncounted PRIVATE
  ${PROJECT_SOURCE_DIR}/interpreter/src $<TARGET_PROPERTY:armlet,INCLUDE_DIRECTORIES>)
target_link_libraries(armlet_uncounted PRIVATE $<TARGET_PROPERTY:armlet,LINK_LIBRARIES>)
target_link_options(armlet_uncounted PRIVATE $<TARGET_PROPERTY:armlet,LINK_OPTIONS>)
add_dependencies(bench armlet_uncounted)
