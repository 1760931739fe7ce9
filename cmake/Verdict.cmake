# What a verdict needs: see tools/verdict. `COURSE_LOOP` is how a student's file is compiled, by `course check` and here.
include(CheckCXXSourceCompiles)

add_library(course_verdict STATIC
  ${PROJECT_SOURCE_DIR}/tools/verdict/tests/session.cpp
  ${PROJECT_SOURCE_DIR}/tools/verdict/tests/nameless_file.cpp
  ${PROJECT_SOURCE_DIR}/tools/verdict/tests/shut_in.cpp
  ${PROJECT_SOURCE_DIR}/tools/verdict/tests/subject.cpp
  ${PROJECT_SOURCE_DIR}/tools/verdict/shared/verdict.cpp)
target_include_directories(course_verdict PUBLIC ${PROJECT_SOURCE_DIR}/tools)
target_link_libraries(course_verdict PUBLIC course_flags nlohmann_json::nlohmann_json)

add_library(course_harness OBJECT ${PROJECT_SOURCE_DIR}/tools/verdict/tests/harness.cpp) # the main of all section tests
target_link_libraries(course_harness PUBLIC course_verdict Catch2::Catch2 CLI11::CLI11 course::GMP)

# gold links in a third of the default linker's time, and comes with it.
set(CMAKE_REQUIRED_LINK_OPTIONS -fuse-ld=gold)
check_cxx_source_compiles("int main() {}" COURSE_HAS_GOLD)
unset(CMAKE_REQUIRED_LINK_OPTIONS)
set(COURSE_LOOP_LINK)
if(COURSE_HAS_GOLD AND NOT CMAKE_CXX_FLAGS MATCHES "sanitize") # which gold warns of
  set(COURSE_LOOP_LINK -fuse-ld=gold)
endif()

# The precompiled header that is included before every student's file.
separate_arguments(extra NATIVE_COMMAND "${CMAKE_CXX_FLAGS}")
get_target_property(eigen Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
set(COURSE_LOOP ${extra} -std=c++20 ${COURSE_OPTIMIZATION} ${COURSE_CODE_FLAGS} ${COURSE_WARNINGS} -Wno-unused-parameter)
list(TRANSFORM COURSE_DEFINITIONS PREPEND -D OUTPUT_VARIABLE definitions)
list(APPEND COURSE_LOOP ${definitions} -I${PROJECT_SOURCE_DIR}/chapters -isystem ${eigen})
set(COURSE_PCH ${PROJECT_BINARY_DIR}/loop/student.hpp)
if(CMAKE_CXX_COMPILER_ID MATCHES Clang)
  set(compiled ${COURSE_PCH}.pch)
  set(COURSE_LOOP_PCH -include-pch ${compiled})
else()
  set(compiled ${COURSE_PCH}.gch)
  set(COURSE_LOOP_PCH -include ${COURSE_PCH})
endif()
set(COURSE_LOOP_ASSEMBLER) # before the file where the assembler lists what it reads, as for `.incbin "..."`
if(CMAKE_SYSTEM_NAME STREQUAL Linux)
  set(COURSE_LOOP_ASSEMBLER -Xassembler --MD -Xassembler)
  if(CMAKE_CXX_COMPILER_ID MATCHES Clang) # has an assembler of its own, which lists nothing
    list(PREPEND COURSE_LOOP_ASSEMBLER -fno-integrated-as)
  endif()
endif()
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/loop)
file(COPY_FILE ${PROJECT_SOURCE_DIR}/tools/verdict/student/student.hpp ${COURSE_PCH} ONLY_IF_DIFFERENT)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tools/verdict/student/student.hpp)
add_custom_command(OUTPUT ${compiled}
  COMMAND ${CMAKE_CXX_COMPILER} ${COURSE_LOOP} -x c++-header ${COURSE_PCH} -o ${compiled} -MD -MF ${compiled}.d
  DEPENDS ${COURSE_PCH}
  DEPFILE ${compiled}.d
  COMMENT "Precompiling the header that stands before every exercise"
  VERBATIM COMMAND_EXPAND_LISTS)
add_custom_target(course_pch DEPENDS ${compiled})

# Where the headers are that a student's file may include.
set(COURSE_INCLUDES ${PROJECT_SOURCE_DIR}/chapters ${PROJECT_BINARY_DIR}/loop ${eigen} ${CMAKE_CXX_IMPLICIT_INCLUDE_DIRECTORIES}
  /usr/include /usr/lib /usr/local/include)

# Objects of `sources` as a student's file would be compiled.
function(add_student_objects name)
  add_library(${name} OBJECT ${ARGN})
  add_dependencies(${name} course_pch)
  set_property(SOURCE ${ARGN} APPEND PROPERTY OBJECT_DEPENDS ${compiled})
  target_link_libraries(${name} PRIVATE course_student_flags)
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/chapters/${section})
  target_compile_options(${name} PRIVATE ${COURSE_LOOP_PCH})
endfunction()

# The objects of a library with every symbol made weak: a definition elsewhere takes precedence.
function(add_weak_object output library)
  add_custom_command(OUTPUT ${output}
    COMMAND ${CMAKE_OBJCOPY} --weaken $<TARGET_OBJECTS:${library}> ${output}
    DEPENDS $<TARGET_OBJECTS:${library}> COMMAND_EXPAND_LISTS VERBATIM
    COMMENT "")
endfunction()
