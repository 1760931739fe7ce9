// Exceptions in WebAssembly: the part of the C++ ABI (itanium-cxx-abi.github.io/cxx-abi/abi-eh.html) that code compiled with
// -fwasm-exceptions calls, and that the C++ libraries for WASI lack, since these are built without exceptions. An exception
// that nobody catches leaves the module; std::exception_ptr and uncaught_exceptions() are not there.

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <type_traits>
#include <typeinfo>

namespace {

/// As the library's own types of types: its third function of its own says whether a catch takes what was thrown.
struct CatchType : std::type_info {
    virtual void unused_1() const;
    virtual void unused_2() const;
    virtual bool can_catch(const CatchType *thrown, void *&object) const = 0;
};

/// Before each object that is thrown.
struct alignas(16) Thrown {
    const std::type_info *type;
    void *(*destroy)(void *); ///< in WebAssembly a destructor returns `this`
    void *as_caught;          ///< the object, as the base class that the handler names
    int handlers;             ///< that are running; negative while it is thrown on
    Thrown *outer;            ///< the one that was caught before it
};
Thrown *caught = nullptr;

Thrown *header_of(void *object) { return static_cast<Thrown *>(object) - 1; }

/// A number of the tables, in groups of seven bits.
template <class Number> Number take_number(const std::uint8_t *&at) {
    std::uint64_t value = 0;
    unsigned shift = 0;
    std::uint8_t byte = 0;
    do {
        byte = *at++;
        value |= std::uint64_t{byte & 0x7fu} << shift;
        shift += 7;
    } while (byte & 0x80);
    if (std::is_signed_v<Number> && (byte & 0x40)) value |= ~std::uint64_t{0} << shift;
    return static_cast<Number>(value);
}

/// What a landing pad does with an exception.
struct Handler {
    int selector = 0; ///< which of its catches; 0: it only cleans up
    void *object = nullptr;
};

/// The types that a landing pad names end here, and are counted backwards; 0 is `catch (...)`.
Handler find_handler(const std::uint8_t *action, const CatchType *const *end_of_types, Thrown &thrown) {
    for (;;) {
        const auto filter = take_number<std::int32_t>(action);
        if (filter > 0) {
            const CatchType *type = end_of_types[-filter];
            void *object = &thrown + 1;
            if (type == nullptr || type->can_catch(static_cast<const CatchType *>(thrown.type), object))
                return {filter, object};
        }
        const std::uint8_t *next = action;
        const auto offset = take_number<std::int32_t>(next);
        if (offset == 0) return {};
        action += offset;
    }
}

} // namespace

extern "C" {

/// What a landing pad and the compiler's code around it tell each other.
struct LandingPad {
    std::uintptr_t index;        ///< of the pad in its function
    const std::uint8_t *tables;  ///< of that function: the "language-specific data area"
    std::uintptr_t selector = 0; ///< the answer
} __wasm_lpad_context;

int __gxx_wasm_personality_v0(...) { return 0; } // only its name is needed

void *__cxa_allocate_exception(std::size_t size) {
    void *room = std::aligned_alloc(alignof(Thrown), (sizeof(Thrown) + size + 15) / 16 * 16);
    if (room == nullptr) std::abort();
    std::memset(room, 0, sizeof(Thrown));
    return static_cast<Thrown *>(room) + 1;
}

void __cxa_free_exception(void *object) { std::free(header_of(object)); }

[[noreturn]] void __cxa_throw(void *object, std::type_info *type, void *(*destroy)(void *)) {
    Thrown &thrown = *header_of(object);
    thrown.type = type;
    thrown.destroy = destroy;
    thrown.as_caught = object;
    __builtin_wasm_throw(0, object);
}

void *__cxa_begin_catch(void *object) noexcept {
    Thrown &thrown = *header_of(object);
    if (thrown.handlers < 0) thrown.handlers = -thrown.handlers; // it had been thrown on, and stayed in the chain
    else if (thrown.handlers == 0) {
        thrown.outer = caught;
        caught = &thrown;
    }
    ++thrown.handlers;
    return thrown.as_caught;
}

void __cxa_end_catch() {
    Thrown *thrown = caught;
    if (thrown == nullptr) return;
    const bool thrown_on = thrown->handlers < 0;
    thrown->handlers += thrown_on ? 1 : -1;
    if (thrown->handlers != 0) return;
    caught = thrown->outer;
    if (thrown_on) return;
    if (thrown->destroy != nullptr) thrown->destroy(thrown + 1);
    std::free(thrown);
}

[[noreturn]] void __cxa_rethrow() {
    if (caught == nullptr) std::abort();
    caught->handlers = -caught->handlers;
    __builtin_wasm_throw(0, caught + 1);
}

void *__cxa_get_exception_ptr(void *object) noexcept { return header_of(object)->as_caught; }

std::type_info *__cxa_current_exception_type() {
    return caught == nullptr ? nullptr : const_cast<std::type_info *>(caught->type);
}

/// Called at the start of each landing pad. The value that it returns is not looked at.
int _Unwind_CallPersonality(void *object) {
    LandingPad &pad = __wasm_lpad_context;
    pad.selector = 0;
    const std::uint8_t *at = pad.tables;
    if (at == nullptr) return 0;
    constexpr std::uint8_t omitted = 0xff;
    ++at; // where landing pads are counted from: always omitted
    const std::uint8_t *types = nullptr;
    if (*at++ != omitted) {
        const auto offset = take_number<std::uint32_t>(at);
        types = at + offset;
    }
    ++at; // how the numbers of the next table are written: always as here
    const auto size = take_number<std::uint32_t>(at);
    const std::uint8_t *const actions = at + size;
    for (std::uintptr_t index = 0; at < actions; ++index) {
        take_number<std::uint32_t>(at); // the pad
        const auto action = take_number<std::uint32_t>(at);
        if (index != pad.index) continue;
        if (action == 0) return 0;
        const Handler handler =
            find_handler(actions + action - 1, reinterpret_cast<const CatchType *const *>(types), *header_of(object));
        if (handler.selector != 0) header_of(object)->as_caught = handler.object;
        pad.selector = static_cast<std::uintptr_t>(handler.selector);
        return 0;
    }
    return 0;
}

void _Unwind_DeleteException(void *) {}
}

// The library's own abort where there is no memory.

void *operator new(std::size_t size) {
    void *const room = std::malloc(size == 0 ? 1 : size);
    if (room == nullptr) throw std::bad_alloc{};
    return room;
}

void *operator new(std::size_t size, std::align_val_t alignment) {
    const auto multiple = static_cast<std::size_t>(alignment);
    void *const room = std::aligned_alloc(multiple, (size + multiple - 1) / multiple * multiple);
    if (room == nullptr) throw std::bad_alloc{};
    return room;
}

void operator delete(void *room) noexcept { std::free(room); }
void operator delete(void *room, std::size_t) noexcept { std::free(room); }
void operator delete(void *room, std::align_val_t) noexcept { std::free(room); }
void operator delete(void *room, std::size_t, std::align_val_t) noexcept { std::free(room); }
