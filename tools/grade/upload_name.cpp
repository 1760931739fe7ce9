#include "grade/upload_name.hpp"

#include "base/text.hpp"

#include <algorithm>

namespace course {
namespace {

std::string joined(const std::vector<std::string> &parts, std::size_t from, std::size_t to) {
    std::string text;
    for (std::size_t i = from; i < to; ++i) text += (i > from ? "_" : "") + parts[i];
    return text;
}

/// `doejane[_LATE]_1003_88_f.cpp`, or `[LATE_]anon_x7_88_f.cpp`: Canvas too goes by the first two parts that are
/// numbers.
std::optional<UploadName> named_by_canvas(const std::string &name, bool anonymous) {
    if (contains(name, "/")) return {};
    const std::vector<std::string> parts = split_at(name, '_');
    std::size_t id = 0;
    if (anonymous && is_anonymous(name)) id = parts[0] == "anon" ? 1 : 2;
    else
        while (id < parts.size() && !is_all_digits(parts[id])) ++id;
    if (id == 0 || id + 1 >= parts.size()) return {};
    if (!anonymous && is_anonymous(name) && parts[id - 1] != "anon" && parts[id - 1] != "LATE") return {};

    UploadName named;
    named.id = parts[id];
    named.feedback = name;
    named.late = parts[anonymous ? 0 : id - 1] == "LATE";
    named.name = anonymous ? "" : joined(parts, 0, named.late ? id - 1 : id);
    named.who = anonymous ? named.id : named.name + '_' + named.id;
    const std::string rest = joined(parts, id + 1, parts.size());
    if (rest == "text.html" || rest == "link.html") {
        named.own = rest;
        named.upload = "0"; // there's none: any file is newer
        named.kind = rest == "text.html" ? UploadName::text : UploadName::link;
        return named;
    }
    named.upload = parts[id + 1];
    named.own = joined(parts, id + 2, parts.size());
    if (!is_all_digits(named.upload) || named.own.empty()) return {};
    return named;
}

/// `[Group-]Jane Doe_1003_assignsubmission_file_/sub/f.cpp`, with or without the last `_`, or `…_file_f.cpp`: Moodle
/// writes blanks for the `_` of names.
std::optional<UploadName> named_by_moodle(const std::string &name) {
    const std::string head = name.substr(0, name.find('/'));
    const std::vector<std::string> parts = split_at(head, '_');
    if (parts.size() < 4 || !is_all_digits(parts[1]) || parts[2] != "assignsubmission") return {};
    UploadName named;
    named.id = parts[1];
    named.who = parts[0] + '_' + parts[1];
    named.kind = parts[3] == "file" ? UploadName::file : UploadName::text;
    const std::string after = joined(parts, 4, parts.size());
    const bool in_a_folder = head.size() < name.size();
    if (in_a_folder != after.empty()) return {};
    named.own = in_a_folder ? name.substr(head.size() + 1) : after;
    named.feedback = (in_a_folder ? head + '/' : joined(parts, 0, 4) + '_') + "feedback.txt";
    return named;
}

/// `1003/f.cpp`
std::optional<UploadName> named_by_folder(const std::string &name) {
    const std::size_t slash = name.find('/');
    if (slash == name.npos || slash == 0) return {};
    const std::string id = name.substr(0, slash);
    return UploadName{id, "", id, name.substr(slash + 1), "", id + "/feedback.txt"};
}

} // namespace

std::vector<std::string> split_at(std::string_view text, char separator) {
    std::vector<std::string> parts(1);
    for (const char c : text)
        if (c == separator) parts.emplace_back();
        else parts.back() += c;
    return parts;
}

bool is_anonymous(std::string_view name) { return name.starts_with("anon_") || name.starts_with("LATE_anon_"); }

std::optional<UploadName> named_by(Platform platform, const std::string &name, bool anonymous) {
    return platform == Platform::moodle   ? named_by_moodle(name)
           : platform == Platform::canvas ? named_by_canvas(name, anonymous)
                                          : named_by_folder(name);
}

std::optional<Platform> platform_of(const std::string &name, bool anonymous) {
    for (const Platform each :
         {Platform::moodle, Platform::canvas, Platform::folder}) // flat names of Moodle may look like Canvas'
        if (named_by(each, name, anonymous)) return each;
    return {};
}

} // namespace course
