#include "grade/archive.hpp"

#include "base/files.hpp"
#include "base/plain.hpp"
#include "base/text.hpp"

#include <map>
#include <sys/stat.h>
#include <zip.h>

namespace course {
namespace fs = std::filesystem;

std::string without_marks(std::string_view name) {
    std::string kept;
    while (!name.empty()) {
        const std::size_t length = std::max<std::size_t>(utf8_length(name), 1);
        if (!turns_text(name.substr(0, length))) kept += name.substr(0, length);
        name.remove_prefix(length);
    }
    return plain_line(kept, kept.size());
}

std::string unsafe_name(std::string_view name) {
    constexpr std::size_t longest = 4096; // as long as a path may be on Linux
    if (name.empty()) return "has no name";
    if (name.size() > longest) return "has a name of more than 4096 bytes";
    if (plain_line(name, longest) != name) return "has a name with characters that can't be shown";
    if (contains(name, "\\")) return "has a backslash in its name";
    if (name.front() == '/') return "begins at the root of the disk";
    if (contains("/" + std::string{name} + "/", "/../")) return "leads out of its folder";
    return {};
}

namespace {

/// What keeps us from reading an entry, apart from the name.
std::string unsafe_kind(zip_t *zip, const zip_stat_t &about) {
    zip_uint8_t system = 0;
    zip_uint32_t attributes = 0;
    if (zip_file_get_external_attributes(zip, about.index, 0, &system, &attributes) != 0) return "is broken";
    const std::uint32_t kind = attributes >> 16 & S_IFMT; // whatever system it says it's from
    if (kind == S_IFLNK) return "is a link";
    if (kind != 0 && kind != S_IFREG) return "is no ordinary file";
    if (about.encryption_method != ZIP_EM_NONE) return "is encrypted";
    return {};
}

/// Of two files with one name, which one would be judged? And on some disks, F.cpp and f.cpp are one file.
void mark_doubles(std::vector<Archive::Entry> &entries) {
    std::map<std::string, Archive::Entry *> first;
    for (Archive::Entry &entry : entries) {
        const auto [same, is_new] = first.emplace(lower(entry.name), &entry);
        if (is_new) continue;
        for (Archive::Entry *each : {same->second, &entry})
            if (each->unsafe.empty()) each->unsafe = "is there twice, or differs from another only by capitals";
    }
}

void must(bool worked, const fs::path &file) {
    if (!worked) throw EnvironmentError{"cannot pack " + file.string() + ": is there enough memory? Try again."};
}

} // namespace

struct Archive::Opened {
    zip_t *zip;
    ~Opened() { zip_discard(zip); }
};

Archive::Archive(const fs::path &file) {
    std::error_code ignored;
    if (!fs::exists(file, ignored)) throw UserError{"there is no file " + file.string() + ": what is it called?"};
    int error = 0;
    zip_t *const zip = zip_open(file.c_str(), ZIP_RDONLY, &error);
    if (zip == nullptr)
        throw UserError{file.string() + " is no zip archive, or only a part of one: download it again."};
    opened.reset(new Opened{zip});
    const auto count = static_cast<zip_uint64_t>(zip_get_num_entries(zip, 0));
    if (count > most_entries)
        throw UserError{file.string() + " has " + std::to_string(count)
                        + " files in it, more than any class hands in: is it the right one?"};
    for (zip_uint64_t i = 0; i < count; ++i) {
        const char *const name = zip_get_name(zip, i, ZIP_FL_ENC_RAW); // as it is: nothing is guessed about letters
        zip_stat_t about;
        if (name == nullptr || zip_stat_index(zip, i, 0, &about) != 0)
            throw UserError{file.string() + " is broken: download it again."};
        Entry entry{without_marks(name), about.size, "", i};
        entry.unsafe = unsafe_name(entry.name);
        if (entry.unsafe.empty() && entry.name.ends_with('/')) continue; // a folder
        if (entry.unsafe.empty()) entry.unsafe = unsafe_kind(zip, about);
        all.push_back(std::move(entry));
    }
    mark_doubles(all);
}

Archive::~Archive() = default;

std::string Archive::read(const Entry &entry, std::uint64_t most) const {
    const std::string name = plain_line(entry.name, 100);
    if (!entry.unsafe.empty()) throw UserError{name + " " + entry.unsafe + ", so it's not read."};
    const std::unique_ptr<zip_file_t, int (*)(zip_file_t *)> file{zip_fopen_index(opened->zip, entry.place, 0),
                                                                  &zip_fclose};
    const UserError broken{name + " can't be unpacked: download the archive again."};
    if (!file) throw broken;
    std::string bytes;
    char part[1 << 14];
    while (const zip_int64_t got = zip_fread(file.get(), part, sizeof part)) {
        if (got < 0) throw broken;
        bytes.append(part, static_cast<std::size_t>(got));
        if (bytes.size() > most) throw TooLarge{name + " has more than " + std::to_string(most) + " bytes."};
    }
    return bytes;
}

void write_archive(const fs::path &file, const std::vector<std::pair<std::string, std::string>> &files) {
    const std::unique_ptr<zip_source_t, void (*)(zip_source_t *)> packed{
        zip_source_buffer_create(nullptr, 0, 0, nullptr), &zip_source_free};
    must(packed != nullptr, file);
    zip_source_keep(packed.get()); // for the archive, which frees it when it's closed
    zip_t *const zip = zip_open_from_source(packed.get(), ZIP_TRUNCATE, nullptr);
    must(zip != nullptr, file);
    for (const auto &[name, bytes] : files) {
        zip_source_t *const source = zip_source_buffer(zip, bytes.data(), bytes.size(), 0);
        const zip_int64_t at = zip_file_add(zip, name.c_str(), source, ZIP_FL_ENC_UTF_8);
        must(at >= 0, file);
        constexpr zip_uint16_t noon = 12 << 11, first_of_2026 = (2026 - 1980) << 9 | 1 << 5 | 1;
        must(zip_file_set_dostime(zip, static_cast<zip_uint64_t>(at), noon, first_of_2026, 0) == 0, file);
    }
    must(zip_close(zip) == 0, file);

    zip_stat_t about;
    must(zip_source_stat(packed.get(), &about) == 0 && zip_source_open(packed.get()) == 0, file);
    std::string bytes(about.size, '\0');
    must(zip_source_read(packed.get(), bytes.data(), bytes.size()) == static_cast<zip_int64_t>(bytes.size()), file);
    zip_source_close(packed.get());
    write_file(file, bytes);
}

} // namespace course
