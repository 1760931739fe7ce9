#pragma once
// What the headers declare, and where Doxygen describes it.

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace course {

/// What one namespace declares.
struct Interface {
    struct Name {
        std::string address; ///< "namespacewall.html#a12"
        bool is_function = false;
    };
    std::string page;                  ///< of the namespace, "namespacewall.html"
    std::map<std::string, Name> names; ///< without the namespace: "crossing"
};

/// Reads what Doxygen has written down in its tag file: by namespace, each with functions, types and constants.
/// @throws Complaint if the file cannot be read.
std::map<std::string, Interface> interfaces(const std::filesystem::path &tag_file);

/// A line of code as Doxygen has coloured it, with links to what the namespace declares: the first time that `seen`
/// does not hold it yet. Words in comments and strings stay words, and so do members of the same name.
std::string linked(std::string_view line, const Interface &known, std::map<std::string, int> &seen);

} // namespace course
