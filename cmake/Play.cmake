# Demos: chapters/NN_slug/demo.cpp, where a section has one.
#
#   demo/NN_slug        the demo without a page: a program that its test plays by a script, in every build
#   play/NN_slug.js     the demo for the site, as WebAssembly: target demos; `./course dev publish` keeps it in demos/
#   play/NN_slug_mine.js   the same with the student's file: target NN_slug_play_mine
#   play/NN_slug_bug.js    the same with exercises/NN_bug.cpp: target NN_slug_play_bug
#
# In a demo of section(NN_slug BUILDS_ON ... PLAYS_YOURS) all functions of earlier sections, too, are called through the
# page, which passes each call on to ours or to the student's. So it is in any demo of a handout, which has no ours to link.
#
# The last three need Debian's Clang 19 with its C library and C++ library for WebAssembly. Without them all the rest is
# built, and the site has the demos that are kept in demos/.
find_program(COURSE_WASM_CLANG clang++-19)
if(COURSE_WASM_CLANG AND NOT COURSE_WASM)
  set(probe ${PROJECT_BINARY_DIR}/CMakeFiles/wasm_probe)
  file(WRITE ${probe}.cpp "#include <cmath>\n#include <vector>\nint main() { return int(std::fmod(5, 3)); }\n")
  execute_process(COMMAND ${COURSE_WASM_CLANG} --target=wasm32-wasi -std=c++20 ${probe}.cpp -o ${probe}.wasm
    RESULT_VARIABLE failed OUTPUT_QUIET ERROR_QUIET)
  if(failed EQUAL 0)
    set(COURSE_WASM ON CACHE INTERNAL "whether demos can be compiled for a page")
  endif()
endif()
if(COURSE_WASM)
  add_custom_target(demos)
  file(WRITE ${PROJECT_BINARY_DIR}/play/can_compile "") # for ./course play
endif()

add_custom_target(demo-tests)
add_test(NAME demos.stills COMMAND ${NODE} --test ${PROJECT_SOURCE_DIR}/tests/play/stills.test.mjs)
add_test(NAME demos.colours COMMAND ${NODE} --test ${PROJECT_SOURCE_DIR}/tests/play/colours.test.mjs)
set_tests_properties(demos.stills demos.colours PROPERTIES LABELS slow)

get_target_property(eigen Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
set(COURSE_WASM_FLAGS --target=wasm32-wasi -std=c++20 -Os ${COURSE_CODE_FLAGS}
  -DEIGEN_INITIALIZE_MATRICES_BY_NAN # as everywhere in the course
  -D_LIBCPP_HARDENING_MODE=_LIBCPP_HARDENING_MODE_EXTENSIVE -I${PROJECT_SOURCE_DIR}/tools/play/libcxx # v[7] beyond the end is told
  -ffile-prefix-map=${PROJECT_SOURCE_DIR}/= -I${PROJECT_SOURCE_DIR}/chapters -isystem ${eigen})
set(COURSE_WASM_LINK --target=wasm32-wasi -mexec-model=reactor
  -Wl,--stack-first,-z,stack-size=262144 # endless recursion traps, instead of overwriting data
  -Wl,--max-memory=67108864,--export=__stack_pointer
  -Wl,--allow-undefined)  # a student's file may lack a function, or use one that a page does not have: the page says so
# What a student's file is compiled with, besides: a call at each branch, so that an endless loop can be stopped.
set(COURSE_WASM_FUEL -fsanitize-coverage=trace-pc,no-prune -fno-finite-loops)

# wasm_object(RESULT source flags...): an object for a page; the section's header is on the path.
function(wasm_object object source)
  set(precompiled ${ARGN})
  list(FILTER precompiled INCLUDE REGEX "\\.pch$")
  cmake_path(RELATIVE_PATH source BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE shown)
  add_custom_command(OUTPUT ${object}
    COMMAND ${COURSE_WASM_CLANG} ${COURSE_WASM_FLAGS} -I${chapter} ${ARGN} -MD -MF ${object}.d -c ${source} -o ${object}
    DEPENDS ${source} ${precompiled} DEPFILE ${object}.d VERBATIM COMMENT "Compiling ${shown} for pages")
endfunction()

# earlier_headers(RESULT section): what is read before a file of this section, the headers that it builds on. Their functions
# are linked with ours, or called through the page.
function(earlier_headers result section)
  set(flags -I${host} -I${PROJECT_SOURCE_DIR}/tools)
  if(section_PLAYS_YOURS)
    list(APPEND flags -include calls.hpp)
  endif()
  foreach(one ${COURSE_${section}_BUILDS_ON})
    string(SUBSTRING ${one} 3 -1 its_slug)
    list(APPEND flags -include ${one}/${its_slug}.hpp)
  endforeach()
  set(${result} ${flags} PARENT_SCOPE)
endfunction()

# wasm_answers(RESULT whose): flags for a file that answers exercises, ours or yours.
function(wasm_answers result whose)
  set(flags -include answers.hpp "-DCOURSE_ANSWERS=\"${whose}\"")
  if(section_PLAYS_YOURS)
    list(APPEND flags -DCOURSE_IF_CALLED)
  endif()
  if(whose STREQUAL yours)
    list(APPEND flags ${COURSE_WASM_FUEL} -w)
  endif()
  set(${result} ${flags} PARENT_SCOPE)
endfunction()

# wasm_demo(RESULT name objects and flags...): linked, and packed into a script that gives it this name.
function(wasm_demo script name)
  set(inputs ${ARGN})
  list(FILTER inputs INCLUDE REGEX "\\.o$")
  cmake_path(REPLACE_EXTENSION script .wasm OUTPUT_VARIABLE linked)
  set(link ${COURSE_WASM_CLANG})
  set(to -o ${linked})
  set(linker)
  if(section_PLAYS_YOURS)
    set(linker ${PROJECT_SOURCE_DIR}/tools/play/link.cjs)
    set(link ${NODE} ${linker} ${linked} ${link})
    set(to)
  endif()
  add_custom_command(OUTPUT ${script}
    COMMAND ${link} ${COURSE_WASM_LINK} ${ARGN} ${to}
    COMMAND ${NODE} ${PROJECT_SOURCE_DIR}/tools/play/pack.cjs ${linked} ${name} > ${script}
    DEPENDS ${inputs} ${linker} ${PROJECT_SOURCE_DIR}/tools/play/pack.cjs VERBATIM COMMENT "Packing the demo ${name}")
endfunction()

macro(section_demo)
  set(play ${PROJECT_BINARY_DIR}/play)
  file(MAKE_DIRECTORY ${play})
  if(COURSE_WASM AND solved)
    wasm_object(${play}/${section}_solution.o ${solution}) # for later sections
  endif()
  if(EXISTS ${chapter}/demo.cpp)
    if(solved)
      section_script()
    endif()
    if(COURSE_WASM)
      section_wasm()
    endif()
  endif()
endmacro()

# test_demo(name program kept alone): that a demo agrees with the one that is kept for a page, and goes on under a wild hand; if
# tests are thorough, ten minutes of each game under that hand, and so many frames of 0.1 s alone.
function(test_demo name program kept alone)
  add_test(NAME ${name} COMMAND ${NODE} ${PROJECT_SOURCE_DIR}/tests/play/script.mjs $<TARGET_FILE:${program}>
    ${PROJECT_SOURCE_DIR}/demos/${kept}.js)
  add_test(NAME ${name}.wild COMMAND ${program} --wild 600)
  set_tests_properties(${name} ${name}.wild PROPERTIES LABELS slow)
  if(COURSE_THOROUGH)
    add_test(NAME ${name}.wild_for_long COMMAND ${program} --wild 36000)
    add_test(NAME ${name}.alone COMMAND ${program} --alone ${alone})
    set_tests_properties(${name}.wild_for_long ${name}.alone PROPERTIES LABELS wild TIMEOUT 3600)
  endif()
endfunction()

# The demo without a page, on our functions, and what plays it.
macro(section_script)
  add_executable(${section}_demo tools/play/host/script.cpp tools/play/host/checked.cpp $<TARGET_OBJECTS:${section}_reference> ${earlier_objects})
  stand_behind_student_header(${section}_demo course_flags)
  target_compile_definitions(${section}_demo PRIVATE DEMO="${section}/demo.cpp" COURSE_SECTION="${slug}.hpp")
  target_include_directories(${section}_demo PRIVATE tools)
  set_target_properties(${section}_demo PROPERTIES OUTPUT_NAME ${section} RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/demo)
  add_dependencies(demo-tests ${section}_demo)
  add_dependencies(${section}_checks ${section}_demo)
  set(alone 1188000)
  if(section MATCHES "^(08_nt_collisions|11_particles)$") # where balls or sparks are many
    set(alone 36000)
  endif()
  test_demo(${section}.demo ${section}_demo ${section} ${alone})
  file(GLOB tasks CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/${section}/*.mjs) # what a place asks can be done
  foreach(task ${tasks})
    cmake_path(GET task STEM stem)
    add_test(NAME ${section}.demo.${stem} COMMAND ${NODE} ${task} $<TARGET_FILE:${section}_demo>)
    set_tests_properties(${section}.demo.${stem} PROPERTIES LABELS slow)
  endforeach()
endmacro()

macro(section_wasm)
  set(host ${PROJECT_SOURCE_DIR}/tools/play/host)
  earlier_headers(known_before ${section})
  wasm_answers(as_ours ours)
  wasm_answers(as_yours yours)
  set(earlier_wasm)
  set(earlier_mine)
  if(section_PLAYS_YOURS)
    earlier_in_the_page()
  else()
    list(TRANSFORM earlier REPLACE "(.+)" "${play}/\\1_solution.o" OUTPUT_VARIABLE earlier_wasm)
  endif()
  wasm_object(${play}/${section}_page.o ${host}/page.cpp ${known_before} -include calls.hpp "-DDEMO=\"${section}/demo.cpp\"")
  set(objects ${play}/${section}_page.o)
  if(solved)
    wasm_object(${play}/${section}_ours.o ${solution} ${known_before} ${as_ours})
    section_bugs(${section} ${play}/${section}_bugs)
    list(APPEND objects ${play}/${section}_ours.o ${bugs})
  endif()
  list(APPEND objects ${earlier_wasm})
  # What a student's file reads anyway is compiled beforehand: a save is then in the page in a second.
  set(known ${play}/${section}_known.hpp)
  file(CONFIGURE OUTPUT ${known} CONTENT "#include <${section}/${slug}.hpp>\n#include <algorithm>\n#include <cmath>\n")
  set(calls ${known_before} ${as_yours})
  wasm_object(${known}.pch ${known} ${calls} -x c++-header)
  if(EXISTS ${PROJECT_SOURCE_DIR}/exercises/${section}.cpp)
    section_wasm_of(${PROJECT_SOURCE_DIR}/exercises/${section}.cpp ${play}/${section}_mine ${earlier_mine})
    add_custom_target(${section}_play_mine DEPENDS ${play}/${section}_mine.js)
    add_dependencies(lab ${section}_play_mine)
  endif()
  if(solved)
    section_wasm_with_ours()
  endif()
endmacro()

# What needs our functions: the published demo, one with a bug, and what tests play.
macro(section_wasm_with_ours)
  wasm_demo(${play}/${section}.js ${section} ${objects} -Wl,--strip-all)
  add_custom_target(${section}_play DEPENDS ${play}/${section}.js)
  add_dependencies(demos ${section}_play)
  # What `./course bug` has written, or not yet: one function, and all others are ours
  section_wasm_of(${PROJECT_SOURCE_DIR}/exercises/${section_number}_bug.cpp ${play}/${section}_bug)
  add_custom_target(${section}_play_bug DEPENDS ${play}/${section}_bug.js)
  # Files that go wrong in a page, each in a way of its own, for tests/site/play.test.mjs; and earlier sections' beside them
  file(GLOB wrong CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/play/${section}/*.cpp)
  if(section_PLAYS_YOURS)
    earlier_files(earlier_mine ${PROJECT_SOURCE_DIR}/tests/play/${section}/earlier ${play}/wrong/${section})
  endif()
  foreach(file ${wrong})
    cmake_path(GET file STEM stem)
    file(MAKE_DIRECTORY ${play}/wrong)
    section_wasm_of(${file} ${play}/wrong/${stem} ${earlier_mine})
    list(APPEND wrong_scripts ${play}/wrong/${stem}.js)
  endforeach()
  add_custom_target(${section}_play_wrong DEPENDS ${wrong_scripts})
endmacro()

# The demo with this file in the place of a student's, as ${to}.js; and these objects of earlier sections.
macro(section_wasm_of file to)
  wasm_object(${to}.o ${file} ${calls} -include-pch ${known}.pch)
  # The names of functions stay: they say in which exercise something went wrong.
  wasm_demo(${to}.js ${section}/mine ${objects} ${to}.o ${ARGN} -Wl,--strip-debug)
endmacro()

# section_bugs(one to): ${bugs}, the object ${to}.o with those wrong answers of a section that its demo can play.
function(section_bugs one to)
  set(bugs "" PARENT_SCOPE)
  set(wrong ${PROJECT_SOURCE_DIR}/tests/${one}/mutants.diff)
  if(NOT EXISTS ${wrong})
    return()
  endif()
  string(SUBSTRING ${one} 3 -1 its_slug)
  add_custom_command(OUTPUT ${to}.cpp COMMAND answers-in-one ${PROJECT_SOURCE_DIR} ${one} ${to}.cpp
    DEPENDS answers-in-one ${wrong} ${PROJECT_SOURCE_DIR}/tests/bugs.txt ${PROJECT_SOURCE_DIR}/solutions/${one}.cpp
      ${PROJECT_SOURCE_DIR}/chapters/${one}/${its_slug}.hpp VERBATIM COMMENT "")
  page_answers(${one} ${to}.cpp ${to}.o ours)
  set(bugs ${to}.o PARENT_SCOPE)
endfunction()

# Earlier sections for a demo that plays yours of them, too: our solutions, where they are, and a student's files, of which
# some may not compile, and some may be gone.
macro(earlier_in_the_page)
  foreach(one ${earlier})
    if(EXISTS ${PROJECT_SOURCE_DIR}/solutions/${one}.cpp)
      page_answers(${one} ${PROJECT_SOURCE_DIR}/solutions/${one}.cpp ${play}/${section}_${one}_ours.o ours)
      section_bugs(${one} ${play}/${section}_${one}_bugs)
      list(APPEND earlier_wasm ${play}/${section}_${one}_ours.o ${bugs})
    endif()
  endforeach()
  earlier_files(earlier_mine ${PROJECT_SOURCE_DIR}/exercises ${play}/${section})
endmacro()

# earlier_files(RESULT folder to): the objects of those files of earlier sections that are in this folder.
function(earlier_files result folder to)
  set(objects)
  file(GLOB files CONFIGURE_DEPENDS ${folder}/*.cpp)
  foreach(one ${earlier})
    if(${folder}/${one}.cpp IN_LIST files)
      page_answers(${one} ${folder}/${one}.cpp ${to}_${one}_mine.o yours)
      list(APPEND objects ${to}_${one}_mine.o)
    endif()
  endforeach()
  set(${result} ${objects} PARENT_SCOPE)
endfunction()

# page_answers(one file object whose): a file that answers exercises of a section, for a page. Yours may not compile.
function(page_answers one file object whose)
  set(chapter ${PROJECT_SOURCE_DIR}/chapters/${one})
  earlier_headers(known_before ${one})
  wasm_answers(as ${whose})
  if(whose STREQUAL "ours")
    wasm_object(${object} ${file} ${known_before} ${as})
    return()
  endif()
  wasm_object(${object}.broken ${host}/broken.cpp "-DCOURSE_BROKEN=\"broken ${one}.cpp\"")
  set(compile ${PROJECT_SOURCE_DIR}/tools/play/earlier.cjs)
  cmake_path(RELATIVE_PATH file BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE shown)
  add_custom_command(OUTPUT ${object}
    COMMAND ${NODE} ${compile} ${object}.broken ${object} ${COURSE_WASM_CLANG} ${COURSE_WASM_FLAGS} -I${chapter} ${known_before} ${as}
      -MD -MF ${object}.d -c ${file}
    DEPENDS ${compile} ${file} ${object}.broken DEPFILE ${object}.d VERBATIM COMMENT "Compiling ${shown} for pages")
endfunction()
