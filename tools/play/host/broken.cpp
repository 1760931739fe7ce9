// In the place of a reader's file that doesn't compile: it has none of its functions, and says so to the page.
void broken() __asm__(COURSE_BROKEN) __attribute__((export_name(COURSE_BROKEN)));
void broken() {}
