#pragma once
// Demos: where a chapter asks for one, and how a page has it.

#include "base/workspace.hpp"
#include "book/demo_places.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace course {

/// A demo, as the chapter has it.
struct Demo {
    Section section;
    DemoMark mark;                   ///< the first place of the scene that the chapter is shown by
    std::vector<std::string> starts; ///< see demo_starts
    std::string about;               ///< what it shows, as the title of the picture says; "" if there is no picture
};

/// A sketch of docs/gallery, which is shown beside the demos.
struct GallerySketch {
    std::string name;           ///< of its file: "nails"
    std::filesystem::path file; ///< its code
    std::string demo;           ///< what it's called among the demos: "sketch_nails"
    std::string script() const { return "demos/" + demo + ".js"; }
    std::string picture() const { return "demos/" + demo + ".svg"; }
};
/// All of them, by name; and those that are published.
std::vector<GallerySketch> gallery(const Workspace &workspace);
std::vector<GallerySketch> published_gallery(const Workspace &workspace);
/// Whether something among the demos is one of them: it's on our functions alone.
inline bool is_of_gallery(std::string_view demo) { return demo.starts_with("sketch_"); }
std::string sketch_figure(const Workspace &workspace, const GallerySketch &sketch);

/// The demos of all chapters, in order, where demos/ has them.
std::vector<Demo> demos(const Workspace &workspace);

/// The file in which a section's demo is kept, and is read by the site's pages: "demos/07_segment_intersection.js".
std::string demo_file(const Section &section);

/// The picture of the demo as it begins at this place, or else the first.
std::string demo_picture_file(const Demo &demo, const DemoMark &mark);

/// The address of a demo's place within a page, after so many others: "demo-room", "demo-room-2".
std::string demo_id(const DemoMark &mark, std::size_t others_before);

/// The demo's place in a page.
/// @param task  as HTML
std::string demo_figure(const Demo &demo, const std::string &id, const DemoMark &mark, const std::string &task);

} // namespace course
