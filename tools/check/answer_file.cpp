#include "check/answer_file.hpp"

#include "base/errors.hpp"
#include "base/files.hpp"

namespace course {
namespace fs = std::filesystem;
namespace {

constexpr std::uintmax_t largest_answer = 1'000'000; // [bytes] a hundred times a long answer

const char *name_of(fs::file_type type) {
    switch (type) {
    case fs::file_type::directory: return "a folder";
    case fs::file_type::block:
    case fs::file_type::character: return "a device";
    case fs::file_type::fifo: return "a pipe";
    case fs::file_type::socket: return "a socket";
    default: return "no file with text";
    }
}

} // namespace

std::string read_answer(const fs::path &file) {
    std::error_code ignored;
    const fs::file_status status = fs::status(file, ignored);
    if (fs::exists(status) && !fs::is_regular_file(status))
        throw UserError{file.string() + " is " + name_of(status.type()) + ", not a file with answers"};
    if (const auto size = fs::file_size(file, ignored); !ignored && size > largest_answer)
        throw UserError{file.string() + " has " + std::to_string(size / 1000)
                        + " KB, too much for a file with answers: at most " + std::to_string(largest_answer / 1000)
                        + " are read"};
    return read_file(file);
}

} // namespace course
