// StudentProcess in a page: no process, but an instance of the module that the reader's file became. The page makes it, calls it,
// counts its branches, and throws it away.

#include "judge/runner/student_process.hpp"

#include <cstring>

#define FROM_PAGE(name) __attribute__((import_module("student"), import_name(name)))

extern "C" {
FROM_PAGE("start") void student_start();
/// Sends a message; without one, waits for the greeting.
/// @return the bytes of the answer, which student_take takes; or -1 - a Silence
FROM_PAGE("call") int student_call(const void *message, std::size_t size, double seconds);
FROM_PAGE("take") void student_take(void *to);
FROM_PAGE("spent") double student_spent();
FROM_PAGE("finish") int student_finish(); ///< a wait status
FROM_PAGE("printed") std::size_t student_printed(void *to, std::size_t most);
}

namespace course {

namespace {
std::string message; ///< a call that waits for its answer
} // namespace

AnonymousFile::AnonymousFile() = default;
Sandbox::Sandbox(const AllowedPaths &, Protection) {}

StudentProcess::StudentProcess(const std::filesystem::path &, const std::string &, Protection) { student_start(); }
StudentProcess::~StudentProcess() = default;

bool StudentProcess::send(std::uint32_t number, std::uint32_t exercise, std::string_view arguments, const Deadline &) {
    message = wire::call_frame(number, exercise, arguments);
    return true;
}

std::optional<StudentProcess::Received> StudentProcess::receive(const Deadline &deadline) {
    const int size = student_call(message.data(), message.size(), deadline.spent);
    message.clear();
    if (size < 0) {
        silence = static_cast<Silence>(-1 - size);
        return {};
    }
    std::string bytes(static_cast<std::size_t>(size), '\0');
    student_take(bytes.data());
    Received received;
    if (bytes.size() < sizeof received.header) {
        silence = Silence::nonsense;
        return {};
    }
    std::memcpy(&received.header, bytes.data(), sizeof received.header);
    if (received.header.size > wire::largest_frame) {
        silence = Silence::too_large;
        return {};
    }
    received.payload = bytes.substr(sizeof received.header);
    return received;
}

std::optional<int> StudentProcess::finish(const Deadline &) { return student_finish(); }
double StudentProcess::spent() const { return student_spent(); }
double StudentProcess::computed() const { return spent(); }
bool StudentProcess::said_more() { return false; }
bool StudentProcess::left_processes() { return false; }

std::string StudentProcess::printed() const {
    std::string text(print_limit, '\0');
    text.resize(student_printed(text.data(), text.size()));
    return text;
}

} // namespace course
