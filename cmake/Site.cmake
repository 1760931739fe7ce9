# The book as a site: $BUILD/site/index.html. Included after the last section.
get_property(pages GLOBAL PROPERTY course_book)
list(FILTER pages EXCLUDE REGEX "/traces/") # the chapters show what programs print
file(GLOB more LIST_DIRECTORIES false CONFIGURE_DEPENDS *.md chapters/*.hpp chapters/*/*.[ch]pp plots/*.svg docs/* docs/fonts/* demos/*)
add_custom_command(OUTPUT ${PROJECT_BINARY_DIR}/site.stamp
  COMMAND course-tool make-site --doxygen ${DOXYGEN} --node ${NODE} --katex ${KATEX} --lunr ${LUNR}
  COMMAND ${CMAKE_COMMAND} -E touch ${PROJECT_BINARY_DIR}/site.stamp
  DEPENDS course-tool ${pages} ${more} ${PROJECT_SOURCE_DIR}/CMakeLists.txt ${PROJECT_SOURCE_DIR}/plots/style.gp
    ${PROJECT_SOURCE_DIR}/tests/section_test.hpp
  VERBATIM COMMENT "Making the site")
add_custom_target(site ALL DEPENDS ${PROJECT_BINARY_DIR}/site.stamp)
