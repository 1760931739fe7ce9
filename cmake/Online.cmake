# The edition of the site in which one writes C++ in the page: target `online`, folder $BUILD/online/site. `./course site --online`
# makes it, after npm has put into tools/online/node_modules what its package-lock.json names; nothing else needs that.
#
# Two compilers: what judges, the tests of a section, is compiled by Debian's Clang for WASI, as demos are. What is linked with a
# reader's file is compiled by Clang in WebAssembly, the one that the page has.
set(online ${PROJECT_BINARY_DIR}/online)
set(npm ${PROJECT_SOURCE_DIR}/tools/online/node_modules)
if(NOT COURSE_WASM OR COURSE_HANDOUT)
  return()
endif()
file(MAKE_DIRECTORY ${online}/include)
find_path(COURSE_JSON_INCLUDE nlohmann/json.hpp)
file(CREATE_LINK ${COURSE_JSON_INCLUDE}/nlohmann ${online}/include/nlohmann SYMBOLIC) # nothing else of the system's headers, which aren't for WASI

# judge_object(RESULT source flags...): for a module that runs beside a reader's, with exceptions, and without what tells a demo's
# page of checks that fail.
set(page ${PROJECT_SOURCE_DIR}/tools/judge/page)
function(judge_object object source)
  wasm_object(${object} ${source} -fwasm-exceptions -U_LIBCPP_HARDENING_MODE -D_WASI_EMULATED_SIGNAL -I${page} -include libcxx.hpp
    -I${PROJECT_SOURCE_DIR}/tools -I${PROJECT_SOURCE_DIR}/tests -isystem ${online}/include ${ARGN})
endfunction()

# judge_module(RESULT objects...)
function(judge_module module)
  add_custom_command(OUTPUT ${module}
    COMMAND ${COURSE_WASM_CLANG} --target=wasm32-wasi -mexec-model=reactor -Wl,--stack-first,-z,stack-size=1048576 -Wl,--gc-sections
      -Wl,--strip-debug ${ARGN} -lwasi-emulated-signal -o ${module}
    DEPENDS ${ARGN} VERBATIM COMMENT "")
endfunction()

set(chapter ${PROJECT_SOURCE_DIR}/chapters) # of no section, for now
set(judge)
foreach(source judge/page/exceptions judge/page/harness judge/page/student_instance judge/runner/session judge/protocol/verdict judge/protocol/signature)
  cmake_path(GET source FILENAME name)
  judge_object(${online}/${name}.o ${PROJECT_SOURCE_DIR}/tools/${source}.cpp)
  list(APPEND judge ${online}/${name}.o)
endforeach()

# What says of a check what the terminal prints: target `words-in-page`, words.wasm.
find_path(COURSE_FMT_INCLUDE fmt/format.h)
file(CREATE_LINK ${COURSE_FMT_INCLUDE}/fmt ${online}/include/fmt SYMBOLIC)
set(words ${online}/exceptions.o ${online}/verdict.o ${online}/signature.o)
set(sources judge/page/words base/nearest base/renamed)
foreach(name advice advice_rules answer described diagnosis diagnostic feedback functions help marks mistakes outline picture report scanner)
  list(APPEND sources check/${name})
endforeach()
foreach(source ${sources})
  cmake_path(GET source FILENAME name)
  judge_object(${online}/${name}.o ${PROJECT_SOURCE_DIR}/tools/${source}.cpp -DFMT_HEADER_ONLY -DCOURSE_VERSION="${PROJECT_VERSION}")
  list(APPEND words ${online}/${name}.o)
endforeach()
judge_module(${online}/words.wasm ${words})
add_custom_target(words-in-page DEPENDS ${online}/words.wasm)

# What the page's own compiler makes: see tools/online/make_objects.mjs.
set(objects ${online}/objects)
get_target_property(eigen Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
set(make_objects ${NODE} ${PROJECT_SOURCE_DIR}/tools/online/make_objects.mjs ${eigen} ${objects})
file(GLOB read_by_all CONFIGURE_DEPENDS chapters/course.hpp chapters/interface.hpp tools/judge/server/*.hpp tools/judge/protocol/*.hpp)
list(APPEND read_by_all ${npm}/@yowasp/clang/package.json ${PROJECT_SOURCE_DIR}/tools/online/make_objects.mjs ${PROJECT_SOURCE_DIR}/tools/online/toolchain.mjs)
set(common ${objects}/quick.pch ${objects}/quick.o ${objects}/exceptions.o ${objects}/assertion.o)
add_custom_command(OUTPUT ${common} COMMAND ${make_objects}
  DEPENDS ${read_by_all} ${page}/exceptions.cpp ${page}/assertion.cpp ${page}/libcxx/__assertion_handler VERBATIM COMMENT "Precompiling what answers in pages begin with")

set(parts ${common})
set(sections) # each with those that it builds on
foreach(section ${COURSE_SECTIONS})
  string(SUBSTRING ${section} 3 -1 slug)
  set(chapter ${PROJECT_SOURCE_DIR}/chapters/${section})
  judge_object(${online}/${section}_tests.o ${PROJECT_SOURCE_DIR}/tests/${section}/tests.cpp)
  judge_object(${online}/${section}_ours.o ${PROJECT_SOURCE_DIR}/solutions/${section}.cpp)
  set(earlier ${COURSE_${section}_BUILDS_ON})
  list(TRANSFORM earlier REPLACE "(.+)" "${online}/\\1_ours.o" OUTPUT_VARIABLE called) # by the tests
  judge_module(${online}/${section}.wasm ${online}/${section}_tests.o ${called} ${judge})
  set(made ${objects}/${section}_server.o ${objects}/${section}_ours.o ${objects}/${section}_missing.o)
  set(headers ${chapter}/${slug}.hpp)
  foreach(one ${earlier})
    string(SUBSTRING ${one} 3 -1 other)
    list(APPEND headers ${PROJECT_SOURCE_DIR}/chapters/${one}/${other}.hpp)
  endforeach()
  set(asked)
  if(COURSE_${section}_PLAYS_YOURS)
    set(asked ${earlier})
    list(TRANSFORM earlier REPLACE "(.+)" "${objects}/${section}_asks_\\1.o" OUTPUT_VARIABLE asking)
    list(TRANSFORM earlier REPLACE "(.+)" "${PROJECT_SOURCE_DIR}/solutions/\\1.cpp" OUTPUT_VARIABLE theirs)
    list(APPEND made ${objects}/${section}_asks.o ${asking})
    list(APPEND headers ${theirs} ${host}/asks.cpp ${host}/calls.hpp ${host}/answers.hpp)
  endif()
  add_custom_command(OUTPUT ${made} COMMAND ${make_objects} ${section} ${asked}
    DEPENDS ${common} ${headers} ${PROJECT_SOURCE_DIR}/solutions/${section}.cpp ${PROJECT_SOURCE_DIR}/tests/${section}/stub.cpp ${page}/server.cpp
    VERBATIM COMMENT "Compiling what answers of ${section} are linked with in pages")
  list(APPEND parts ${online}/${section}.wasm ${made} ${PROJECT_BINARY_DIR}/catalogue/${section}.json)
  list(JOIN earlier , earlier)
  list(APPEND sections ${section}=${earlier})
endforeach()

# What a sketch in a page is linked with; our functions as modules that it asks; and the book's scenes, to begin with.
file(GLOB hosts CONFIGURE_DEPENDS tools/play/host/*.[ch]pp chapters/*.hpp chapters/*/*.hpp chapters/*/scenes/*.hpp docs/gallery/*.cpp)
add_custom_command(OUTPUT ${objects}/sketch.pch ${objects}/sketch.o ${objects}/sketch_page.o COMMAND ${make_objects} sketches DEPENDS ${common} ${hosts} VERBATIM COMMENT "Compiling what sketches are linked with in pages")
add_custom_command(OUTPUT ${online}/scenes.json COMMAND course-tool make-scenes > ${online}/scenes.json DEPENDS course-tool ${hosts} ${PROJECT_BINARY_DIR}/site.stamp VERBATIM COMMENT "")
list(APPEND parts ${objects}/sketch_page.o ${online}/scenes.json)
set(play ${PROJECT_BINARY_DIR}/play)
file(MAKE_DIRECTORY ${online}/ours)
foreach(section ${COURSE_SECTIONS})
  answer_entry(entry ${section} ${PROJECT_SOURCE_DIR}/solutions/${section}.cpp ${play}/${section}_answers.o)
  pack_answers(${online}/ours/${section}.js ours/${section} ${entry})
  list(APPEND parts ${online}/ours/${section}.js)
endforeach()

add_custom_target(online-parts DEPENDS ${parts})

# All that a page loads, and the site with it.
file(GLOB scripts CONFIGURE_DEPENDS tools/online/*)
list(FILTER scripts EXCLUDE REGEX "node_modules")
set(packs ${online}/packs)
add_custom_command(OUTPUT ${packs}/manifest.json
  COMMAND ${NODE} ${PROJECT_SOURCE_DIR}/tools/online/make_packs.mjs ${eigen} ${online} ${packs} ${sections}
  COMMAND ${NODE} ${PROJECT_SOURCE_DIR}/tools/online/build_editor.mjs ${packs}
  DEPENDS ${parts} ${online}/words.wasm ${scripts} VERBATIM COMMENT "Packing what pages compile and judge with")
add_custom_command(OUTPUT ${online}/site.stamp
  COMMAND ${NODE} ${PROJECT_SOURCE_DIR}/tools/online/make_site.mjs ${PROJECT_BINARY_DIR}/site ${packs} ${online}/site
  COMMAND ${CMAKE_COMMAND} -E touch ${online}/site.stamp
  DEPENDS ${packs}/manifest.json ${PROJECT_BINARY_DIR}/site.stamp VERBATIM COMMENT "Making the site to write in")
add_custom_target(online DEPENDS ${online}/site.stamp)

# And of a handout: `course export handout --online` puts it into this folder. Ours are in the packs, compiled.
set(handout ${online}/handout)
add_custom_target(online-handout
  COMMAND ${CMAKE_COMMAND} -E copy_directory ${PROJECT_BINARY_DIR}/catalogue ${handout}/build/catalogue
  COMMAND ${CMAKE_COMMAND} -E env COURSE_ROOT=${handout} COURSE_BUILD=${handout}/build $<TARGET_FILE:course-tool>
    make-site --doxygen ${DOXYGEN} --node ${NODE} --katex ${KATEX} --lunr ${LUNR}
  COMMAND ${NODE} ${PROJECT_SOURCE_DIR}/tools/online/make_site.mjs ${handout}/build/site ${packs} ${online}/handout_site ${handout}
  DEPENDS ${packs}/manifest.json VERBATIM COMMENT "Making the handout to write in")
add_dependencies(online-handout course-tool)
