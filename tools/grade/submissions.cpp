#include "grade/submissions.hpp"

#include "base/files.hpp"
#include "base/plain.hpp"
#include "base/text.hpp"
#include "grade/archive.hpp"
#include "grade/upload_name.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <iconv.h>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <tuple>

namespace course {
namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t longest_file = 1'000'000;
constexpr std::size_t most_others = 20;

/// A file of the download, in an archive or on disk.
struct File {
    std::string name, unsafe;
    std::function<std::string()> read; ///< @throws TooLarge, or another UserError
};

struct Upload {
    UploadName named;
    const File *file;
};

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

std::string read_on_disk(const fs::path &file) {
    std::error_code ignored;
    if (const auto size = fs::file_size(file, ignored); !ignored && size > longest_file)
        throw TooLarge{file.string() + " is too large."};
    return read_file(file);
}

/// The folder of a class that has the most files in it.
std::string fullest_folder(const std::vector<File> &files) {
    std::map<std::string, std::size_t> counts;
    for (const File &each : files) ++counts[each.name.substr(0, each.name.find('/'))];
    return std::ranges::max_element(counts, {}, [](const auto &each) { return each.second; })->first;
}

std::vector<File> files_on_disk(const fs::path &given) try {
    constexpr int deepest = 12; // no path gets too long, however deep somebody's folders are
    std::vector<File> all;
    for (auto at = fs::recursive_directory_iterator{given}; at != fs::end(at); ++at) { // doesn't follow links
        const fs::directory_entry &entry = *at;
        if (entry.is_directory() && !entry.is_symlink()) { // of a clone of the course, only the exercises
            const bool is_deep = at.depth() >= deepest;
            if (is_deep
                || (entry.path().filename() != "exercises" && fs::exists(entry.path().parent_path() / "exercises")))
                at.disable_recursion_pending();
            if (!is_deep) continue;
        }
        all.push_back({without_marks(entry.path().lexically_relative(given).generic_string()),
                       entry.is_symlink()         ? "is a link"
                       : entry.is_directory()     ? "lies deeper than we look"
                       : !entry.is_regular_file() ? "is no ordinary file"
                                                  : "",
                       [path = entry.path()] { return read_on_disk(path); }});
        if (all.size() > most_entries)
            throw UserError{given.string() + " has more than " + std::to_string(most_entries)
                            + " files in it, more than any class hands in, and most of them in "
                            + plain_line(fullest_folder(all), 100)
                            + ": is it the right folder? Else take that one out"};
    }
    std::ranges::sort(all, {}, &File::name);
    return all;
} catch (const fs::filesystem_error &error) {
    throw UserError{"cannot read " + error.path1().string() + ": " + error.code().message() + "."};
}

std::vector<File> files_in_archive(const fs::path &given) {
    const auto archive = std::make_shared<const Archive>(given);
    std::vector<File> all;
    for (const Archive::Entry &entry : archive->entries())
        all.push_back({entry.name, entry.unsafe, [archive, &entry] { return archive->read(entry, longest_file); }});
    if (!all.empty() && std::ranges::all_of(all, [](const File &each) { return each.unsafe == "is encrypted"; }))
        throw UserError{given.string() + " is encrypted: unpack it, and give the folder."};
    return all;
}

/// What macOS puts everywhere.
bool is_litter(std::string_view name) {
    return name.starts_with("__MACOSX/") || contains(name, "/__MACOSX/") || last_part(name) == ".DS_Store";
}

[[noreturn]] void unknown(const fs::path &given, const std::vector<File> &files, const std::string &why) {
    std::string names;
    for (std::size_t i = 0; i < std::min<std::size_t>(files.size(), 3); ++i)
        names += (i > 0 ? ", " : " It begins with ") + plain_line(files[i].name, 100);
    throw UserError{given.string() + " " + why
                    + ": give the zip that Canvas or Moodle lets you download, or a folder with a folder for each "
                      "student, as 1003/f.cpp."
                    + names};
}

/// The folder that holds the whole of a download which was packed anew: "HW5 submissions/"; else "". Several folders
/// in it are students', unless it's called by a number, or is a clone of the course: then it's a student's itself.
std::string wrapping_folder(const std::vector<File> &files) {
    std::set<std::string> outer, inner;
    bool platform = false, folders = true;
    for (const File &each : files) {
        if (!unsafe_name(each.name).empty()) continue;
        const std::size_t slash = each.name.find('/');
        if (slash == each.name.npos || named_by(Platform::moodle, each.name, false)) return "";
        const std::string rest = each.name.substr(slash + 1);
        outer.insert(each.name.substr(0, slash + 1));
        inner.insert(rest.substr(0, rest.find('/')));
        platform =
            platform || named_by(Platform::moodle, rest, false) || named_by(Platform::canvas, rest, is_anonymous(rest));
        folders = folders && contains(rest, "/");
    }
    const bool students = folders && inner.size() > 1 && !inner.contains("exercises");
    if (outer.size() != 1 || is_all_digits(outer.begin()->substr(0, outer.begin()->size() - 1))) return "";
    return platform || students ? *outer.begin() : "";
}

/// The platform that most names are of: a single one of another kind isn't worth refusing a class.
Platform main_platform(const fs::path &given, const std::vector<File> &files, bool anonymous) {
    std::map<Platform, std::vector<std::string>> names;
    for (const File &each : files)
        if (const auto platform = unsafe_name(each.name).empty() ? platform_of(each.name, anonymous) : std::nullopt)
            names[*platform].push_back(each.name);
    if (names.empty()) unknown(given, files, files.empty() ? "is empty" : "isn't what a class hands in");
    const auto fewer = [](const auto &a, const auto &b) { return a.second.size() < b.second.size(); };
    const auto most = std::ranges::max_element(names, fewer);
    for (const auto &[platform, others] : names)
        if (platform != most->first && others.size() == most->second.size())
            unknown(given, files,
                    fmt::format("has a name as from {}, {}, and one as from {}, {}", name_of(most->first),
                                most->second.front(), name_of(platform), others.front()));
    return most->first;
}

/// `f` of `f-1`, `f (1)` and `f(1)`.
std::string_view without_copy_mark(std::string_view stem) {
    for (;;) {
        const bool bracket = stem.ends_with(')');
        const std::size_t mark = stem.rfind(bracket ? '(' : '-');
        if (mark == stem.npos || mark == 0) return stem;
        if (!is_all_digits(stem.substr(mark + 1, stem.size() - mark - 1 - bracket))) return stem;
        stem = stem.substr(0, mark);
        if (bracket && stem.ends_with(' ')) stem.remove_suffix(1);
    }
}

/// Without what browsers put behind a name that is there already, and Canvas behind the part before the first period.
std::string first_name(std::string_view own) {
    std::vector<std::string> parts = split_at(last_part(own), '.');
    std::string name{without_copy_mark(parts.front())};
    for (std::size_t i = 1; i < parts.size(); ++i)
        name.append(".").append(i + 1 < parts.size() ? without_copy_mark(parts[i]) : std::string_view{parts[i]});
    return name;
}

bool ends_with_any(std::string_view own, Words ends) {
    return std::ranges::any_of(ends, [small = lower(own)](std::string_view end) { return small.ends_with(end); });
}

/// How clearly a file is the exercise's: by its name; by that with another end; as C++; or with another end of C++.
int clearness(const UploadName &named, const std::string &expected) {
    if (named.kind != UploadName::file) return 0;
    const std::string name = first_name(named.own), small = lower(name),
                      stem = lower(expected.substr(0, expected.find('.')));
    if (name == expected) return 4;
    if (small.starts_with(stem)
        && is_any_of(small.substr(stem.size()),
                     {"", ".cpp", ".cc", ".cxx", ".c++", ".c", ".txt", ".cpp.txt", ".cc.txt"}))
        return 3;
    if (small.ends_with(".cpp")) return 2;
    return ends_with_any(small, {".cc", ".cxx", ".c++", ".c", ".cpp.txt", ".cc.txt"}) ? 1 : 0;
}

/// Those that may be the exercise's file: all that say so equally clearly.
std::vector<const Upload *> candidates(const std::vector<Upload> &uploads, const std::string &expected) {
    std::vector<const Upload *> all;
    int best = 1;
    for (const Upload &each : uploads) {
        const int clear = clearness(each.named, expected);
        if (clear > best) all.clear();
        if (clear >= best) all.push_back(&each);
        best = std::max(best, clear);
    }
    return all;
}

/// The only one for which this is true, or none.
const Upload *only(const std::vector<const Upload *> &all, const std::function<bool(const UploadName &)> &is_it) {
    const auto fits = [&](const Upload *each) { return is_it(each->named); };
    return std::ranges::count_if(all, fits) == 1 ? *std::ranges::find_if(all, fits) : nullptr;
}

/// Of these, the newest of several uploads, or else a clone's exercise, or the one that isn't named as a copy.
const Upload *clearest(const std::vector<const Upload *> &all, const std::string &expected) {
    if (all.empty()) return nullptr;
    if (std::ranges::all_of(all, [&](const Upload *each) {
            return !each->named.upload.empty() && first_name(each->named.own) == first_name(all[0]->named.own);
        }))
        return all[0];
    if (const auto *one = only(all, [](const UploadName &) { return true; })) return one;
    const auto exercise = [&](const UploadName &named) {
        return ('/' + named.own).ends_with("/exercises/" + expected);
    };
    if (const auto *one = only(all, exercise)) return one;
    return only(all, [&](const UploadName &named) { return last_part(named.own) == expected; });
}

/// The file that the instructor names. @throws UserError if there's none, or more than one
const Upload *upload_named(const std::vector<Upload> &uploads, const std::string &id, const std::string &name) {
    std::vector<const Upload *> all;
    std::string names;
    for (const Upload &each : uploads) {
        all.push_back(&each);
        names += (names.empty() ? "" : ", ") + each.named.own;
    }
    for (const bool whole : {true, false})
        if (const auto *one = only(all, [&](const UploadName &each) {
                return each.kind == UploadName::file && (whole ? each.own : last_part(each.own)) == name;
            }))
            return one;
    throw UserError{fmt::format("--take {}={} means no file of theirs. They handed in {}.", id, plain_line(name, 100),
                                plain_line(names, 500))};
}

/// To a student who handed in no file that can be meant.
std::string why_none(const std::vector<Upload> &uploads, const std::vector<const Upload *> &several,
                     const std::string &expected) {
    if (!several.empty() && first_name(several[0]->named.own) == expected)
        return fmt::format("You handed in {} files called {}: hand in just the one that counts.", several.size(),
                           expected);
    if (!several.empty())
        return fmt::format("You handed in {} C++ files, but none of them is called {}: hand in just that one.",
                           several.size(), expected);
    for (const Upload &each : uploads)
        if (ends_with_any(each.named.own, {".zip", ".7z", ".rar", ".tar", ".gz", ".tgz", ".xz"}))
            return fmt::format("You handed in an archive, {}: hand in {} itself, unpacked.", each.named.own, expected);
    const UploadName &newest = uploads.front().named;
    if (newest.kind == UploadName::link) return "You handed in a link: hand in the file itself, " + expected + ".";
    if (newest.kind == UploadName::text) return "You typed in a text, but there's no file: hand in " + expected + ".";
    return fmt::format("You handed in {}, but no .cpp file: hand in {}.", newest.own, expected);
}

/// A file that says it's UTF-16, as UTF-8; any other as it is.
std::string in_utf8(std::string bytes) {
    if (!bytes.starts_with("\xFF\xFE") && !bytes.starts_with("\xFE\xFF")) return bytes;
    const std::unique_ptr<void, int (*)(iconv_t)> converter{iconv_open("UTF-8", "UTF-16"), &iconv_close};
    std::string text(2 * bytes.size(), '\0'); // two bytes become three at most
    char *from = bytes.data(), *to = text.data();
    std::size_t left = bytes.size(), room = text.size();
    if (iconv(converter.get(), &from, &left, &to, &room) == static_cast<std::size_t>(-1)) return bytes;
    return text.substr(0, text.size() - room);
}

/// The text of a file that is meant, or the student's mistake. A broken download is none.
std::optional<std::string> read(const Upload &upload, Submission &result) try {
    if (upload.file->unsafe.empty()) return in_utf8(upload.file->read());
    result.trouble = fmt::format("Your {} {}, so we didn't read it: hand in just the file itself.", upload.named.own,
                                 upload.file->unsafe);
    return {};
} catch (const TooLarge &) {
    result.trouble = "Your " + upload.named.own + " is larger than 1 MB: hand in just your C++ code.";
    return {};
} catch (const UserError &broken) {
    result.unread = broken.what();
    return {};
}

/// How a file that wasn't taken is described.
std::string describe_other(const Upload &upload, const Upload *meant) {
    const UploadName &named = upload.named;
    if (named.kind != UploadName::file)
        return named.own + (named.kind == UploadName::link ? " (a link)" : " (typed text)");
    if (!upload.file->unsafe.empty()) return named.own + " (" + upload.file->unsafe + ")";
    const bool same = meant != nullptr && meant != &upload && first_name(meant->named.own) == first_name(named.own);
    return named.own + (!same ? "" : named.upload.empty() ? " (a copy)" : " (older)");
}

/// Canvas calls feedback as the file that it's about, and has none to name it after where nothing was uploaded.
std::string undelivered(const UploadName &named) {
    if (named.kind != UploadName::file) return "Canvas drops it, for there's no file that it's about";
    const bool opens = clearness(named, "") > 0 || ends_with_any(named.own, {".txt", ".h", ".hpp", ".md"});
    return opens ? "" : "Canvas calls it " + named.own;
}

/// All that one student handed in, of which one file is to be judged.
Submission submission(std::vector<Upload> uploads, Platform platform, const std::string &expected, const fs::path &into,
                      const std::map<std::string, std::string> &take) {
    std::ranges::stable_sort(uploads,
                             [](const Upload &a, const Upload &b) { return before(b.named.upload, a.named.upload); });
    Submission result;
    result.id = uploads.front().named.id;
    result.name = uploads.front().named.name;
    const std::vector<const Upload *> all = candidates(uploads, expected);
    const auto named = take.find(result.id);
    const Upload *const meant =
        named == take.end() ? clearest(all, expected) : upload_named(uploads, result.id, named->second);
    if (meant == nullptr) result.trouble = why_none(uploads, all, expected);
    else if (const auto text = read(*meant, result)) {
        result.file = into / (result.id + ".cpp");
        result.taken = meant->named.own;
        write_file(result.file, *text);
    }
    const UploadName &answered = result.taken.empty() ? uploads.front().named : meant->named;
    result.feedback_name = answered.feedback;
    if (platform == Platform::canvas) result.undelivered = undelivered(answered);
    for (const Upload &each : uploads) {
        result.late = result.late || each.named.late;
        if (&each == meant && !result.taken.empty()) continue;
        if (result.others.size() < most_others) result.others.push_back(describe_other(each, meant));
        else if (result.others.size() == most_others) result.others.push_back("and more");
    }
    return result;
}

} // namespace

Submissions read_submissions(const fs::path &given, const Section &section, const fs::path &into,
                             const std::map<std::string, std::string> &take, bool wrapped) {
    std::error_code ignored;
    std::vector<File> files = fs::is_directory(given, ignored) ? files_on_disk(given) : files_in_archive(given);
    std::erase_if(files, [](const File &each) { return is_litter(each.name); });
    for (const std::string folder = wrapped ? wrapping_folder(files) : ""; File & each : files)
        if (each.name.starts_with(folder)) each.name.erase(0, folder.size());
    const bool anonymous = std::ranges::all_of(files, is_anonymous, &File::name);
    Submissions result;
    result.platform = main_platform(given, files, anonymous);
    const auto leave = [&](const std::string &name, const std::string &why) {
        result.left_alone.push_back(plain_line(name, 120) + ": " + why);
    };

    std::map<std::string, std::vector<Upload>> students; // by what tells files apart on any disk
    for (const File &file : files) {
        const auto named = named_by(result.platform, file.name, anonymous);
        if (const std::string why = unsafe_name(file.name); !why.empty()) leave(file.name, why);
        else if (!named)
            leave(file.name,
                  !file.unsafe.empty() ? file.unsafe
                  : result.platform == Platform::folder
                      ? "is in no student's folder"
                      : "isn't named as " + std::string{name_of(result.platform)} + " names what's handed in");
        else if (!fit_for_a_file(named->id))
            leave(file.name, "has an id with other characters than letters, digits, . _ -");
        else students[lower(named->id)].push_back({*named, &file});
    }
    for (const auto &[id, uploads] : students) {
        const Upload &first = uploads.front();
        if (std::ranges::all_of(uploads, [&](const Upload &each) { return each.named.who == first.named.who; }))
            result.all.push_back(submission(uploads, result.platform, section.name + ".cpp", into, take));
        else
            for (const Upload &each : uploads)
                leave(each.file->name, "somebody else has the id " + first.named.id + " too");
    }
    std::ranges::sort(result.all, before, &Submission::id);
    for (const auto &[id, name] : take)
        if (std::ranges::count(result.all, id, &Submission::id) == 0)
            throw UserError{"--take " + plain_line(id, 100) + "=" + plain_line(name, 100)
                            + ": nobody with that id has handed anything in."};
    return result;
}

} // namespace course
