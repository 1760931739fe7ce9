#include "ground/files.hpp"

#include "ground/complaint.hpp"
#include "ground/process.hpp"

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
        throw Complaint{"cannot read " + path.string() + ": does it exist, and may you read it?"};
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
    std::sort(files.begin(), files.end());
    return files;
}

namespace {

[[noreturn]] void refuse(const fs::path &path, int error) {
    const std::string where = "cannot write " + path.string() + ": ";
    if (error == ENOSPC || error == EDQUOT || error == EFBIG)
        throw MachineTrouble{where + "the disk is full; make some room and try again. The old file is as it was."};
    throw Complaint{where + std::strerror(error) + "; make " + path.parent_path().string()
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

/// What a new file may be opened with, unless the old one says otherwise.
mode_t mode_for(const fs::path &path) {
    struct stat old {};
    if (::stat(path.c_str(), &old) == 0) return old.st_mode & 07777;
    const mode_t mask = ::umask(0);
    ::umask(mask);
    return 0666 & ~mask;
}

/// A draft in the folder of its file, so that renaming is one step. It is locked while we write it; after a kill it is not.
int make_draft(const fs::path &path, std::string &draft) {
    for (;;) {
        draft = path.string() + ".draft-XXXXXX";
        const int file = ::mkostemp(draft.data(), O_CLOEXEC);
        if (file < 0) return file;
        const bool swept = ::flock(file, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
        struct stat is {};
        if (!swept && (::fstat(file, &is) != 0 || is.st_nlink > 0)) return file;
        ::close(file); // another command took it for one that a kill had left
    }
}

/// Removes the drafts of this file that a kill has left.
void sweep_drafts(const fs::path &path) {
    const std::string beginning = path.filename().string() + ".draft-";
    std::error_code ignored;
    for (const auto &entry : fs::directory_iterator{path.parent_path().empty() ? "." : path.parent_path(), ignored}) {
        if (!entry.path().filename().string().starts_with(beginning)) continue;
        const int file = ::open(entry.path().c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
        if (file < 0) continue;
        if (::flock(file, LOCK_EX | LOCK_NB) == 0) ::unlink(entry.path().c_str());
        ::close(file);
    }
}

} // namespace

bool write_file(const fs::path &wanted, std::string_view text) {
    std::error_code ignored;
    fs::path path = wanted;
    for (int links = 0; links < 40 && fs::is_symlink(path, ignored); ++links) // keep the link, write what it names
        path = path.parent_path() / fs::read_symlink(path, ignored);
    if (fs::is_regular_file(path, ignored) && read_file(path) == text) return false;

    std::error_code trouble;
    if (path.has_parent_path()) fs::create_directories(path.parent_path(), trouble);
    if (trouble) refuse(path, trouble.value());

    const Undisturbed by_signals; // Ctrl-C in between would leave the draft lying about
    sweep_drafts(path);
    std::string draft;
    const int file = make_draft(path, draft);
    if (file < 0) refuse(path, errno);
    int error = write_all(file, text);
    if (::fchmod(file, mode_for(path)) != 0 && error == 0) error = errno;
    if (::close(file) != 0 && error == 0) error = errno;
    if (error == 0 && std::rename(draft.c_str(), path.c_str()) != 0) error = errno;
    if (error == 0) return true;
    ::unlink(draft.c_str());
    refuse(path, error);
}

} // namespace course
