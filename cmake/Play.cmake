# Demos: chapters/NN_slug/demo.cpp, where a section has one.
#
#   demo/NN_slug        the demo without a page: a program that its test plays by a script, in every build
#   play/NN_slug.js     the demo for the site, as WebAssembly: target demos; `./course dev publish` keeps it in demos/
#   play/NN_slug_mine.js   the student's file as a module that it may call: target NN_slug_play_mine
#   play/NN_slug_bug.js    exercises/NN_bug.cpp as such a module: target NN_slug_play_bug
#
# In a demo of section(NN_slug BUILDS_ON ... PLAYS_YOURS) all functions of earlier sections, too, are called through the
# page, which passes each call on to ours or to the student's.
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
  -D_LIBCPP_HARDENING_MODE=_LIBCPP_HARDENING_MODE_EXTENSIVE # v[7] beyond the end is told
  -ffile-prefix-map=${PROJECT_SOURCE_DIR}/= -I${PROJECT_SOURCE_DIR}/chapters -isystem ${eigen})
set(COURSE_WASM_LINK --target=wasm32-wasi -mexec-model=reactor
  -Wl,--stack-first,-z,stack-size=262144 # endless recursion traps, instead of overwriting data
  -Wl,--max-memory=67108864,--export=__stack_pointer
  -Wl,--allow-undefined)  # a student's file may use a function that a page does not have: the page says so
set(COURSE_WASM_CLAIMS ${PROJECT_SOURCE_DIR}/tools/play/libcxx) # what tells of them
set(host ${PROJECT_SOURCE_DIR}/tools/play/host)

# wasm_object(RESULT source flags...): an object for a page; the section's header is on the path.
function(wasm_object object source)
  set(precompiled ${ARGN})
  list(FILTER precompiled INCLUDE REGEX "\\.pch$")
  cmake_path(RELATIVE_PATH source BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE shown)
  add_custom_command(OUTPUT ${object}
    COMMAND ${COURSE_WASM_CLANG} ${COURSE_WASM_FLAGS} -I${COURSE_WASM_CLAIMS} -I${chapter} ${ARGN} -MD -MF ${object}.d -c ${source} -o ${object}
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

# wasm_answers(RESULT): flags for a file with our answers, right or wrong.
function(wasm_answers result)
  set(flags -include answers.hpp)
  if(section_PLAYS_YOURS)
    list(APPEND flags -DCOURSE_IF_CALLED)
  endif()
  set(${result} ${flags} PARENT_SCOPE)
endfunction()

# answer_object(RESULT source flags...): for the module of a student's file, which has exceptions.
set(COURSE_WASM_JUDGE ${PROJECT_SOURCE_DIR}/tools/judge/page)
set(COURSE_WASM_ANSWER -fwasm-exceptions -fno-finite-loops -I${PROJECT_SOURCE_DIR}/tools) # a loop that never ends is to be found
function(answer_object object source)
  set(COURSE_WASM_CLAIMS ${COURSE_WASM_JUDGE}/libcxx)
  wasm_object(${object} ${source} ${COURSE_WASM_ANSWER} ${ARGN})
endfunction()

# wasm_demo(RESULT name objects and flags...): linked, and packed into a script that gives it this name. pack_words: see pack.cjs.
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
    COMMAND ${NODE} ${PROJECT_SOURCE_DIR}/tools/play/pack.cjs ${linked} ${name} ${pack_words} > ${script}
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
  section_answer_parts()
  set(mine)
  if(EXISTS ${PROJECT_SOURCE_DIR}/exercises/${section}.cpp)
    if(section_PLAYS_YOURS)
      earlier_files(mine ${PROJECT_SOURCE_DIR}/exercises ${play}/${section} ${earlier})
    endif()
    answers_script(${PROJECT_SOURCE_DIR}/exercises/${section}.cpp ${play}/${section}_mine ${mine})
    add_custom_target(${section}_play_mine DEPENDS ${play}/${section}_mine.js)
  endif()
  if(solved)
    section_wasm_with_ours()
  endif()
endmacro()

# What needs our functions: the published demo, one with a bug, and what tests play.
macro(section_wasm_with_ours)
  earlier_headers(known_before ${section})
  wasm_answers(as_ours)
  set(earlier_wasm)
  if(section_PLAYS_YOURS)
    foreach(one ${earlier})
      our_answers(earlier_wasm ${one} ${play}/${section}_${one})
      our_bugs(earlier_wasm ${one} ${play}/${section}_${one})
    endforeach()
  else()
    list(TRANSFORM earlier REPLACE "(.+)" "${play}/\\1_solution.o" OUTPUT_VARIABLE earlier_wasm)
  endif()
  wasm_object(${play}/${section}_page.o ${host}/page.cpp ${known_before} -include calls.hpp "-DDEMO=\"${section}/demo.cpp\"")
  set(ours)
  our_answers(ours ${section} ${play}/${section})
  our_bugs(ours ${section} ${play}/${section})
  wasm_demo(${play}/${section}.js ${section} ${play}/${section}_page.o ${ours} ${earlier_wasm} -Wl,--strip-all)
  add_custom_target(${section}_play DEPENDS ${play}/${section}.js)
  add_dependencies(demos ${section}_play)
  # What `./course bug` has written, or not yet: one function, and all others are ours
  answers_script(${PROJECT_SOURCE_DIR}/exercises/${section_number}_bug.cpp ${play}/${section}_bug)
  add_custom_target(${section}_play_bug DEPENDS ${play}/${section}_bug.js)
  # Files that go wrong in a page, each in a way of its own, for tests/site/play.test.mjs; and earlier sections' beside them
  file(GLOB wrong CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/play/${section}/*.cpp)
  set(wrong_earlier)
  if(section_PLAYS_YOURS)
    earlier_files(wrong_earlier ${PROJECT_SOURCE_DIR}/tests/play/${section}/earlier ${play}/wrong/${section} ${earlier})
  endif()
  foreach(file ${wrong})
    cmake_path(GET file STEM stem)
    file(MAKE_DIRECTORY ${play}/wrong)
    answers_script(${file} ${play}/wrong/${stem} ${wrong_earlier})
    list(APPEND wrong_scripts ${play}/wrong/${stem}.js)
  endforeach()
  add_custom_target(${section}_play_wrong DEPENDS ${wrong_scripts})
endmacro()

# our_answers(RESULT one to flags...): appends the object of our functions of a section, as a page calls them.
function(our_answers result one to)
  set(chapter ${PROJECT_SOURCE_DIR}/chapters/${one})
  earlier_headers(known_before ${one})
  wasm_answers(as_ours)
  wasm_object(${to}_ours.o ${PROJECT_SOURCE_DIR}/solutions/${one}.cpp ${known_before} ${as_ours} ${ARGN})
  set(${result} ${${result}} ${to}_ours.o PARENT_SCOPE)
endfunction()

# our_answers_beside(RESULT one to): the same for the module of a student's file.
function(our_answers_beside result one to)
  set(COURSE_WASM_CLAIMS ${COURSE_WASM_JUDGE}/libcxx)
  our_answers(${result} ${one} ${to} ${COURSE_WASM_ANSWER} -DCOURSE_OURS_BESIDE)
  set(${result} ${${result}} PARENT_SCOPE)
endfunction()

# our_bugs(RESULT one to): the same as our_answers for those wrong answers of a section that a demo can play.
function(our_bugs result one to)
  set(wrong ${PROJECT_SOURCE_DIR}/tests/${one}/mutants.diff)
  if(NOT EXISTS ${wrong})
    return()
  endif()
  set(chapter ${PROJECT_SOURCE_DIR}/chapters/${one})
  string(SUBSTRING ${one} 3 -1 its_slug)
  add_custom_command(OUTPUT ${to}_bugs.cpp COMMAND answers-in-one ${PROJECT_SOURCE_DIR} ${one} ${to}_bugs.cpp
    DEPENDS answers-in-one ${wrong} ${PROJECT_SOURCE_DIR}/tests/bugs.txt ${PROJECT_SOURCE_DIR}/solutions/${one}.cpp
      ${chapter}/${its_slug}.hpp VERBATIM COMMENT "")
  earlier_headers(known_before ${one})
  wasm_answers(as_ours)
  wasm_object(${to}_bugs.o ${to}_bugs.cpp ${known_before} ${as_ours})
  set(${result} ${${result}} ${to}_bugs.o PARENT_SCOPE)
endfunction()

# What a student's file of this section is linked with: its server, what stands in for functions that it lacks, and a header that
# is compiled beforehand, so that a save is in the page in a second. Later sections call our functions of this one, or, without
# ours, the student's; where the demo plays the student's, they ask for them.
macro(section_answer_parts)
  answer_object(${play}/${section}_server.o ${COURSE_WASM_JUDGE}/server.cpp "-DCOURSE_SECTION=\"${slug}.hpp\"")
  answer_object(${play}/${section}_missing.o ${PROJECT_SOURCE_DIR}/tests/${section}/stub.cpp -w -DCOURSE_STUB_BEHIND -include judge/server/missing.hpp)
  set(known ${play}/${section}_known.hpp)
  file(CONFIGURE OUTPUT ${known} CONTENT "#include <${section}/${slug}.hpp>\n#include <algorithm>\n#include <cmath>\n")
  answer_object(${known}.pch ${known} -w -x c++-header)
  if(solved)
    answer_object(${play}/${section}_answers.o ${solution})
    set(COURSE_${section}_ANSWERS ${play}/${section}_answers.o CACHE INTERNAL "")
  else()
    file(GLOB written CONFIGURE_DEPENDS exercises/${section}.cpp)
    set(COURSE_${section}_ANSWERS ${play}/${section}_missing.o CACHE INTERNAL "")
    if(written)
      earlier_object(${section} ${written} ${play}/${section}_answers.o)
      set(COURSE_${section}_ANSWERS ${play}/${section}_answers.o ${play}/${section}_missing.o CACHE INTERNAL "")
    endif()
  endif()
  set(called)
  if(solved AND section_PLAYS_YOURS)
    earlier_headers(known_before ${section})
    set(called ${play}/${section}_asks.o)
    answer_object(${called} ${host}/asks.cpp ${known_before} -DCOURSE_OURS_BESIDE -DCOURSE_EMITTED)
    foreach(one ${earlier})
      our_answers_beside(called ${one} ${play}/${section}_beside_${one})
    endforeach()
  else()
    foreach(one ${earlier})
      list(APPEND called ${COURSE_${one}_ANSWERS})
    endforeach()
  endif()
  set(COURSE_${section}_CALLED ${called} CACHE INTERNAL "")
  foreach(part exceptions assertion) # of all sections
    get_property(made GLOBAL PROPERTY course_answer_${part} SET)
    if(NOT made)
      answer_object(${play}/${part}.o ${COURSE_WASM_JUDGE}/${part}.cpp)
      set_property(GLOBAL PROPERTY course_answer_${part} made)
    endif()
  endforeach()
endmacro()

# answer_entry(RESULT section file object): what link_answers.mjs is told of a student's file.
function(answer_entry result section file object)
  set(parts ${file} ${object} ${play}/${section}_server.o ${play}/${section}_missing.o ${play}/exceptions.o ${play}/assertion.o
    ${COURSE_${section}_CALLED})
  list(JOIN parts , parts)
  set(${result} ${section}=${parts} PARENT_SCOPE)
endfunction()

# answers_script(file to entries...): a student's file, or one in its place, as a module in ${to}.js; and those of earlier sections.
function(answers_script file to)
  answer_object(${to}.o ${file} -w -include-pch ${known}.pch)
  answer_entry(own ${section} ${file} ${to}.o)
  pack_answers(${to}.js ${section} ${own} ${ARGN})
endfunction()

# pack_answers(script demo entries...)
function(pack_answers script demo)
  set(linker ${PROJECT_SOURCE_DIR}/tools/play/link_answers.mjs)
  string(REGEX REPLACE "[^;=]*=" "" inputs "${ARGN}")
  string(REPLACE "," ";" inputs "${inputs}")
  add_custom_command(OUTPUT ${script}
    COMMAND ${NODE} ${linker} ${script} ${demo} ${COURSE_WASM_CLANG} ${COURSE_WASM_LINK} -Wl,--strip-debug,--gc-sections -- ${ARGN}
    DEPENDS ${linker} ${inputs} ${PROJECT_SOURCE_DIR}/tools/play/fuel.mjs ${PROJECT_SOURCE_DIR}/tools/play/wasm.mjs VERBATIM
    COMMENT "Packing answers for the demo ${demo}")
endfunction()

# earlier_files(RESULT folder to sections...): entries for those files of earlier sections that are in this folder.
function(earlier_files result folder to)
  set(entries)
  file(GLOB files CONFIGURE_DEPENDS ${folder}/*.cpp)
  foreach(one ${ARGN})
    if(${folder}/${one}.cpp IN_LIST files)
      earlier_object(${one} ${folder}/${one}.cpp ${to}_${one}_mine.o)
      answer_entry(entry ${one} ${folder}/${one}.cpp ${to}_${one}_mine.o)
      list(APPEND entries ${entry})
    endif()
  endforeach()
  set(${result} ${entries} PARENT_SCOPE)
endfunction()

# earlier_object(section file object): a student's file of an earlier section, which may not compile.
function(earlier_object one file object)
  set(compile ${PROJECT_SOURCE_DIR}/tools/play/earlier.cjs)
  string(SUBSTRING ${one} 3 -1 its_slug)
  cmake_path(RELATIVE_PATH file BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE shown)
  add_custom_command(OUTPUT ${object}
    COMMAND ${NODE} ${compile} ${its_slug} ${object} ${COURSE_WASM_CLANG} ${COURSE_WASM_FLAGS} -I${COURSE_WASM_JUDGE}/libcxx
      -I${PROJECT_SOURCE_DIR}/chapters/${one} ${COURSE_WASM_ANSWER} -w -MD -MF ${object}.d -c ${file}
    DEPENDS ${compile} ${file} DEPFILE ${object}.d VERBATIM COMMENT "Compiling ${shown} for pages")
endfunction()
