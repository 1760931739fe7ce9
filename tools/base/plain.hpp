#pragma once
// Text that a compiler, a linker or a student's program has printed, made safe to read and to show.

#include "base/lines.hpp"

#include <string>
#include <string_view>

namespace course {

/// Bytes of the well-formed UTF-8 character that `text` begins with; 0 if it is none.
inline std::size_t utf8_length(std::string_view text) {
    const auto byte = static_cast<unsigned char>(text.front());
    const std::size_t length = byte < 0x80                   ? 1
                               : byte >= 0xC2 && byte < 0xE0 ? 2
                               : byte >= 0xE0 && byte < 0xF0 ? 3
                               : byte >= 0xF0 && byte < 0xF5 ? 4
                                                             : 0;
    if (length == 0 || length > text.size()) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((static_cast<unsigned char>(text[i]) & 0xC0) != 0x80) return 0;
    if (length < 3) return length;
    const auto second = static_cast<unsigned char>(text[1]);
    const bool longer_than_needed = (byte == 0xE0 && second < 0xA0) || (byte == 0xF0 && second < 0x90);
    const bool no_character = (byte == 0xED && second >= 0xA0) || (byte == 0xF4 && second >= 0x90);
    return longer_than_needed || no_character ? 0 : length;
}

/// Whether this character changes the direction of writing: then a reader sees other code than the compiler does.
inline bool turns_text(std::string_view character) {
    constexpr std::string_view marks = "\u061C\u200E\u200F\u202A\u202B\u202C\u202D\u202E\u2066\u2067\u2068\u2069";
    return character.size() > 1 && marks.find(character) != marks.npos;
}

/// A line of at most `most` characters, with `…` where it was cut. A tab becomes a blank; control characters, marks of
/// direction and bytes that are not UTF-8 become question marks, so that no line moves a cursor, sets a colour, runs
/// backwards or breaks an XML file.
inline std::string plain_line(std::string_view line, std::size_t most) {
    std::string text;
    for (std::size_t characters = 0; !line.empty(); ++characters) {
        if (characters == most) return text + "…";
        const std::size_t length = utf8_length(line);
        const auto second = length > 1 ? static_cast<unsigned char>(line[1]) : 0;
        const bool control = (length == 1 && (static_cast<unsigned char>(line[0]) < 0x20 || line[0] == 0x7F))
                             || (length == 2 && line[0] == '\xC2' && second < 0xA0);
        const bool not_in_xml = length == 3 && line[0] == '\xEF' && second == 0xBF // U+FFFE and U+FFFF
                                && static_cast<unsigned char>(line[2]) >= 0xBE;
        if (line.front() == '\t') text += ' ';
        else if (length == 0 || control || not_in_xml || turns_text(line.substr(0, length))) text += '?';
        else text += line.substr(0, length);
        line.remove_prefix(length == 0 ? 1 : length);
    }
    return text;
}

/// Everything a compiler or linker printed, each line plain and at most 5000 characters long. What reads it may rely on
/// that: a student's file chooses the words of an #error and the length of a symbol.
inline std::string sanitize(std::string_view printed) {
    constexpr std::size_t longest_line = 5000;
    std::string text;
    for (const Line &line : split_lines(printed)) text += plain_line(line.text, longest_line) + '\n';
    return text;
}

} // namespace course
