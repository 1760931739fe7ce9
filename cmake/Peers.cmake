# Peers: solutions compared with code that others wrote for the same job, in preset `peers`; nothing else needs them.
#
# tests/peers/NN_slug.cpp begins with what it needs, `// needs CGAL CGAL::CGAL libcgal-dev`: a package for find_package,
# its target, and Debian's package. tests/peers/NN_slug.txt keeps the largest differences: see tests/peers/peer.hpp.
option(COURSE_PEERS "Compare solutions with code that others wrote: see tests/peers" OFF)
if(NOT COURSE_PEERS)
  return()
endif()

add_custom_target(peers)
set(CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE TRUE) # our flags are cmake/Flags.cmake's
set(packages)
file(GLOB peers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} tests/peers/*.cpp)
foreach(peer ${peers})
  cmake_path(GET peer STEM section)
  file(STRINGS ${peer} needs LIMIT_COUNT 1)
  if(NOT section IN_LIST COURSE_SECTIONS OR NOT needs MATCHES "^// needs ([^ ]+) ([^ ]+) ([^ ]+)$")
    message(FATAL_ERROR "${peer} must be named as a section is, and begin with `// needs PACKAGE TARGET DEBIAN_PACKAGE`")
  endif()
  set(target ${CMAKE_MATCH_2})
  set(debian ${CMAKE_MATCH_3})
  find_package(${CMAKE_MATCH_1} QUIET)
  if(NOT TARGET ${target})
    list(APPEND packages ${debian})
    continue()
  endif()

  list(TRANSFORM COURSE_${section}_BUILDS_ON REPLACE "(.+)" "$<TARGET_OBJECTS:\\1_reference>" OUTPUT_VARIABLE earlier_objects)
  add_executable(${section}_peer ${peer} $<TARGET_OBJECTS:${section}_reference> ${earlier_objects})
  target_link_libraries(${section}_peer PRIVATE course_flags ${target})
  target_include_directories(${section}_peer PRIVATE ${PROJECT_SOURCE_DIR}/chapters/${section})
  set_target_properties(${section}_peer PROPERTIES OUTPUT_NAME ${section} RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/peers)
  add_dependencies(peers ${section}_peer)
  add_test(NAME ${section}.peer COMMAND ${section}_peer ${PROJECT_SOURCE_DIR}/tests/peers/${section}.txt)
endforeach()
if(packages)
  list(REMOVE_DUPLICATES packages)
  list(JOIN packages " " packages)
  message(FATAL_ERROR "The solutions are compared with libraries that are not here. On Debian and Ubuntu type\n"
                      "    sudo apt install ${packages}\nEverything else of the course works without them.")
endif()
