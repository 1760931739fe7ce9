#pragma once
// Values as bytes, both ways. The reader trusts nothing: every length is checked against the bytes that are there.

#include "course.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace course::wire {

template <class T> inline constexpr bool always_false = false;
template <class T> inline constexpr bool is_optional = false;
template <class T> inline constexpr bool is_optional<std::optional<T>> = true;
template <class T> inline constexpr bool is_vector = false;
template <class T> inline constexpr bool is_vector<std::vector<T>> = true;

/// A struct of a section, which names the fields by COURSE_FIELDS.
template <class T>
concept Fields = requires {
    T::field_names;
};

/// How large a struct of these parts is.
template <class... Parts> constexpr std::size_t size_with() {
    std::size_t end = 0, widest = 1;
    const auto pad = [&](std::size_t align) { end = (end + align - 1) / align * align; };
    ((pad(alignof(Parts)), end += sizeof(Parts), widest = std::max(widest, alignof(Parts))), ...);
    pad(widest);
    return end;
}

/// The part of a struct that COURSE_FIELDS names is all of it: a field forgotten there would never cross.
template <Fields T>
constexpr bool names_all_fields = sizeof(T) == decltype(std::declval<T &>().fields([]<class... Parts>(Parts &...) {
                                      return std::integral_constant<std::size_t, size_with<Parts...>()>{};
                                  }))::value;

class Writer {
  public:
    std::string bytes;

    void raw(const void *data, std::size_t size) { bytes.append(static_cast<const char *>(data), size); }

    template <class T> void put(const T &value) {
        if constexpr (std::is_same_v<T, bool>) {
            bytes.push_back(value ? 1 : 0);
        } else if constexpr (std::is_same_v<T, int> || std::is_same_v<T, double> || std::is_same_v<T, std::uint32_t>) {
            raw(&value, sizeof value);
        } else if constexpr (std::is_same_v<T, Eigen::Vector2d>) {
            raw(value.data(), 2 * sizeof(double));
        } else if constexpr (std::is_same_v<T, std::string> || std::is_same_v<T, std::string_view>) {
            put(static_cast<std::uint32_t>(value.size()));
            raw(value.data(), value.size());
        } else if constexpr (is_optional<T>) {
            put(value.has_value());
            if (value) put(*value);
        } else if constexpr (is_vector<T>) {
            put(static_cast<std::uint32_t>(value.size()));
            bytes.reserve(bytes.size() + value.size() * sizeof(typename T::value_type));
            for (const auto &element : value) put(element);
        } else if constexpr (Fields<T>) {
            static_assert(names_all_fields<T>, "COURSE_FIELDS must name every field, in the order of declaration");
            value.fields([this](const auto &...field) { (this->put(field), ...); });
        } else {
            static_assert(always_false<T>,
                          "this type cannot cross: bool, int, double, Vec2, std::optional, std::vector, "
                          "or a struct with COURSE_FIELDS");
        }
    }
};

/// [bytes] of a frame, and of the lists in it once they're unpacked: an empty place in a pool takes 1 there, and 64 here.
/// The longest answer and arguments of our tests have 9 and 4 million.
constexpr std::uint32_t largest_frame = 16u << 20;

/// Reads what Writer wrote. After the first byte that is wrong or not there, ok() is false and values are meaningless.
class Reader {
  public:
    explicit Reader(std::string_view bytes_) : bytes{bytes_} {}

    bool ok() const { return good; }
    bool finished() const { return good && bytes.empty(); } ///< all is read, and there was no more
    bool too_large() const { return full; }                 ///< that is what's wrong

    void raw(void *data, std::size_t size) {
        if (size > bytes.size()) good = false;
        if (!good) return;
        std::memcpy(data, bytes.data(), size);
        bytes.remove_prefix(size);
    }

    template <class T> T take() {
        T value{};
        if constexpr (std::is_same_v<T, bool>) {
            unsigned char byte = 0;
            raw(&byte, 1);
            good = good && byte <= 1;
            value = byte == 1;
        } else if constexpr (std::is_same_v<T, int> || std::is_same_v<T, double> || std::is_same_v<T, std::uint32_t>) {
            raw(&value, sizeof value);
        } else if constexpr (std::is_same_v<T, Eigen::Vector2d>) {
            raw(value.data(), 2 * sizeof(double));
        } else if constexpr (std::is_same_v<T, std::string>) {
            const auto size = take<std::uint32_t>();
            if (size > bytes.size()) good = false;
            if (!good) return value;
            value.resize(size);
            raw(value.data(), size);
        } else if constexpr (is_optional<T>) {
            if (take<bool>() && good) value = take<typename T::value_type>();
        } else if constexpr (is_vector<T>) {
            const auto size = take<std::uint32_t>();
            if (size > bytes.size()) good = false; // an element is a byte at least
            else if (size > room / sizeof(typename T::value_type)) good = false, full = true;
            if (!good) return value;
            room -= size * sizeof(typename T::value_type);
            value.reserve(size);
            for (std::uint32_t i = 0; i < size && good; ++i) value.push_back(take<typename T::value_type>());
        } else if constexpr (Fields<T>) {
            value.fields([this]<class... Parts>(Parts &...field) { ((field = this->template take<Parts>()), ...); });
        } else {
            static_assert(always_false<T>, "this type cannot cross");
        }
        return value;
    }

  private:
    std::string_view bytes;
    std::size_t room = largest_frame;
    bool good = true, full = false;
};

/// What a frame from the student's process says; a call to it is a frame as well.
enum class Frame : std::uint32_t {
    hello = 0x46624630, ///< the server is up; carries the number of exercises it serves
    call,               ///< to it: exercise, arguments
    result,             ///< the value
    not_yet,            ///< NotYet: where to begin, and in which function
    missing,            ///< the function is not in the student's file
    refused,            ///< std::invalid_argument: what()
    threw,              ///< anything else: type, what()
    no_memory,          ///< std::bad_alloc
    crashed,            ///< about to die by a signal: a Crash, and the address
};

enum class Crash : std::uint32_t { memory, full_stack, floating_trap };

struct Header {
    Frame frame{};
    std::uint32_t call = 0; ///< number of the call that this is, or answers
    std::uint32_t size = 0; ///< bytes that follow
};

/// A call of an exercise, the first, second, ... of a student's process, as it goes there.
inline std::string call_frame(std::uint32_t number, std::uint32_t exercise, std::string_view arguments) {
    const Header header{Frame::call, number, static_cast<std::uint32_t>(sizeof exercise + arguments.size())};
    Writer frame;
    frame.bytes.reserve(sizeof header + header.size);
    frame.raw(&header, sizeof header);
    frame.put(exercise);
    frame.bytes += arguments;
    return std::move(frame.bytes);
}

/// What has been read from a pipe at once, which is more than was asked for, and has not been taken yet.
class Arrived {
  public:
    std::array<char, 64 << 10> room; ///< for a read: a pipe holds no more at a time

    void came(std::size_t bytes) { rest = {room.data(), bytes}; }
    bool empty() const { return rest.empty(); }

    /// Moves what is here of so many bytes to a place, and says in both what is still missing.
    /// @return whether nothing is
    bool take(char *&into, std::size_t &size) {
        const std::size_t here = std::min(size, rest.size());
        into = std::copy_n(rest.begin(), here, into);
        rest.remove_prefix(here);
        size -= here;
        return size == 0;
    }

  private:
    std::string_view rest;
};

constexpr int request_fd = 3;    ///< where the server reads calls
constexpr int reply_fd = 4;      ///< where it answers
constexpr int pipe_is_gone = 97; ///< the exit code, if it cannot answer any more

} // namespace course::wire
