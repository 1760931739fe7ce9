// A student's process that does not play by the rules of the wire: COURSE_ANSWER says how. See verdict_test.cpp.

#include "judge/protocol/wire.hpp"

#include <csignal>
#include <cstdlib>
#include <ctime>
#include <unistd.h>

using namespace course::wire;

namespace {

void send(Frame frame, std::uint32_t call, std::uint32_t size, const std::string &payload) {
    const Header header{frame, call, size};
    std::string message(sizeof header, '\0');
    std::memcpy(message.data(), &header, sizeof header);
    message += payload;
    if (::write(reply_fd, message.data(), message.size()) < 0) ::_exit(1);
}

void send(Frame frame, std::uint32_t call, const std::string &payload) {
    send(frame, call, static_cast<std::uint32_t>(payload.size()), payload);
}

std::string bytes_of(double x) {
    Writer writer;
    writer.put(x);
    return writer.bytes;
}

std::uint32_t next_call() {
    Header header;
    if (::read(request_fd, &header, sizeof header) != sizeof header) ::_exit(0);
    std::string arguments(header.size, '\0');
    if (::read(request_fd, arguments.data(), arguments.size()) < 0) ::_exit(0);
    return header.call;
}

} // namespace

int main() {
    const std::string mode = std::getenv("COURSE_ANSWER");
    Writer one;
    one.put(std::uint32_t{1});
    if (mode == "greets_wrongly") send(Frame::hello, 0, "hello");
    if (mode == "greets_with_four_gigabytes") send(Frame::result, 0, 0xFFFFFFFF, "");
    if (mode == "is_mute") ::pause();
    if (mode == "starts_slowly") ::usleep(300'000);
    send(Frame::hello, 0, one.bytes);
    const std::uint32_t call = next_call();
    if (mode == "answers" || mode == "starts_slowly") send(Frame::result, call, bytes_of(2.5));
    if (mode == "answers_another_call") send(Frame::result, call + 1, bytes_of(2.5));
    if (mode == "claims_four_gigabytes") send(Frame::result, call, 0xFFFFFFFF, "");
    if (mode == "sends_half_a_frame") send(Frame::result, call, 8, "1234");
    if (mode == "sends_too_much") send(Frame::result, call, bytes_of(2.5) + "more");
    if (mode == "sends_too_little") send(Frame::result, call, "123");
    if (mode == "sends_no_frame") send(Frame{7}, call, "");
    if (mode == "answers_twice") send(Frame::result, call, bytes_of(2.5)), send(Frame::result, call, bytes_of(2.5));
    if (mode.starts_with("refuses: ")) {
        Writer words;
        words.put(mode.substr(9));
        words.put(std::string{});
        send(Frame::refused, call, words.bytes);
    }
    if (mode == "drips")
        for (const char byte : bytes_of(2.5) + "123456789012")
            ::usleep(200'000), static_cast<void>(::write(reply_fd, &byte, 1) + 1);
    if (mode == "computes_each_time")
        for (std::uint32_t asked = call;; asked = next_call()) {
            for (const auto until = std::clock() + 3 * CLOCKS_PER_SEC / 10; std::clock() < until;) {}
            send(Frame::result, asked, bytes_of(2.5));
        }
    if (mode.starts_with("computes")) { // for a fifth of a second of the processor's time, or for half a second
        while (std::clock() < CLOCKS_PER_SEC / (mode == "computes_for_long" ? 2 : 5)) {}
        send(Frame::result, call, bytes_of(2.5));
    }
    if (mode == "dodges_looks") { // asleep but for when it's looked at, which the clock of whoever looks tells
        const clockid_t clock = (~::getppid() << 3) | 2; // of a process's time, as clock_getcpuclockid makes it
        auto looked = [clock, before = timespec{}]() mutable {
            const timespec was = before;
            ::clock_gettime(clock, &before);
            return was.tv_sec != before.tv_sec || was.tv_nsec != before.tv_nsec;
        };
        for (;;) {
            while (!looked()) {}
            ::usleep(42'000);
            looked();
        }
    }
    if (mode == "dies") ::raise(SIGKILL);
    next_call();
}
