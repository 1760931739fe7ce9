# One set of flags for programs, solutions, tests, and what a student writes: the same code gives the same digits
# and the same complaints everywhere. Each flag has its reason.
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)

if(DEFINED ENV{CI})
  set(CMAKE_COMPILE_WARNING_AS_ERROR ON)
endif()
set(COURSE_WARNINGS
    -Wall -Wextra
    -Wconversion # 0.5 in an int is a classic slip of a beginner;
    -Wno-sign-conversion # an int as an index is none, but for Clang part of it
    -Wshadow)    # as is a second variable of the same name
set(COURSE_OPTIMIZATION -O1 CACHE STRING "For programs and answers; other targets say their own in the property COURSE_OPTIMIZE")
set(of_target $<TARGET_PROPERTY:COURSE_OPTIMIZE>)
set(COURSE_CODE_FLAGS
    -ffp-contract=off    # a * b + c is rounded twice on every machine
    -ftrivial-auto-var-init=pattern # an uninitialized number has a strange value, never the right one by luck
    -Werror=return-type) # a forgotten return is undefined behaviour: never let it run
set(COURSE_DEFINITIONS
    EIGEN_INITIALIZE_MATRICES_BY_NAN # so has an uninitialized vector
    _GLIBCXX_ASSERTIONS)             # v[7] beyond the end is an assertion, not luck

# Ours, and a student's: who has not begun has not used a parameter either. (For Clang the order of the two matters.)
foreach(flags course_flags course_student_flags)
  add_library(${flags} INTERFACE)
  target_compile_options(${flags} INTERFACE $<IF:$<STREQUAL:${of_target},>,${COURSE_OPTIMIZATION},${of_target}> ${COURSE_CODE_FLAGS} ${COURSE_WARNINGS})
  target_compile_definitions(${flags} INTERFACE ${COURSE_DEFINITIONS})
  target_include_directories(${flags} INTERFACE ${PROJECT_SOURCE_DIR}/chapters)
  target_link_libraries(${flags} INTERFACE Eigen3::Eigen)
endforeach()
set(gone local-addr) # a reference to what's gone when the function ends is undefined behaviour, too
if(CMAKE_CXX_COMPILER_ID MATCHES Clang)
  set(gone stack-address)
endif()
set(COURSE_STUDENT_WARNINGS -Wno-unused-parameter -Werror=return-${gone})
target_compile_options(course_student_flags INTERFACE ${COURSE_STUDENT_WARNINGS})
