#pragma once
// What a compiler can't tell of a file: which function lacks a bracket, or what's gone from around the functions.

#include "check/section_facts.hpp"
#include "judge/protocol/verdict.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace course {

/// Why a file doesn't compile, if it's because of what stands around its code: marks of a web page, curly quotes, the
/// header or the namespace that's gone, or brackets, quotes and comments that don't end where they should.
/// @param stopped  the line in which the compiler did: if that's the very place, its own words are as good
std::optional<Verdict> diagnose_outline(std::string_view text, const std::string &shown_name, const SectionFacts &facts,
                                        int stopped);

} // namespace course
