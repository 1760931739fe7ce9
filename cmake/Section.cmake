# section(07_segment_intersection): everything that belongs to one section, from its files.
#
#   chapters/NN_slug   the program, with the reference        debug/NN_slug     tests and exercise in one process
#   mine/NN_slug       the same with the student's file       catalogue/NN_slug.json   the list of its exercises
#   tests/NN_slug      the tests, which ask for a subject     subjects/NN_slug/…       solution, stub, mutants and variants
#   traces/NN_slug/…   what the program has traced            plots/NN_slug_….svg      its figures
#
# section(08_nt_collisions BUILDS_ON 07_segment_intersection): its header may include that of section 07, and all code of
# section 08, a student's too, may call section 07's functions. Those are always our solution, never a student's answers.
# section(13_table_hockey BUILDS_ON 07_segment_intersection PLAYS_YOURS): but in its demo they are the student's, where these
# are done. See Play.cmake.
#
# A handout, the edition without solutions, makes of a section what can be made without them: its tests, its stub and the
# student's program. There the functions of earlier sections are the student's own.

option(COURSE_THOROUGH "Judge mutants, and solutions by all generated cases: neither depends on the compiler, so once is enough. OFF, for sanitizers, runs the tests with the solution in one process, too" ON)
set(COURSE_SECTIONS "" CACHE INTERNAL "")
add_custom_target(programs)
add_custom_target(section-tests)
add_custom_target(checks)   # what `./course test` needs: all of the sections, and every kind of verdict
add_custom_target(thorough) # what its tests with that label need: every mutant and variant, every generated case
add_custom_target(figures)
set(COURSE_HANDOUT FALSE)
if(EXISTS ${PROJECT_SOURCE_DIR}/HANDOUT.md)
  set(COURSE_HANDOUT TRUE)
endif()
add_executable(answers-in-one tests/answers/generate.cpp tools/check/differences.cpp tools/check/scanner.cpp)
target_include_directories(answers-in-one PRIVATE tools)
target_link_libraries(answers-in-one PRIVATE course_flags)

function(need_file file)
  if(NOT EXISTS ${PROJECT_SOURCE_DIR}/${file})
    message(FATAL_ERROR "section(${section}) needs ${file}, which is not there: write it, or correct its name. "
                        "`./course dev new` makes all files of a new section.")
  endif()
endfunction()

function(section section)
  if(NOT section MATCHES "^[0-9][0-9]_[a-z][a-z0-9_]*$")
    message(FATAL_ERROR "section(${section}): a section is named NN_slug, as 07_segment_intersection")
  endif()
  string(SUBSTRING ${section} 0 2 section_number)
  string(SUBSTRING ${section} 3 -1 slug)
  set(chapter ${PROJECT_SOURCE_DIR}/chapters/${section})
  foreach(file chapters/${section}/README.md chapters/${section}/${slug}.hpp chapters/${section}/main.cpp tests/${section}/tests.cpp
               tests/${section}/stub.cpp)
    need_file(${file})
  endforeach()
  set(solution ${PROJECT_SOURCE_DIR}/solutions/${section}.cpp)
  set(solved TRUE)
  if(COURSE_HANDOUT AND NOT EXISTS ${solution})
    set(solved FALSE)
  else()
    need_file(solutions/${section}.cpp)
  endif()
  find_earlier_sections(${ARGN})
  set(COURSE_SECTIONS ${COURSE_SECTIONS} ${section} CACHE INTERNAL "")

  section_programs()
  section_tests()
  section_figures()
  section_demo()
endfunction()

# What this section builds on, and what those sections build on themselves:
# `earlier` are their names, `earlier_objects` the objects of their solutions, or of the student's files; and
# `earlier_stand_ins` the same whatever a student has written.
macro(find_earlier_sections)
  cmake_parse_arguments(section PLAYS_YOURS "" BUILDS_ON ${ARGN})
  if(section_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "section(${section}): after the name comes nothing, or BUILDS_ON and earlier sections, then PLAYS_YOURS or nothing, but not ${section_UNPARSED_ARGUMENTS}")
  endif()
  set(earlier)
  foreach(one ${section_BUILDS_ON})
    if(NOT one STRLESS section)
      message(FATAL_ERROR "section(${section} BUILDS_ON ${one}): a section can only build on one with a smaller number")
    elseif(NOT one IN_LIST COURSE_SECTIONS)
      message(FATAL_ERROR "section(${section} BUILDS_ON ${one}): no section(${one}) stands above this line in CMakeLists.txt")
    endif()
    list(APPEND earlier ${COURSE_${one}_BUILDS_ON} ${one})
  endforeach()
  list(REMOVE_DUPLICATES earlier)
  set(COURSE_${section}_BUILDS_ON ${earlier} CACHE INTERNAL "")
  set(COURSE_${section}_PLAYS_YOURS ${section_PLAYS_YOURS} CACHE INTERNAL "")
  set(earlier_objects)
  set(earlier_stand_ins)
  foreach(one ${earlier})
    list(APPEND earlier_objects ${COURSE_${one}_OBJECTS})
    list(APPEND earlier_stand_ins ${COURSE_${one}_STAND_INS})
  endforeach()
endmacro()

macro(section_programs)
  add_library(${section}_stub OBJECT tests/${section}/stub.cpp)
  stand_behind_student_header(${section}_stub course_student_flags)
  add_library(${section}_main OBJECT ${chapter}/main.cpp) # of the program, whoever's functions it calls
  stand_behind_student_header(${section}_main course_flags)
  if(solved)
    section_reference()
  else()
    section_yours()
  endif()

  # The student's file is in no default target: whatever is in it, the course builds.
  if(EXISTS ${PROJECT_SOURCE_DIR}/exercises/${section}.cpp)
    add_executable(${section}_mine EXCLUDE_FROM_ALL $<TARGET_OBJECTS:${section}_main> exercises/${section}.cpp ${earlier_objects})
    target_link_libraries(${section}_mine PRIVATE course_student_flags)
    target_include_directories(${section}_mine PRIVATE ${chapter})
    set_target_properties(${section}_mine PROPERTIES OUTPUT_NAME ${section} RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/mine)
  else()
    math(EXPR number "1${section_number} - 100")
    message(WARNING "exercises/${section}.cpp is not there; `./course reset ${number}` brings the empty one back.")
  endif()
endmacro()

# Our functions, and the programs that call them.
macro(section_reference)
  add_library(${section}_reference OBJECT ${solution})
  target_compile_options(${section}_reference PRIVATE -ffunction-sections) # a subject gets those that it lacks, no other
  stand_behind_student_header(${section}_reference course_flags)
  set(COURSE_${section}_OBJECTS $<TARGET_OBJECTS:${section}_reference> CACHE INTERNAL "")
  set(COURSE_${section}_STAND_INS ${COURSE_${section}_OBJECTS} CACHE INTERNAL "")

  add_executable(${section} $<TARGET_OBJECTS:${section}_main> $<TARGET_OBJECTS:${section}_reference> ${earlier_objects})
  set_target_properties(${section} PROPERTIES LINKER_LANGUAGE CXX RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/chapters)
  add_dependencies(programs ${section})

  # What measures is built on demand, by `course dev bench`, and optimized as a game would be.
  if(EXISTS ${chapter}/bench.cpp)
    add_executable(${section}_bench EXCLUDE_FROM_ALL ${chapter}/bench.cpp ${solution} ${earlier_objects})
    target_link_libraries(${section}_bench PRIVATE Eigen3::Eigen)
    target_include_directories(${section}_bench PRIVATE ${chapter})
    target_compile_options(${section}_bench PRIVATE -O2 ${COURSE_WARNINGS})
    add_custom_target(${section}_measure USES_TERMINAL VERBATIM COMMENT "Measuring"
      COMMAND ${CMAKE_COMMAND} -E make_directory ${PROJECT_BINARY_DIR}/bench
      COMMAND ${section}_bench --out ${PROJECT_BINARY_DIR}/bench)
  endif()
endmacro()

# Without a solution, what later sections build on is the student's file; a function that it lacks isn't started.
macro(section_yours)
  set(yours ${PROJECT_BINARY_DIR}/loop/${section}_yours.o)
  set(not_started ${PROJECT_BINARY_DIR}/loop/${section}_not_started.o)
  set(COURSE_${section}_OBJECTS ${yours} ${not_started} CACHE INTERNAL "")
  set(COURSE_${section}_STAND_INS ${not_started} CACHE INTERNAL "")
  set(earlier_header ${PROJECT_SOURCE_DIR}/tools/judge/server/earlier.hpp)
  add_library(${section}_not_started OBJECT tests/${section}/stub.cpp)
  stand_behind_student_header(${section}_not_started course_student_flags)
  target_compile_options(${section}_not_started PRIVATE -w "-DCOURSE_EARLIER=\"${slug}\"" "SHELL:-include judge/server/earlier.hpp")
  target_include_directories(${section}_not_started PRIVATE tools)
  expect_others_to_return(${section}_not_started)
  add_weak_object(${not_started} ${section}_not_started)
  file(GLOB written CONFIGURE_DEPENDS exercises/${section}.cpp)
  set(compile ${PROJECT_SOURCE_DIR}/cmake/compile_yours.sh)
  string(LENGTH ${slug} length)
  add_custom_command(OUTPUT ${yours}
    COMMAND sh ${compile} ${yours} ${not_started} ${length}${slug} ${CMAKE_NM} ${CMAKE_OBJCOPY}
      ${CMAKE_CXX_COMPILER} ${COURSE_LOOP} ${COURSE_LOOP_PCH} "-DCOURSE_EARLIER=\"${slug}\"" -include ${earlier_header} -w -I${chapter}
      -MD -MF ${yours}.d -c ${written}
    DEPENDS ${compile} ${not_started} ${written} ${compiled} DEPFILE ${yours}.d VERBATIM
    COMMENT "Compiling exercises/${section}.cpp for later sections")
endmacro()

macro(section_tests)
  add_library(${section}_cases OBJECT tests/${section}/tests.cpp)
  target_include_directories(${section}_cases PRIVATE tests ${chapter})
  target_link_libraries(${section}_cases PRIVATE course_harness)
  set_target_properties(${section}_cases PROPERTIES COURSE_OPTIMIZE ${COURSE_OPTIMIZE_TESTS})
  target_precompile_headers(${section}_cases REUSE_FROM course_harness)
  add_tests(${section}_tests tests main)
  set(catalogue ${PROJECT_BINARY_DIR}/catalogue/${section}.json)
  add_custom_command(OUTPUT ${catalogue}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${PROJECT_BINARY_DIR}/catalogue
    COMMAND ${section}_tests --catalogue > ${catalogue} DEPENDS ${section}_tests VERBATIM COMMENT "")

  add_library(${section}_server OBJECT tools/judge/server/server.cpp)
  stand_behind_student_header(${section}_server course_flags)
  target_include_directories(${section}_server PRIVATE tools)
  target_compile_definitions(${section}_server PRIVATE COURSE_SECTION="${slug}.hpp")

  add_library(${section}_missing OBJECT tests/${section}/stub.cpp)
  stand_behind_student_header(${section}_missing course_flags)
  target_include_directories(${section}_missing PRIVATE tools)
  target_compile_options(${section}_missing PRIVATE -w -DCOURSE_STUB_BEHIND "SHELL:-include judge/server/missing.hpp")
  set(missing ${PROJECT_BINARY_DIR}/loop/${section}_missing.o)
  expect_others_to_return(${section}_missing)
  add_weak_object(${missing} ${section}_missing)
  set(our_object) # our functions, where a student's file has none
  if(solved)
    set(our_object ${PROJECT_BINARY_DIR}/loop/${section}_ours.o)
    add_weak_object(${our_object} ${section}_reference)
  endif()

  add_custom_target(${section}_loop ALL DEPENDS ${missing} ${our_object} ${catalogue} ${section}_tests ${section}_server ${earlier_objects} course_pch)
  add_dependencies(section-tests ${section}_loop)
  set(json "{}")
  put_into_json(json name ${section})
  put_into_json(json server $<TARGET_OBJECTS:${section}_server>)
  put_into_json(json missing ${missing})
  put_into_json(json ours "${our_object}")
  put_list_into_json(json earlier ${earlier_objects})
  string(TOLOWER "${section_PLAYS_YOURS}" plays_yours) # true or false
  string(JSON json SET "${json}" plays_yours ${plays_yours})
  set_property(GLOBAL PROPERTY course_json_${section} "${json}")

  add_subject(stub --stub $<TARGET_OBJECTS:${section}_stub>)
  add_dependencies(checks ${section}_loop ${section}_subject_stub)
  add_custom_target(${section}_checks DEPENDS ${section}_loop ${section}_subject_stub)
  add_dependencies(thorough ${section}_checks)
  if(solved)
    section_answers()
  endif()

  # The student's file and the tests in one process, compiled for a debugger.
  if(EXISTS ${PROJECT_SOURCE_DIR}/exercises/${section}.cpp)
    add_executable(${section}_debug EXCLUDE_FROM_ALL exercises/${section}.cpp tests/${section}/tests.cpp)
    target_compile_options(${section}_debug PRIVATE -g)
    set_target_properties(${section}_debug PROPERTIES COURSE_OPTIMIZE -O0)
    in_one_process(debug)
  endif()
endmacro()

# A program of the section's tests, in a folder; what it does with them is in judge/runner/MAIN.cpp.
macro(add_tests program folder main)
  add_executable(${program} ${ARGN} $<TARGET_OBJECTS:${section}_cases> $<TARGET_OBJECTS:course_${main}> $<TARGET_OBJECTS:course_harness> ${earlier_objects})
  target_link_libraries(${program} PRIVATE course_harness)
  set_target_properties(${program} PROPERTIES OUTPUT_NAME ${section} RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/${folder})
endmacro()

# Whether our answers are judged as they should be: the solution, its mutants and variants.
macro(section_answers)
  add_subject(solution "" $<TARGET_OBJECTS:${section}_reference>)
  add_dependencies(checks ${section}_subject_solution)
  add_tests(${section}_author author author EXCLUDE_FROM_ALL)
  section_mutants_and_variants()
  add_dependencies(${section}_author ${section}_answers) # which it's run on
  add_dependencies(${section}_checks ${section}_subject_solution ${section}_author)
  if(COURSE_THOROUGH)
    add_test(NAME ${section}.all_cases COMMAND ${section}_author $<TARGET_FILE:${section}_subject_solution> --all-cases)
    set_tests_properties(${section}.all_cases ${section}.answers PROPERTIES LABELS thorough)
  else() # everything in one process, for sanitizers
    add_executable(${section}_direct $<TARGET_OBJECTS:${section}_reference> $<TARGET_OBJECTS:${section}_cases>)
    in_one_process(direct)
    add_dependencies(${section}_checks ${section}_direct)
    add_test(NAME ${section}.direct COMMAND ${section}_direct)
  endif()
endmacro()

macro(in_one_process whose)
  target_sources(${section}_${whose} PRIVATE tools/judge/runner/direct.cpp ${earlier_objects})
  target_link_libraries(${section}_${whose} PRIVATE course_student_flags Catch2::Catch2WithMain)
  target_include_directories(${section}_${whose} PRIVATE tests tools ${chapter})
  target_compile_definitions(${section}_${whose} PRIVATE COURSE_SECTION="${slug}.hpp")
  set_target_properties(${section}_${whose} PROPERTIES OUTPUT_NAME ${section} RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/${whose})
endmacro()

# All mutants and variants in one program, which is told by name which answer it is to be.
macro(section_mutants_and_variants)
  set(kinds variants)
  if(COURSE_THOROUGH)
    list(APPEND kinds mutants)
  endif()
  set(answers)
  foreach(kind ${kinds})
    file(GLOB found CONFIGURE_DEPENDS tests/${section}/${kind}.diff tests/${section}/${kind}/*.cpp)
    list(APPEND answers ${found})
  endforeach()
  set(unit ${PROJECT_BINARY_DIR}/answers/${section})
  add_custom_command(OUTPUT ${unit}.cpp ${unit}.txt ${unit}_claims.txt
    COMMAND answers-in-one ${PROJECT_SOURCE_DIR} ${section} ${unit}.cpp ${unit}.txt ${unit}_claims.txt ${kinds}
    DEPENDS answers-in-one ${answers} ${solution} ${chapter}/${slug}.hpp VERBATIM COMMENT "")
  add_executable(${section}_answers ${unit}.cpp $<TARGET_OBJECTS:${section}_reference> ${earlier_objects})
  stand_behind_student_header(${section}_answers course_student_flags)
  target_include_directories(${section}_answers PRIVATE tests/answers tools)
  target_compile_definitions(${section}_answers PRIVATE COURSE_SECTION="${slug}.hpp")
  target_compile_options(${section}_answers PRIVATE -w) # they are as their authors left them
  set_target_properties(${section}_answers PROPERTIES OUTPUT_NAME answers RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/subjects/${section})
  add_test(NAME ${section}.answers COMMAND ${section}_author $<TARGET_FILE:${section}_answers> --answers ${unit}.txt)
  set_tests_properties(${section}.answers PROPERTIES PROCESSORS 2)
  section_own_tests()
  if(COURSE_THOROUGH) # what `check` knows mistakes by is what comes out of them
    add_test(NAME ${section}.mistakes COMMAND ${section}_author $<TARGET_FILE:${section}_answers>
      --mistakes ${unit}_claims.txt ${PROJECT_SOURCE_DIR}/tests/${section}/mistakes.tsv)
    add_test(NAME ${section}.bugs COMMAND ${NODE} ${PROJECT_SOURCE_DIR}/tests/bugs.mjs ${PROJECT_SOURCE_DIR}
      $<TARGET_FILE:${section}_author> $<TARGET_FILE:${section}_answers> ${unit}.txt ${catalogue})
    set_tests_properties(${section}.mistakes ${section}.bugs PROPERTIES PROCESSORS 2 LABELS thorough)
  endif()
endmacro()

# A reader's own tests, of a copy that `course mytests` makes of them, and the answers that they run against: on demand.
macro(section_own_tests)
  set(own ${PROJECT_BINARY_DIR}/own/${section})
  if(NOT EXISTS ${own}.cpp)
    file(WRITE ${own}.cpp "")
  endif()
  add_executable(${section}_own_tests EXCLUDE_FROM_ALL ${own}.cpp $<TARGET_OBJECTS:course_own> $<TARGET_OBJECTS:course_harness> ${earlier_objects})
  target_include_directories(${section}_own_tests PRIVATE tests ${chapter})
  target_link_libraries(${section}_own_tests PRIVATE course_harness)
  target_precompile_headers(${section}_own_tests REUSE_FROM course_harness)
  target_link_options(${section}_own_tests PRIVATE ${COURSE_LOOP_LINK})
  set_target_properties(${section}_own_tests PROPERTIES OUTPUT_NAME ${section} RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/own
    COURSE_OPTIMIZE ${COURSE_OPTIMIZE_TESTS} COMPILE_WARNING_AS_ERROR OFF)
  add_custom_target(${section}_own DEPENDS ${section}_own_tests ${section}_answers)
endmacro()

# A program that serves the functions of one file, and the test that its verdicts are as expected.
macro(add_subject name option)
  add_executable(${section}_subject_${name} $<TARGET_OBJECTS:${section}_server> ${earlier_stand_ins} ${ARGN})
  set_target_properties(${section}_subject_${name} PROPERTIES LINKER_LANGUAGE CXX OUTPUT_NAME ${name}
    RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/subjects/${section})
  target_link_options(${section}_subject_${name} PRIVATE ${COURSE_LOOP_LINK})
  add_test(NAME ${section}.${name} COMMAND ${section}_tests $<TARGET_FILE:${section}_subject_${name}> ${option})
endmacro()

macro(section_figures)
  file(GLOB scripts CONFIGURE_DEPENDS plots/${section}_*.gp)
  if(NOT scripts)
    message(FATAL_ERROR "section(${section}) has no figure: write plots/${section}_<figure>.gp")
  endif()
  # chapter, contract and program; game.hpp, renamed.txt and a peer, if there are any
  file(GLOB beside CONFIGURE_DEPENDS ${chapter}/* tests/${section}/peer.*)
  set_property(GLOBAL APPEND PROPERTY course_book ${beside} ${scripts} ${PROJECT_SOURCE_DIR}/tests/${section}/tests.cpp)
  if(solved)
    section_drawings()
  endif()
endmacro()

# Drawn from what our program traces.
macro(section_drawings)
  set(traces ${PROJECT_BINARY_DIR}/traces/${section})
  set(traced ${traces}.txt) # what the program printed: made whenever it has run
  add_custom_command(OUTPUT ${traced}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${traces}
    COMMAND ${section} --out ${traces} > ${traced}
    DEPENDS ${section} VERBATIM COMMENT "Running ${section}")
  foreach(script ${scripts})
    cmake_path(GET script STEM figure)
    set(drawn ${PROJECT_BINARY_DIR}/plots/${figure}.svg)
    set(trace ${traces}/${figure}.tsv)
    set(made_by ${traced})
    if(figure MATCHES "^${section}_measured_") # never the same twice: the trace is kept, and no program writes it
      need_file(plots/${figure}.tsv)
      set(trace ${PROJECT_SOURCE_DIR}/plots/${figure}.tsv)
      set(made_by ${trace})
    endif()
    add_custom_command(OUTPUT ${drawn}
      COMMAND course-tool draw --script ${script} --trace ${trace} --out ${drawn}
      DEPENDS ${script} ${PROJECT_SOURCE_DIR}/plots/style.gp ${made_by} course-tool VERBATIM COMMENT "Drawing ${figure}")
    list(APPEND drawings ${drawn})
  endforeach()
  add_custom_target(${section}_figures ALL DEPENDS ${drawings})
  add_dependencies(figures ${section}_figures)
  set_property(GLOBAL APPEND PROPERTY course_book ${traced} ${solution})
endmacro()

# TEXT as a string of JSON.
function(quote_for_json result text)
  string(REPLACE "\\" "\\\\" text "${text}")
  string(REPLACE "\"" "\\\"" text "${text}")
  set(${result} "\"${text}\"" PARENT_SCOPE)
endfunction()

# Sets a member of the JSON in the variable OBJECT to a text, or to an array of texts.
function(put_into_json object member text)
  quote_for_json(text "${text}")
  string(JSON json SET "${${object}}" ${member} "${text}")
  set(${object} "${json}" PARENT_SCOPE)
endfunction()
function(put_list_into_json object member)
  string(JSON json SET "${${object}}" ${member} "[]")
  set(index 0)
  foreach(text ${ARGN})
    quote_for_json(text "${text}")
    string(JSON json SET "${json}" ${member} ${index} "${text}")
    math(EXPR index "${index} + 1")
  endforeach()
  set(${object} "${json}" PARENT_SCOPE)
endfunction()

# After the last section: what concerns all of them.
function(finish_course)
  # not exercises: it is the student's, who may keep an older answer there
  file(GLOB files CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} solutions/*.cpp tests/[0-9]*)
  foreach(file ${files})
    cmake_path(GET file STEM stem)
    if(NOT stem IN_LIST COURSE_SECTIONS)
      message(FATAL_ERROR "${file} belongs to no section: correct its name, or add section(${stem}) to CMakeLists.txt")
    endif()
  endforeach()

  set(json "{\"sections\": []}")
  put_into_json(json compiler ${CMAKE_CXX_COMPILER})
  put_into_json(json nm ${CMAKE_NM})
  put_into_json(json objcopy ${CMAKE_OBJCOPY})
  put_into_json(json node ${NODE})
  put_list_into_json(json flags ${COURSE_LOOP})
  put_list_into_json(json precompiled ${COURSE_LOOP_PCH})
  if(COURSE_QUICK_LINK)
    set(quick "{}")
    put_into_json(quick compiler ${COURSE_QUICK_COMPILER})
    put_list_into_json(quick flags ${COURSE_QUICK_LOOP})
    put_list_into_json(quick precompiled ${COURSE_QUICK_PCH})
    put_list_into_json(quick link ${COURSE_QUICK_LINK})
    string(JSON json SET "${json}" quick "${quick}")
  endif()
  put_list_into_json(json includes ${COURSE_INCLUDES})
  put_list_into_json(json link ${extra} ${COURSE_LOOP_LINK}) # a sanitizer's flags are the linker's, too
  set(number 0)
  foreach(section ${COURSE_SECTIONS})
    get_property(section_json GLOBAL PROPERTY course_json_${section})
    string(JSON json SET "${json}" sections ${number} "${section_json}")
    math(EXPR number "${number} + 1")
  endforeach()
  file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/course.json CONTENT "${json}\n")

  if(COURSE_HANDOUT) # its chapters are without solutions, and nobody changes them
    add_custom_target(book)
    return()
  endif()
  get_property(book GLOBAL PROPERTY course_book)
  add_custom_command(OUTPUT ${PROJECT_BINARY_DIR}/book.stamp
    COMMAND course-tool dev weave --check
    COMMAND ${CMAKE_COMMAND} -E touch ${PROJECT_BINARY_DIR}/book.stamp
    DEPENDS course-tool programs figures ${book} ${PROJECT_SOURCE_DIR}/book.md ${PROJECT_SOURCE_DIR}/errata.md ${PROJECT_SOURCE_DIR}/README.md
      ${PROJECT_SOURCE_DIR}/docs/voice.cjs VERBATIM
    COMMENT "Checking that the book says what the code says")
  add_custom_target(book ALL DEPENDS ${PROJECT_BINARY_DIR}/book.stamp)
endfunction()
