#pragma once
// How Canvas, Moodle and instructors name what a student hands in, and what they tell by it.

#include "grade/submissions.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace course {

/// What a platform says by a file's name.
struct UploadName {
    std::string id, name; ///< of whom, or of which group
    std::string who;      ///< all that tells people apart
    std::string own;      ///< what the student calls it
    std::string upload;   ///< Canvas' number of it: the larger, the newer
    std::string feedback;
    enum Kind { file, text, link } kind = file;
    bool late = false;
};

/// `a`, `b`, and an empty word, of "a_b_".
std::vector<std::string> split_at(std::string_view text, char separator);

bool is_anonymous(std::string_view name);

/// Nothing if a platform doesn't name files so.
std::optional<UploadName> named_by(Platform platform, const std::string &name, bool anonymous);
std::optional<Platform> platform_of(const std::string &name, bool anonymous);

} // namespace course
