#include "base/files.hpp"

#include "base/errors.hpp"
#include "base/process.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <sstream>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace course {
namespace fs = std::filesystem;

std::string read_file(const fs::path &path) {
    std::ifstream file{path, std::ios::binary};
    if (!file || fs::is_directory(path))
        throw UserError{"cannot read " + path.string() + ": does it exist, and may you read it?"};
    std::ostringstream text;
    text << file.rdbuf(); // one character after the other takes ten times as long
    return std::move(text).str();
}

std::vector<fs::path> files_in(const fs::path &folder, std::string_view end, std::string_view start) {
    std::vector<fs::path> files;
    if (!fs::is_directory(folder)) return files;
    for (const auto &entry : fs::directory_iterator{folder})
        if (const std::string name = entry.path().filename().string();
            name.starts_with(start) && name.ends_with(end) && entry.is_regular_file())
            files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

namespace {

[[noreturn]] void refuse(const fs::path &path, int error) {
    const std::string where = "cannot write " + path.string() + ": ";
    if (error == ENOSPC || error == EDQUOT || error == EFBIG)
        throw EnvironmentError{where + "the disk is full; make some room and try again. The old file is as it was."};
    throw UserError{where + std::strerror(error) + "; make " + path.parent_path().string()
                    + " writable, or run this as its owner."};
}

/// Everything or an error number.
int write_all(int file, std::string_view text) {
    while (!text.empty()) {
        const ssize_t written = ::write(file, text.data(), text.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return errno;
        text.remove_prefix(static_cast<std::size_t>(written));
    }
    return ::fsync(file) == 0 || errno == EINVAL ? 0 : errno;
}

/// A draft beside the file, so that renaming is one step. It is locked while we write it; one that a kill has left is
/// written over.
int open_draft(const fs::path &draft) {
    for (;;) {
        const int file = ::open(draft.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
        if (file < 0 && errno == EACCES && ::unlink(draft.c_str()) == 0) continue; // what was left is read-only
        if (file < 0) return file;
        while (::flock(file, LOCK_EX) != 0 && errno == EINTR) {}
        struct stat opened {
        }, there{};
        if (::fstat(file, &opened) != 0 || (::stat(draft.c_str(), &there) == 0 && there.st_ino == opened.st_ino))
            return file;
        ::close(file); // another command has written it meanwhile
    }
}

} // namespace

bool write_file(const fs::path &file_or_link, std::string_view text) {
    std::error_code ignored;
    fs::path path = file_or_link;
    for (int links = 0; links < 40 && fs::is_symlink(path, ignored); ++links) // keep the link, write what it names
        path = path.parent_path() / fs::read_symlink(path, ignored);
    if (fs::is_regular_file(path, ignored) && read_file(path) == text) return false;

    std::error_code trouble;
    if (path.has_parent_path()) fs::create_directories(path.parent_path(), trouble);
    if (trouble) refuse(path, trouble.value());

    const SignalBlocker blocker; // Ctrl-C in between would leave the draft lying about
    const fs::path draft = path.parent_path() / ('.' + path.filename().string() + ".draft");
    const int file = open_draft(draft);
    if (file < 0) refuse(path, errno);
    int error = ::ftruncate(file, 0) == 0 ? write_all(file, text) : errno;
    struct stat old {};
    if (::stat(path.c_str(), &old) == 0 && ::fchmod(file, old.st_mode & 07777) != 0 && error == 0) error = errno;
    if (error == 0 && std::rename(draft.c_str(), path.c_str()) != 0) error = errno;
    if (error != 0) ::unlink(draft.c_str());
    ::close(file);
    if (error != 0) refuse(path, error);
    return true;
}

fs::path temporary_files() {
    std::error_code missing;
    const fs::path folder = fs::temp_directory_path(missing);
    if (!missing) return folder;
    const char *const named = std::getenv("TMPDIR");
    throw UserError{"there's no folder " + std::string{named != nullptr ? named : "/tmp"}
                    + " for temporary files: set TMPDIR to one that's there, and yours"};
}

Scratch::Scratch(const fs::path &beginning) {
    std::string name = beginning.string() + ".XXXXXX";
    if (::mkdtemp(name.data()) != nullptr) folder = name;
    else error = errno;
}

Scratch::~Scratch() {
    std::error_code ignored;
    fs::remove_all(folder, ignored);
}

} // namespace course
