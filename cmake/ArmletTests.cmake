# armlet_add_unit_tests(LAYER LIBRARY [INCLUDE...]) adds the program test_LAYER from tests/unit/LAYER.
# armlet_add_layer_tests(LAYER) does so for a layer of the runtime, and links it with those it uses and nothing else.
# armlet_add_room_tests(LIBRARY ROOM...) links rooms of the interpreter or of the library so, too.
# armlet_add_script_tests(FOLDER...) adds one test for every .rbt file below, except those in folders called modules.

find_package(Python3 REQUIRED COMPONENTS Interpreter)

# Tests use std::regex, in which g++ 12 sees uninitialised variables when it is to check addresses (gcc.gnu.org/PR105562).
if(ARMLET_SANITIZE)
  add_compile_options($<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
endif()

# What tests are made of need not be fast; what they test is compiled as it is shipped.
function(armlet_compile_quickly target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# Groups and salt of the tests of a layer (armlet_group_sources).
set(unity_backend 1 0)
set(unity_cell 2 41)
set(unity_chain 1 0)
set(unity_core 2 454)
set(unity_interpreter 8 53)
set(unity_kinematics 6 2184)
set(unity_math 3 2424)
set(unity_model 3 976)
set(unity_plot 1 0)
set(unity_stdlib 4 2589)
set(unity_trajectory 5 63)
set(unity_world 1 0)

function(armlet_add_unit_tests layer library)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/unit/${layer}/*_test.cpp)
  if(NOT sources)
    return()
  endif()
  add_executable(test_${layer} ${sources})
  armlet_compile_options(test_${layer})
  armlet_compile_quickly(test_${layer})
  target_link_libraries(test_${layer} PRIVATE armlet_test_main ${library})
  target_include_directories(test_${layer} PRIVATE ${ARGN} ${PROJECT_SOURCE_DIR}/tests/unit/${layer})
  target_precompile_headers(test_${layer} REUSE_FROM armlet_test_main)
  if(DEFINED unity_${layer})
    armlet_group_sources(test_${layer} ${unity_${layer}})
  endif()
  if(layer STREQUAL "vision")  # in copies of Eigen's matrices: gcc.gnu.org/PR105562 too
    target_compile_options(test_vision PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  endif()
  add_test(NAME unit.${layer} COMMAND test_${layer})
  set_tests_properties(unit.${layer} PROPERTIES TIMEOUT 900)  # the longest take two or three minutes where nothing else runs
endfunction()

# What a layer takes from one that it does not use is undefined here, so the program cannot be made.
function(armlet_add_layer_tests layer)
  armlet_add_unit_tests(${layer} armlet::runtime ${PROJECT_SOURCE_DIR}/runtime/src)
  get_target_property(layers armlet_layer_${layer} ARMLET_LAYERS)
  add_executable(layer_${layer} support/nothing.cpp)
  target_link_libraries(layer_${layer} PRIVATE ${layers})
  add_test(NAME layer.${layer} COMMAND layer_${layer})
endfunction()

# The same of rooms of a library.
function(armlet_add_room_tests library)
  foreach(room IN LISTS ARGN)
    get_target_property(rooms armlet_room_${room} ARMLET_ROOMS)
    add_executable(room_${room} support/nothing.cpp)
    target_link_libraries(room_${room} PRIVATE ${rooms})
    add_test(NAME layer.${library}.${room} COMMAND room_${room})
  endforeach()
endfunction()

# Laboratories: the server and what it serves, and their page in a browser.
function(armlet_add_lab_tests)
  armlet_add_unit_tests(lab armlet_lab_server ${PROJECT_SOURCE_DIR}/apps/lab)
  target_sources(test_lab PRIVATE ${PROJECT_SOURCE_DIR}/apps/lab/worker/worker.cpp)
  target_compile_definitions(test_lab PRIVATE ARMLET_VERSION="${PROJECT_VERSION}")
  add_test(NAME lab.server COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/lab/server_command.py $<TARGET_FILE:armlet>)
  add_test(NAME lab.file COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/lab/file_command.py $<TARGET_FILE:armlet>)
  add_test(NAME lab.secrets COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/lab/secrets_command.py $<TARGET_FILE:armlet>)
  add_subdirectory(page)
endfunction()

function(armlet_add_script_tests)
  list(TRANSFORM ARGN APPEND /*.rbt)
  file(GLOB_RECURSE scripts CONFIGURE_DEPENDS ${ARGN})
  list(FILTER scripts EXCLUDE REGEX "/modules/")
  if(NOT TARGET armlet_planning)  # these search paths around obstacles
    list(FILTER scripts EXCLUDE REGEX "around|R0644_")
  endif()
  if(NOT TARGET armlet_vision)  # these call OpenCV
    list(FILTER scripts EXCLUDE REGEX "/opencv/|_opencv")
  endif()
  foreach(script IN LISTS scripts)
    cmake_path(NORMAL_PATH script)
    cmake_path(RELATIVE_PATH script BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE name)
    if(name MATCHES "/opencv/|_opencv")
      add_test(NAME ${name} COMMAND script_runner $<TARGET_FILE:armlet> ${script} $<TARGET_FILE:armlet_vision>)
    else()
      add_test(NAME ${name} COMMAND script_runner $<TARGET_FILE:armlet> ${script})
    endif()
  endforeach()
endfunction()

# Functions of OpenCV from outside; and ours compared with those of OpenCV.
function(armlet_add_opencv_tests)
  if(NOT TARGET armlet_vision)
    return()
  endif()
  add_test(NAME vision.command COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/opencv/vision_command.py
           $<TARGET_FILE:armlet> $<TARGET_FILE:armlet_vision>)
  armlet_add_unit_tests(opencv armlet::runtime)
  target_include_directories(test_opencv SYSTEM PRIVATE ${ARMLET_OPENCV_HEADERS})
  target_link_libraries(test_opencv PRIVATE $<TARGET_PROPERTY:armlet_vision,LINK_LIBRARIES>)
  add_dependencies(test_opencv armlet_vision)
endfunction()

# Pictures of runs; and videos, which are read back by OpenCV, where the library that writes them is built.
function(armlet_add_video_tests)
  target_sources(test_apps PRIVATE ${PROJECT_SOURCE_DIR}/apps/armlet/video/kept_scenes.cpp)
  set(with_video "")
  if(TARGET armlet_video)
    armlet_add_unit_tests(video armlet::runtime ${PROJECT_SOURCE_DIR}/apps/armlet)
    target_sources(test_video PRIVATE ${PROJECT_SOURCE_DIR}/apps/armlet/video/video_door.cpp)
    add_executable(read_video video/read_video.cpp)
    armlet_compile_options(read_video)
    target_link_libraries(read_video PRIVATE armlet::runtime)
    foreach(program test_video read_video)
      target_include_directories(${program} SYSTEM PRIVATE ${ARMLET_VIDEOIO_HEADERS})
      target_link_libraries(${program} PRIVATE ${ARMLET_VIDEOIO} ${ARMLET_VIDEOIO_CORE})
      add_dependencies(${program} armlet_video)
    endforeach()
    set(with_video $<TARGET_FILE:armlet_video> $<TARGET_FILE:read_video>)
  endif()
  add_test(NAME video.command COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/video/video_command.py
           $<TARGET_FILE:armlet> ${with_video})
endfunction()

# The examples are laid out, and the commands do to files and show of robots what they say.
function(armlet_add_format_tests)
  armlet_add_opencv_tests()
  armlet_add_video_tests()
  file(GLOB_RECURSE examples CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/examples/*.rbt ${PROJECT_SOURCE_DIR}/apps/lab/gallery/*.rbt)
  add_test(NAME source.examples COMMAND armlet fmt --check ${examples})
  add_test(NAME fmt.command COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/fmt_command.py
           $<TARGET_FILE:armlet>)
  add_test(NAME files.command COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/files_command.py
           $<TARGET_FILE:armlet>)
  add_test(NAME camera.command COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/cameras/camera_command.py
           $<TARGET_FILE:armlet>)
  add_test(NAME replay.command COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/replay_command.py
           $<TARGET_FILE:armlet>)
  if(NOT ARMLET_SANITIZE)  # which makes programs many times slower
    add_test(NAME stop.command COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/stop/stop_command.py
             $<TARGET_FILE:armlet>)
    foreach(part RANGE 3)
      add_test(NAME stop.library.${part} COMMAND Python3::Interpreter
               ${CMAKE_CURRENT_SOURCE_DIR}/stop/stop_library.py $<TARGET_FILE:armlet> ${part} 4)
    endforeach()
  endif()
  add_test(NAME trace.numpy COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/numpy_command.py
           $<TARGET_FILE:armlet>)
  set_tests_properties(trace.numpy PROPERTIES SKIP_RETURN_CODE 77)
  add_test(NAME planning.command COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/planning_command.py
           $<TARGET_FILE:armlet>)
  set_tests_properties(planning.command PROPERTIES SKIP_RETURN_CODE 77)
  add_test(NAME prompt.command COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/prompt_command.py
           $<TARGET_FILE:armlet>)
  add_test(NAME lab.command COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/lab_command.py
           $<TARGET_FILE:armlet>)
  add_test(NAME robot.command COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/robot_command.py
           $<TARGET_FILE:armlet>)
  add_test(NAME glb.command COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/glb_command.py
           $<TARGET_FILE:armlet>)
  add_test(NAME mesh.command COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/mesh_command.py
           $<TARGET_FILE:armlet>)
  add_test(NAME world.command COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/world_command.py
           $<TARGET_FILE:armlet>)
  add_test(NAME storyboard.command COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/storyboard_command.py
           $<TARGET_FILE:armlet>)
  add_test(NAME notices COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/notices.py
           $<TARGET_FILE:armlet> ${PROJECT_BINARY_DIR})
  armlet_add_convert_tests()
  if(NOT ARMLET_SANITIZE)  # valgrind runs no sanitizers
    add_test(NAME world.growth COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/world_growth.py
             $<TARGET_FILE:armlet>)
    set_tests_properties(world.growth PROPERTIES SKIP_RETURN_CODE 77)
  endif()
endfunction()

# Meshes of other formats. What a false size does is reported by the limit on memory, which sanitizers do not keep.
function(armlet_add_convert_tests)
  armlet_add_unit_tests(convert armlet_mesh_client ${PROJECT_SOURCE_DIR}/apps/mesh)
  target_sources(test_convert PRIVATE ${PROJECT_SOURCE_DIR}/apps/mesh/converter/confine.cpp)
  set(converter "")
  if(TARGET armlet-mesh)
    set(converter $<TARGET_FILE:armlet-mesh>)
  endif()
  if(NOT ARMLET_SANITIZE)
    add_test(NAME convert.command COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/convert_command.py
             $<TARGET_FILE:armlet> "${converter}")
  endif()
endfunction()

# Installs this build into a folder of its own, then builds host programs against it and looks at what they print and see:
# that of tests/embed, the examples, and one of the language alone, from which Eigen is hidden.
function(armlet_add_embed_test)
  set(prefix ${CMAKE_CURRENT_BINARY_DIR}/installed)
  set(folder ${CMAKE_CURRENT_SOURCE_DIR}/embed)
  add_test(NAME embed.clear COMMAND ${CMAKE_COMMAND} -E rm -rf ${prefix})  # of what is installed no longer
  set_tests_properties(embed.clear PROPERTIES FIXTURES_SETUP no_package)
  add_test(NAME embed.install COMMAND ${CMAKE_COMMAND} --install ${PROJECT_BINARY_DIR} --prefix ${prefix})
  set_tests_properties(embed.install PROPERTIES FIXTURES_SETUP installed_package FIXTURES_REQUIRED no_package)
  armlet_add_host_test(embed.host ${folder} "" embed_host)
  set(hosts ${PROJECT_SOURCE_DIR}/examples/embed)
  armlet_add_host_test(embed.examples ${hosts} ""
    ${Python3_EXECUTABLE} ${folder}/examples.py ${hosts} ${CMAKE_CURRENT_BINARY_DIR}/embed.examples)
  if(NOT ARMLET_SANITIZE)  # its host is linked by hand
    add_test(NAME embed.layout COMMAND Python3::Interpreter ${folder}/check_layout.py ${CMAKE_CXX_COMPILER} ${prefix})
    set_tests_properties(embed.layout PROPERTIES FIXTURES_REQUIRED installed_package)
  endif()
  if(NOT ARMLET_SANITIZE)  # the libraries of sanitizers show their symbols, and use exceptions
    armlet_add_host_test(embed.language ${folder}/language_only -DCMAKE_DISABLE_FIND_PACKAGE_Eigen3=ON
      ${Python3_EXECUTABLE} ${folder}/check_package.py ${CMAKE_CXX_COMPILER} ${prefix} ${CMAKE_CURRENT_BINARY_DIR}/embed.language)
  endif()
endfunction()

# Builds the project in SOURCES against the installed package, with one more OPTION, and runs the command.
function(armlet_add_host_test name sources option)
  set(flags "")
  if(ARMLET_SANITIZE)
    set(flags -fsanitize=${ARMLET_SANITIZE})
  endif()
  add_test(NAME ${name} COMMAND ${CMAKE_CTEST_COMMAND} --build-and-test ${sources} ${CMAKE_CURRENT_BINARY_DIR}/${name}
    --build-generator ${CMAKE_GENERATOR}
    --build-options -DCMAKE_PREFIX_PATH=${CMAKE_CURRENT_BINARY_DIR}/installed -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}
                    -DCMAKE_CXX_FLAGS=${flags} ${option}
    --test-command ${ARGN})
  set_tests_properties(${name} PROPERTIES FIXTURES_REQUIRED installed_package)
endfunction()

# What the sources must be like, what the documents say, and input that nobody would mean.
function(armlet_add_source_tests)
  armlet_add_deletions()
  armlet_add_room_tests(interpreter base vocabulary ast habits hir program syntax check lower vm driver editor format)
  armlet_add_room_tests(stdlib host values rules moves numbers robot world motion trajectory dynamics plot vision laboratory session
    controls workspace)
  foreach(source changelog decisions layers messages names sizes structure words)
    add_test(NAME source.${source} COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tools/check_${source}.py)
  endforeach()
  add_test(NAME source.citations COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tools/check_citations.py)
  add_test(NAME docs.mathematics
    COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tools/check_mathematics.py $<TARGET_FILE:armlet>)
  add_test(NAME docs.grammar
    COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/grammar_command.py ${PROJECT_SOURCE_DIR})
  set_target_properties(make_tables PROPERTIES EXCLUDE_FROM_ALL OFF)
  add_test(NAME source.tables COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tools/check_tables.py $<TARGET_FILE:make_tables>)
  add_test(NAME docs.stdlib
    COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tools/check_reference.py $<TARGET_FILE:armlet>)
  add_test(NAME docs.pictures
    COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tools/check_pictures.py $<TARGET_FILE:armlet>)
  add_test(NAME docs.programs
    COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/snippets.py $<TARGET_FILE:armlet> ${PROJECT_SOURCE_DIR})
  add_test(NAME source.refused COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/refused_sources.py ${CMAKE_CXX_COMPILER} ${PROJECT_SOURCE_DIR})
  add_test(NAME hostile COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/hostile.py $<TARGET_FILE:armlet>)
endfunction()

# Programs with a token missing: a part of them in test_stdlib, all of them by a program of its own.
function(armlet_add_deletions)
  target_sources(test_stdlib PRIVATE support/deletions.cpp)
  add_executable(token_deletions EXCLUDE_FROM_ALL support/token_deletions.cpp support/deletions.cpp)
  armlet_compile_options(token_deletions)
  target_link_libraries(token_deletions PRIVATE armlet::stdlib fmt::fmt)
endfunction()

# The platform of WebAssembly and its sort compiled for this machine, in place of this machine's; and the module itself, if there is one.
function(armlet_add_wasm_tests)
  armlet_add_unit_tests(bare armlet::core ${PROJECT_SOURCE_DIR}/runtime/src)
  target_sources(test_bare PRIVATE ${PROJECT_SOURCE_DIR}/runtime/src/core/bare/files.cpp
                                   ${PROJECT_SOURCE_DIR}/runtime/src/core/bare/platform.cpp
                                   ${PROJECT_SOURCE_DIR}/cmake/wasm/missing_sorting.cpp)
  target_include_directories(test_bare PRIVATE ${PROJECT_SOURCE_DIR}/cmake/wasm)
  add_test(NAME wasm.programs COMMAND ${PROJECT_SOURCE_DIR}/tests/wasm/run.sh
           $<TARGET_FILE:armlet> $<TARGET_FILE:write_programs> 200)
  set_tests_properties(wasm.programs PROPERTIES SKIP_RETURN_CODE 77)
endfunction()

# ./dev test quick: what together takes less than 20 s on two processors, a second at most each.
function(armlet_label_quick_tests)
  get_property(quick DIRECTORY PROPERTY TESTS)
  list(FILTER quick INCLUDE REGEX "^(examples/|tests/scripts/|source\\.|layer\\.|unit\\.(backend|chain|core|grasp|host|image|plot|support|vision|world)$)")
  list(FILTER quick EXCLUDE REGEX "opencv|07_visual_servo|random_lines|stuck_tasks|torque_limit|source\\.refused")
  set_tests_properties(${quick} PROPERTIES LABELS quick)
endfunction()
