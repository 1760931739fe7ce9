#pragma once
// One file to send to a friend: a demo on the student's functions, in a page that needs nothing else.

#include "site/demos.hpp"

#include <string>

namespace course {

/// The page: a demo as it starts at this place, ours and the student's, both compiled before.
/// The site must be there.
/// @param with_progress  the page has to know which exercises are done: it plays the student's functions of these
std::string shared_page(const Workspace &workspace, const Demo &demo, const DemoMark &mark, bool with_progress);

/// The same with the file that `./course bug` wrote in the place of the student's.
std::string page_with_bug(const Workspace &workspace, const Demo &demo, const DemoMark &mark);

/// A sketch in a page.
/// @param compiled  the elements that bring its script, `playable[name]` and `playable[name + "/mine"]`, and what is done
/// @param shared    it's for a friend of the student's
std::string sketch_page(const Workspace &workspace, const std::string &name, const std::string &compiled, bool shared);

} // namespace course
