#pragma once
// What's added to a compiler's words: a table of rules, and what reads it.

#include "check/diagnostic.hpp"

#include <span>
#include <string>

namespace course {

/// What a beginner needs to know beside the words of GCC or Clang, for the slips that are made most, as a sentence of
/// its own; empty if there is nothing to add, or if the slip can only be guessed.
std::string advice(const Diagnostic &diagnostic);

/// A slip, and what to say of it. The first three are regular expressions, and an empty one takes everything; in all of
/// them stand names for what occurs often, as {number}: see advice.cpp.
struct AdviceRule {
    const char *words;      ///< of the compiler, in one form for both: see advice.cpp
    const char *code;       ///< the student's line, without its comment; if this has an @, it's where the caret points
    const char *sentence;   ///< $1 and $2 are what the expressions capture, and a(n) is a or an
    const char *notes = ""; ///< what the compiler adds in further lines
};

/// All of them: the first that fits is the one.
std::span<const AdviceRule> advice_rules();

} // namespace course
