# What a verdict needs: see tools/judge. `COURSE_LOOP` is how a student's file is compiled, by `course check` and here.
include(CheckCXXSourceCompiles)

add_library(course_verdict STATIC
  ${PROJECT_SOURCE_DIR}/tools/judge/runner/job_queue.cpp
  ${PROJECT_SOURCE_DIR}/tools/judge/runner/session.cpp
  ${PROJECT_SOURCE_DIR}/tools/judge/runner/sandbox.cpp
  ${PROJECT_SOURCE_DIR}/tools/judge/runner/student_process.cpp
  ${PROJECT_SOURCE_DIR}/tools/judge/protocol/signature.cpp
  ${PROJECT_SOURCE_DIR}/tools/judge/protocol/verdict.cpp)
target_include_directories(course_verdict PUBLIC ${PROJECT_SOURCE_DIR}/tools)
target_link_libraries(course_verdict PUBLIC course_flags nlohmann_json::nlohmann_json)
set_target_properties(course_verdict PROPERTIES UNITY_BUILD ON)

add_library(course_harness OBJECT ${PROJECT_SOURCE_DIR}/tools/judge/runner/harness.cpp) # of all section tests
target_link_libraries(course_harness PUBLIC course_verdict Catch2::Catch2)
target_include_directories(course_harness PRIVATE ${PROJECT_SOURCE_DIR}/tests)
target_compile_options(course_harness PUBLIC -fmacro-prefix-map=${PROJECT_SOURCE_DIR}/=) # verdicts say tests/NN_slug/tests.cpp
if(CMAKE_CXX_COMPILER_ID MATCHES Clang) # 14 crashes in templates that it reads back
  set(CMAKE_DISABLE_PRECOMPILE_HEADERS ON)
endif()
target_compile_options(course_harness PUBLIC "$<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds;-Wno-stringop-overflow>") # GCC 12's own mistake about std::string, seen once its headers are precompiled
set(COURSE_OPTIMIZE_TESTS -Og CACHE STRING "For tests: compiled in three quarters of the time of -O1, and a check is as quick; at -O0 it is not")
set_target_properties(course_harness PROPERTIES COURSE_OPTIMIZE ${COURSE_OPTIMIZE_TESTS})
target_precompile_headers(course_harness PRIVATE ${PROJECT_SOURCE_DIR}/tests/matchers.hpp) # and all section tests
foreach(main main author own) # what runs them: a student's check, an author, or `mytests`
  add_library(course_${main} OBJECT EXCLUDE_FROM_ALL ${PROJECT_SOURCE_DIR}/tools/judge/runner/${main}.cpp)
  target_link_libraries(course_${main} PRIVATE course_verdict Catch2::Catch2)
  set_target_properties(course_${main} PROPERTIES COURSE_OPTIMIZE ${COURSE_OPTIMIZE_TESTS})
endforeach()

# gold links in a third of the default linker's time, and comes with it.
set(CMAKE_REQUIRED_LINK_OPTIONS -fuse-ld=gold)
check_cxx_source_compiles("int main() {}" COURSE_HAS_GOLD)
unset(CMAKE_REQUIRED_LINK_OPTIONS)
set(COURSE_LOOP_LINK)
if(COURSE_HAS_GOLD AND NOT CMAKE_CXX_FLAGS MATCHES "sanitize") # which gold warns of
  set(COURSE_LOOP_LINK -fuse-ld=gold)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  list(APPEND COURSE_LOOP_LINK -fno-use-linker-plugin) # for whole programs, which takes a moment to load
endif()

# The precompiled header that is included before every student's file.
separate_arguments(extra NATIVE_COMMAND "${CMAKE_CXX_FLAGS}")
get_target_property(eigen Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
set(COURSE_LOOP ${extra} -std=c++20 ${COURSE_OPTIMIZATION} ${COURSE_CODE_FLAGS} ${COURSE_WARNINGS} ${COURSE_STUDENT_WARNINGS})
list(TRANSFORM COURSE_DEFINITIONS PREPEND -D OUTPUT_VARIABLE definitions)
list(APPEND COURSE_LOOP ${definitions} -I${PROJECT_SOURCE_DIR}/chapters -isystem ${eigen})
set(COURSE_PCH ${PROJECT_BINARY_DIR}/loop/student.hpp)
if(CMAKE_CXX_COMPILER_ID MATCHES Clang)
  list(APPEND COURSE_LOOP -ferror-limit=20)
  set(compiled ${COURSE_PCH}.pch)
  set(COURSE_LOOP_PCH -include-pch ${compiled})
else()
  list(APPEND COURSE_LOOP -fmax-errors=20)
  set(compiled ${COURSE_PCH}.gch)
  set(COURSE_LOOP_PCH -include ${COURSE_PCH})
endif()
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/loop)
foreach(header student.hpp quick.hpp)
  set(original ${PROJECT_SOURCE_DIR}/tools/judge/server/${header})
  file(COPY_FILE ${original} ${PROJECT_BINARY_DIR}/loop/${header} ONLY_IF_DIFFERENT)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${original})
endforeach()
add_custom_command(OUTPUT ${compiled}
  COMMAND ${CMAKE_CXX_COMPILER} ${COURSE_LOOP} -x c++-header ${COURSE_PCH} -o ${compiled} -MD -MF ${compiled}.d
  DEPENDS ${COURSE_PCH}
  DEPFILE ${compiled}.d
  COMMENT "Precompiling the header that stands before every exercise"
  VERBATIM COMMAND_EXPAND_LISTS)
add_custom_target(course_pch DEPENDS ${compiled})

# Clang compiles an answer in half of GCC's time: at -O0, with the templates of quick.hpp made and optimized beforehand.
# So it goes first where it is there. What it does not take without a word is given to GCC: see `judge`.
set(COURSE_QUICK TRUE CACHE BOOL "Let Clang, if it is there, compile answers before GCC")
find_program(COURSE_QUICK_COMPILER NAMES clang++ clang++-14)
set(COURSE_QUICK_LOOP)
if(COURSE_QUICK AND COURSE_QUICK_COMPILER AND CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_SYSTEM_NAME STREQUAL Linux
   AND NOT CMAKE_CXX_FLAGS) # which may be flags that only GCC knows
  set(COURSE_QUICK_LOOP ${COURSE_LOOP} -O0)
  list(REMOVE_ITEM COURSE_QUICK_LOOP ${COURSE_OPTIMIZATION} -fmax-errors=20 -Werror=return-local-addr)
  list(APPEND COURSE_QUICK_LOOP -Wshadow-all -Wconditional-uninitialized -Wimplicit-fallthrough
    -Wtautological-unsigned-zero-compare # in all, what GCC warns of;
    -Werror=dangling-gsl) # and what it doesn't see: `judge` shows it in Clang's words
  set(quick ${PROJECT_BINARY_DIR}/loop/quick)
  set(make_quick ${COURSE_QUICK_COMPILER} ${COURSE_QUICK_LOOP} -x c++-header ${quick}.hpp
    -fpch-instantiate-templates -fpch-codegen)
  if(NOT "${COURSE_QUICK_TRIED}" STREQUAL "${make_quick}")
    execute_process(COMMAND ${make_quick} -fsyntax-only RESULT_VARIABLE quick_fails OUTPUT_QUIET ERROR_QUIET)
    set(COURSE_QUICK_FAILS ${quick_fails} CACHE INTERNAL "")
    set(COURSE_QUICK_TRIED "${make_quick}" CACHE INTERNAL "")
  endif()
endif()
set(COURSE_QUICK_LINK) # empty: the course's own compiler is asked at once
if(COURSE_QUICK_LOOP AND COURSE_QUICK_FAILS EQUAL 0)
  set(COURSE_QUICK_PCH -include-pch ${quick}.pch)
  set(COURSE_QUICK_LINK ${quick}.o -Wl,--gc-sections)
  add_custom_command(OUTPUT ${quick}.pch
    COMMAND ${make_quick} -o ${quick}.pch -MD -MF ${quick}.d
    DEPENDS ${quick}.hpp ${COURSE_QUICK_COMPILER} DEPFILE ${quick}.d VERBATIM
    COMMENT "Precompiling the same for Clang, with the templates that answers use")
  add_custom_command(OUTPUT ${quick}.o
    COMMAND ${COURSE_QUICK_COMPILER} ${COURSE_QUICK_LOOP} -O2 -Wno-unused-command-line-argument -c ${quick}.pch -o ${quick}.o
    DEPENDS ${quick}.pch VERBATIM COMMENT "Compiling these templates")
  add_custom_target(course_quick DEPENDS ${quick}.o)
  add_dependencies(course_pch course_quick)
  list(APPEND COURSE_QUICK_LOOP -Xclang -fno-validate-pch)
endif()

# What a student's file may include: files, or folders with headers.
set(COURSE_INCLUDES ${PROJECT_SOURCE_DIR}/chapters ${COURSE_PCH} ${compiled} ${PROJECT_BINARY_DIR}/loop/quick.hpp ${eigen} ${CMAKE_CXX_IMPLICIT_INCLUDE_DIRECTORIES}
  /usr/include /usr/lib /usr/local/include)

# Puts a section's target behind the header that stands before a student's file, which is read in a tenth of the time
# that Eigen takes; the target has the flags of the library `flags`.
function(stand_behind_student_header target flags)
  add_dependencies(${target} course_pch)
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "\\.cpp$")
  set_property(SOURCE ${sources} PROPERTY OBJECT_DEPENDS ${compiled})
  target_link_libraries(${target} PUBLIC ${flags})
  target_include_directories(${target} PUBLIC ${PROJECT_SOURCE_DIR}/chapters/${section})
  target_compile_options(${target} PRIVATE ${COURSE_LOOP_PCH} -Winvalid-pch) # or GCC reads it all again without a word
endfunction()

# A stub's functions only throw, and are to give way to others: the compiler must not see that they never return.
function(expect_others_to_return library)
  target_compile_options(${library} PRIVATE
    "$<IF:$<CXX_COMPILER_ID:GNU>,SHELL:-fno-ipa-pure-const -fno-inline,SHELL:-Xclang -disable-llvm-passes>")
endfunction()

# The objects of a library with every symbol made weak: a definition elsewhere takes precedence.
function(add_weak_object output library)
  add_custom_command(OUTPUT ${output}
    COMMAND ${CMAKE_OBJCOPY} --weaken $<TARGET_OBJECTS:${library}> ${output}
    DEPENDS $<TARGET_OBJECTS:${library}> COMMAND_EXPAND_LISTS VERBATIM
    COMMENT "")
endfunction()
