// A demo in a page, as WebAssembly. What is thrown goes to the page, which ends the call by an exception of JavaScript's. What
// traps ends there, too. Demos of ours are compiled without exceptions, as Debian's C++ library for pages is; a sketch that the
// page itself compiles has them.
#include "calls.hpp"
#include "frame.hpp"

#include <cstdlib>
#include <cstring>
#include <exception>
#include <typeinfo>

#define IMPORT(name) __attribute__((import_module("play"), import_name(#name)))
#define EXPORT(name) __attribute__((export_name(#name)))

extern "C" {
void play_thrown(const char *type, const char *what) IMPORT(thrown); // doesn't return

static void tell_what_is_thrown(void work()) {
#ifdef __wasm_exception_handling__
    try {
        work();
    } catch (const std::exception &error) {
        play_thrown(typeid(error).name(), error.what());
    } catch (int) {
        play_thrown("i", "");
    } catch (...) {
        play_thrown("", "");
    }
#else
    work();
#endif
}

EXPORT(ask_reader) void play_ask_reader() { host::asks_reader = true; } ///< before all else
EXPORT(begin) const double *play_begin() {
    tell_what_is_thrown(host::begin);
    return host::row.data();
}
EXPORT(control) void play_control(int i, double value) { host::in.controls[std::size_t(i)].value = value; }
EXPORT(frame)
const double *play_frame(double dt, int one_step, double x, double y, int inside, int pressed, int down, int handle,
                         int key) {
    demo::Input &in = host::in;
    in.dt = dt, in.one_step = one_step, in.pointer = {x, y}, in.inside = inside, in.pressed = pressed;
    in.down = down, in.handle = handle, in.key = host::key(key);
    tell_what_is_thrown(host::frame);
    return host::row.data();
}

#ifndef __wasm_exception_handling__
// v[7] of a vector of three: "vector:1393: assertion n < size() failed: vector[] index out of bounds\n"
void play_claim_fails(const char *message) {
    static char words[200];
    const char *last = std::strstr(message, " failed: ");
    std::strncpy(words, last ? last + std::strlen(" failed: ") : message, sizeof words - 1);
    words[std::strcspn(words, "\n")] = '\0';
    play_thrown("assert", words);
    __builtin_trap();
}

void *__cxa_allocate_exception(std::size_t size) noexcept { return std::malloc(size + 64); }
void __cxa_free_exception(void *) noexcept {}
[[noreturn]] void __cxa_throw(void *object, std::type_info *type, void (*)(void *)) {
    // Up to std::exception, if it is one: with single inheritance a type's base is the third word that describes it.
    const std::type_info *base = type;
    while (*base != typeid(std::exception)
           && std::strcmp(typeid(*base).name(), "N10__cxxabiv120__si_class_type_infoE") == 0)
        base = reinterpret_cast<const std::type_info *const *>(base)[2];
    play_thrown(type->name(), *base == typeid(std::exception) ? static_cast<std::exception *>(object)->what() : "");
    __builtin_trap();
}
// assert, and Eigen's: without printf.
void __assert_fail(const char *claim, const char *, int, const char *) {
    play_thrown("assert", claim);
    __builtin_trap();
}
#endif
}
