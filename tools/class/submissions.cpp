#include "class/submissions.hpp"

#include "class/archive.hpp"
#include "ground/files.hpp"
#include "ground/plain.hpp"
#include "ground/text.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <tuple>

namespace course {
namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t longest_file = 1'000'000;
constexpr std::size_t most_listed = 20;

/// A file of the download, in an archive or on disk.
struct Found {
    std::string name, unsafe;
    std::function<std::string()> read; ///< @throws TooLarge, or another Complaint
};

/// What a platform says by a file's name.
struct Named {
    std::string id, who; ///< who: all of the name that tells people apart
    std::string own;     ///< what the student calls it
    std::string upload;  ///< Canvas' number of it: the larger, the newer
    std::string feedback;
    enum Kind { file, text, link } kind = file;
    bool late = false;
};

struct Upload {
    Named named;
    const Found *found;
};

std::vector<std::string> split(std::string_view text, char at) {
    std::vector<std::string> parts(1);
    for (const char c : text)
        if (c == at) parts.emplace_back();
        else parts.back() += c;
    return parts;
}

std::string joined(const std::vector<std::string> &parts, std::size_t from, std::size_t to) {
    std::string text;
    for (std::size_t i = from; i < to; ++i) text += (i > from ? "_" : "") + parts[i];
    return text;
}

std::string_view last_part(std::string_view path) { return path.substr(path.rfind('/') + 1); }

bool fit_for_a_file(std::string_view id) {
    constexpr std::size_t longest = 100;
    return !id.empty() && id.size() <= longest && id[0] != '.' && id[0] != '-'
           && std::ranges::all_of(id, [](char c) { return is_in_a_name(c) || c == '.' || c == '-'; });
}

/// Numbers by size, then words.
bool before(std::string_view a, std::string_view b) {
    const auto key = [](std::string_view text) {
        const bool word = !is_all_digits(text);
        const std::string_view digits = word ? text : text.substr(std::min(text.find_first_not_of('0'), text.size()));
        return std::tuple{word, word ? 0 : digits.size(), digits, text};
    };
    return key(a) < key(b);
}

bool is_anonymous(std::string_view name) { return name.starts_with("anon_") || name.starts_with("LATE_anon_"); }

/// `doejane[_LATE]_1003_88_f.cpp`, or `[LATE_]anon_x7_88_f.cpp`: Canvas too goes by the first two parts that are
/// numbers.
std::optional<Named> named_by_canvas(const std::string &name, bool anonymous) {
    if (contains(name, "/")) return {};
    const std::vector<std::string> parts = split(name, '_');
    std::size_t id = 0;
    if (anonymous && is_anonymous(name)) id = parts[0] == "anon" ? 1 : 2;
    else
        while (id < parts.size() && !is_all_digits(parts[id])) ++id;
    if (id == 0 || id + 1 >= parts.size()) return {};
    if (!anonymous && is_anonymous(name) && parts[id - 1] != "anon" && parts[id - 1] != "LATE") return {};

    Named named;
    named.id = parts[id];
    named.feedback = name;
    named.late = parts[anonymous ? 0 : id - 1] == "LATE";
    named.who = joined(parts, 0, !anonymous && named.late ? id - 1 : id) + '_' + named.id;
    if (anonymous) named.who = named.id;
    const std::string rest = joined(parts, id + 1, parts.size());
    if (rest == "text.html" || rest == "link.html") {
        named.own = rest;
        named.upload = "0"; // there's none: any file is newer
        named.kind = rest == "text.html" ? Named::text : Named::link;
        return named;
    }
    named.upload = parts[id + 1];
    named.own = joined(parts, id + 2, parts.size());
    if (!is_all_digits(named.upload) || named.own.empty()) return {};
    return named;
}

/// `[Group-]Jane Doe_1003_assignsubmission_file_/sub/f.cpp`, with or without the last `_`, or `…_file_f.cpp`: Moodle
/// writes blanks for the `_` of names.
std::optional<Named> named_by_moodle(const std::string &name) {
    const std::string head = name.substr(0, name.find('/'));
    const std::vector<std::string> parts = split(head, '_');
    if (parts.size() < 4 || !is_all_digits(parts[1]) || parts[2] != "assignsubmission") return {};
    Named named;
    named.id = parts[1];
    named.who = parts[0] + '_' + parts[1];
    named.kind = parts[3] == "file" ? Named::file : Named::text;
    const std::string after = joined(parts, 4, parts.size());
    const bool in_a_folder = head.size() < name.size();
    if (in_a_folder != after.empty()) return {};
    named.own = in_a_folder ? name.substr(head.size() + 1) : after;
    named.feedback = (in_a_folder ? head + '/' : joined(parts, 0, 4) + '_') + "feedback.txt";
    return named;
}

/// `1003/f.cpp`
std::optional<Named> named_by_folder(const std::string &name) {
    const std::size_t slash = name.find('/');
    if (slash == name.npos || slash == 0) return {};
    const std::string id = name.substr(0, slash);
    return Named{id, id, name.substr(slash + 1), "", id + "/feedback.txt"};
}

std::optional<Platform> platform_of(const std::string &name, bool anonymous) {
    if (named_by_moodle(name)) return Platform::moodle; // first: its flat names may look like Canvas'
    if (named_by_canvas(name, anonymous)) return Platform::canvas;
    if (named_by_folder(name)) return Platform::folder;
    return {};
}

std::string read_on_disk(const fs::path &file) {
    std::error_code ignored;
    if (const auto size = fs::file_size(file, ignored); !ignored && size > longest_file)
        throw TooLarge{file.string() + " is too large."};
    return read_file(file);
}

std::vector<Found> files_on_disk(const fs::path &given) try {
    std::vector<Found> all;
    for (const fs::directory_entry &entry : fs::recursive_directory_iterator{given}) { // doesn't follow links
        if (entry.is_directory() && !entry.is_symlink()) continue;
        all.push_back({entry.path().lexically_relative(given).generic_string(),
                       entry.is_symlink()         ? "is a link"
                       : !entry.is_regular_file() ? "is no ordinary file"
                                                  : "",
                       [path = entry.path()] { return read_on_disk(path); }});
        if (all.size() > most_entries)
            throw Complaint{given.string() + " has more than " + std::to_string(most_entries)
                            + " files in it, more than any class hands in: is it the right folder?"};
    }
    std::ranges::sort(all, {}, &Found::name);
    return all;
} catch (const fs::filesystem_error &error) {
    throw Complaint{"cannot read " + error.path1().string() + ": " + error.code().message() + "."};
}

std::vector<Found> files_in_archive(const fs::path &given) {
    const auto archive = std::make_shared<const Archive>(given);
    std::vector<Found> all;
    for (const Archive::Entry &entry : archive->entries())
        all.push_back({entry.name, entry.unsafe, [archive, &entry] { return archive->read(entry, longest_file); }});
    if (!all.empty() && std::ranges::all_of(all, [](const Found &each) { return each.unsafe == "is encrypted"; }))
        throw Complaint{given.string() + " is encrypted: unpack it, and give the folder."};
    return all;
}

/// What macOS puts everywhere.
bool is_litter(std::string_view name) {
    return name.starts_with("__MACOSX/") || contains(name, "/__MACOSX/") || last_part(name) == ".DS_Store";
}

[[noreturn]] void unknown(const fs::path &given, const std::vector<Found> &files, const std::string &why) {
    std::string names;
    for (std::size_t i = 0; i < std::min<std::size_t>(files.size(), 3); ++i)
        names += (i > 0 ? ", " : " It begins with ") + plain_line(files[i].name, 100);
    throw Complaint{given.string() + " " + why
                    + ": give the zip that Canvas or Moodle lets you download, or a folder with a folder for each "
                      "student, as 1003/f.cpp."
                    + names};
}

/// The platform that all names are of.
Platform platform_of(const fs::path &given, const std::vector<Found> &files, bool anonymous) {
    std::optional<Platform> platform;
    std::string first;
    bool wrapped = true; // in one folder more than needed
    for (const Found &each : files) {
        const auto its = unsafe_name(each.name).empty() ? platform_of(each.name, anonymous) : std::nullopt;
        if (!its) continue;
        if (!platform) first = each.name;
        if (its != platform.value_or(*its))
            unknown(given, files,
                    fmt::format("has a name as from {}, {}, and one as from {}, {}", name_of(*platform), first,
                                name_of(*its), each.name));
        platform = its;
        const std::size_t folder = first.find('/') + 1; // its length
        wrapped = wrapped && each.name.starts_with(first.substr(0, folder))
                  && platform_of(each.name.substr(folder), false).has_value();
    }
    if (!platform) unknown(given, files, files.empty() ? "is empty" : "isn't what a class hands in");
    if (platform == Platform::folder && wrapped) unknown(given, files, "has everything in one folder");
    return *platform;
}

/// Without what Canvas and browsers put behind a name that is there already: `f-1.cpp`, `f (1).cpp`, `f(1).cpp`.
std::string first_name(std::string_view own) {
    const std::string_view file = last_part(own);
    const std::size_t dot = std::min(file.rfind('.'), file.size());
    std::string_view stem = file.substr(0, dot);
    for (;;) {
        const bool bracket = stem.ends_with(')');
        const std::size_t mark = stem.rfind(bracket ? '(' : '-');
        if (mark == stem.npos || mark == 0) break;
        if (!is_all_digits(stem.substr(mark + 1, stem.size() - mark - 1 - bracket))) break;
        stem = stem.substr(0, mark);
        if (bracket && stem.ends_with(' ')) stem.remove_suffix(1);
    }
    return std::string{stem} += file.substr(dot);
}

bool ends_with_any(std::string_view own, Words ends) {
    return std::ranges::any_of(ends, [small = lower(own)](std::string_view end) { return small.ends_with(end); });
}

/// Those that may be the exercise's file: the ones with its name, or else all that are C++.
std::vector<const Upload *> candidates(const std::vector<Upload> &uploads, const std::string &wanted) {
    std::vector<const Upload *> named, any;
    for (const Upload &each : uploads) {
        if (each.named.kind != Named::file || !ends_with_any(each.named.own, {".cpp"})) continue;
        any.push_back(&each);
        if (first_name(each.named.own) == wanted) named.push_back(&each);
    }
    return named.empty() ? any : named;
}

/// To a student, of whose files none can be meant.
std::string why_none(const std::vector<Upload> &uploads, const std::vector<const Upload *> &several,
                     const std::string &wanted) {
    if (!several.empty() && first_name(several[0]->named.own) == wanted)
        return fmt::format("You handed in {} files called {}: hand in just the one that counts.", several.size(),
                           wanted);
    if (!several.empty())
        return fmt::format("You handed in {} .cpp files, but none of them is called {}: hand in just that one.",
                           several.size(), wanted);
    for (const Upload &each : uploads)
        if (ends_with_any(each.named.own, {".zip", ".7z", ".rar", ".tar", ".gz", ".tgz", ".xz"}))
            return fmt::format("You handed in an archive, {}: hand in {} itself, unpacked.", each.named.own, wanted);
    const Named &newest = uploads.front().named;
    if (newest.kind == Named::link) return "You handed in a link: hand in the file itself, " + wanted + ".";
    if (newest.kind == Named::text) return "You typed in a text, but there's no file: hand in " + wanted + ".";
    return fmt::format("You handed in {}, but no .cpp file: hand in {}.", newest.own, wanted);
}

/// The bytes of a file that is meant, or the student's mistake. A broken download is none.
std::optional<std::string> read(const Upload &upload, std::string &trouble) try {
    if (upload.found->unsafe.empty()) return upload.found->read();
    trouble = fmt::format("Your {} {}, so we didn't read it: hand in just the file itself.", upload.named.own,
                          upload.found->unsafe);
    return {};
} catch (const TooLarge &) {
    trouble = "Your " + upload.named.own + " is larger than 1 MB: hand in just your C++ code.";
    return {};
}

/// What is listed of a file that wasn't taken.
std::string listed(const Upload &upload, const Upload *meant) {
    const Named &named = upload.named;
    if (named.kind != Named::file) return named.own + (named.kind == Named::link ? " (a link)" : " (typed text)");
    if (!upload.found->unsafe.empty()) return named.own + " (" + upload.found->unsafe + ")";
    const bool same = meant != nullptr && meant != &upload && first_name(meant->named.own) == first_name(named.own);
    return named.own + (same ? " (older)" : "");
}

/// All that one student handed in, of which one file is to be judged.
Submission submission(std::vector<Upload> uploads, const Section &section, const fs::path &into) {
    const std::string wanted = section.name + ".cpp";
    std::ranges::stable_sort(uploads,
                             [](const Upload &a, const Upload &b) { return before(b.named.upload, a.named.upload); });
    Submission result;
    result.id = uploads.front().named.id;
    result.feedback_name = uploads.front().named.feedback;
    const std::vector<const Upload *> all = candidates(uploads, wanted);
    const bool one_after_the_other = std::ranges::all_of(all, [&](const Upload *each) {
        return !each->named.upload.empty() && first_name(each->named.own) == first_name(all[0]->named.own);
    });
    const Upload *const meant = all.size() == 1 || (!all.empty() && one_after_the_other) ? all[0] : nullptr;
    if (meant == nullptr) result.trouble = why_none(uploads, all, wanted);
    else if (const auto bytes = read(*meant, result.trouble)) {
        result.file = into / (result.id + ".cpp");
        result.taken = meant->named.own;
        result.feedback_name = meant->named.feedback;
        write_file(result.file, *bytes);
    }
    for (const Upload &each : uploads) {
        result.late = result.late || each.named.late;
        if (&each == meant && !result.taken.empty()) continue;
        if (result.others.size() < most_listed) result.others.push_back(listed(each, meant));
        else if (result.others.size() == most_listed) result.others.push_back("and more");
    }
    return result;
}

} // namespace

Submissions read_submissions(const fs::path &given, const Section &section, const fs::path &into) {
    std::error_code ignored;
    std::vector<Found> files = fs::is_directory(given, ignored) ? files_on_disk(given) : files_in_archive(given);
    std::erase_if(files, [](const Found &each) { return is_litter(each.name); });
    const bool anonymous = std::ranges::all_of(files, is_anonymous, &Found::name);
    Submissions result;
    result.platform = platform_of(given, files, anonymous);
    const auto leave = [&](const std::string &name, const std::string &why) {
        result.left_alone.push_back(plain_line(name, 120) + ": " + why);
    };

    std::map<std::string, std::vector<Upload>> students; // by what tells files apart on any disk
    for (const Found &found : files) {
        const auto named = result.platform == Platform::moodle   ? named_by_moodle(found.name)
                           : result.platform == Platform::canvas ? named_by_canvas(found.name, anonymous)
                                                                 : named_by_folder(found.name);
        if (const std::string why = unsafe_name(found.name); !why.empty()) leave(found.name, why);
        else if (!named)
            leave(found.name,
                  !found.unsafe.empty() ? found.unsafe
                  : result.platform == Platform::folder
                      ? "is in no student's folder"
                      : "isn't named as " + std::string{name_of(result.platform)} + " names what's handed in");
        else if (!fit_for_a_file(named->id))
            leave(found.name, "has an id with other characters than letters, digits, . _ -");
        else students[lower(named->id)].push_back({*named, &found});
    }
    for (const auto &[id, uploads] : students) {
        const Upload &first = uploads.front();
        if (std::ranges::all_of(uploads, [&](const Upload &each) { return each.named.who == first.named.who; }))
            result.all.push_back(submission(uploads, section, into));
        else
            for (const Upload &each : uploads)
                leave(each.found->name, "somebody else has the id " + first.named.id + " too");
    }
    std::ranges::sort(result.all, before, &Submission::id);
    return result;
}

} // namespace course
