#pragma once
// Makes a call in the student's code, and answers with a frame. For what runs beside that code: server.cpp, and the page's. All
// of it is local.

#include "judge/server/missing.hpp"
#include "judge/server/serve.hpp"

#include <cstdio>
#include <cstdlib>
#include <cxxabi.h>
#include <iostream>
#include <new>
#include <typeinfo>

namespace {

namespace wire = course::wire; // name by name: a section has a Frame, too, and tests/answers has both in one file
using wire::Header, wire::Reader, wire::Writer;

/// Defined by whoever includes this.
void write_all(const char *data, std::size_t size);
[[noreturn]] void leave(int code);

std::uint32_t call_number = 0;

/// What is written after the place of a header.
struct Reply : Writer {
    Reply() { bytes.resize(sizeof(Header)); }

    void send(wire::Frame frame) {
        const Header header{frame, call_number, static_cast<std::uint32_t>(bytes.size() - sizeof(Header))};
        std::memcpy(bytes.data(), &header, sizeof header);
        write_all(bytes.data(), bytes.size());
    }
};

void answer(wire::Frame frame, std::string_view first, std::string_view second = {}) {
    Reply words;
    words.put(first);
    words.put(second);
    words.send(frame);
}

/// The name of the exception in flight: `std::out_of_range`, `int`.
std::string thrown_type() {
    const std::type_info *type = abi::__cxa_current_exception_type();
    if (type == nullptr) return "something unknown";
    int status = 0;
    char *name = abi::__cxa_demangle(type->name(), nullptr, nullptr, &status);
    std::string text = status == 0 ? name : type->name();
    std::free(name);
    return text;
}

void make_call(const std::string &request) {
    Reader in{request};
    const auto exercise = in.take<std::uint32_t>();
    if (!in.ok() || exercise >= exercises) leave(wire::pipe_is_gone);
    try {
        Reply result;
        served[exercise](in, result);
        std::cout.flush(); // the student may have taken it off stdio
        result.send(wire::Frame::result);
    } catch (const course::Missing &) {
        answer(wire::Frame::missing, "");
    } catch (const course::NotYet &hint) {
        answer(wire::Frame::not_yet, hint.what(), hint.function);
    } catch (const std::invalid_argument &refusal) {
        answer(wire::Frame::refused, refusal.what());
    } catch (const std::bad_alloc &) {
        answer(wire::Frame::no_memory, "");
    } catch (const std::exception &error) {
        answer(wire::Frame::threw, thrown_type(), error.what());
    } catch (const char *text) {
        answer(wire::Frame::threw, thrown_type(), text);
    } catch (int number) {
        answer(wire::Frame::threw, thrown_type(), std::to_string(number));
    } catch (...) {
        answer(wire::Frame::threw, thrown_type());
    }
}

} // namespace
