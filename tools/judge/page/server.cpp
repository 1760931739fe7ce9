// Beside a reader's code in a page: what judge/server/server.cpp is in a process. The page writes a call into room(), has it
// answered, and reads the reply.

#include "judge/server/calls.hpp"

#define TO_PAGE(name) __attribute__((export_name("course_" name)))

namespace {

std::string request, reply;

void write_all(const char *data, std::size_t size) { reply.assign(data, size); } // a frame comes in one
[[noreturn]] void leave(int) { __builtin_trap(); }

} // namespace

extern "C" {

TO_PAGE("room") char *course_room(std::size_t size) {
    request.resize(size);
    return request.data();
}

TO_PAGE("greet") void course_greet() {
    Reply hello;
    hello.put(exercises);
    hello.send(wire::Frame::hello);
}

TO_PAGE("answer") void course_answer() {
    Header header;
    std::memcpy(&header, request.data(), sizeof header);
    call_number = header.call;
    make_call(request.substr(sizeof header));
}

TO_PAGE("reply") const char *course_reply() { return reply.data(); }
TO_PAGE("reply_size") std::size_t course_reply_size() { return reply.size(); }
}
