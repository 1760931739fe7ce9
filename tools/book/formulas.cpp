// The formulas of a hint, for a terminal: school maths in plain characters. What it does not know it leaves readable.
#include "book/markdown.hpp"

#include <map>
#include <set>

namespace course {
namespace {

using namespace std::string_view_literals;

const std::map<std::string_view, std::string_view> symbols{
    {"cdot", " · "},       {"times", " × "},      {"pm", " ± "},     {"le", " ≤ "},       {"leq", " ≤ "},
    {"ge", " ≥ "},         {"geq", " ≥ "},        {"ne", " ≠ "},     {"neq", " ≠ "},      {"approx", " ≈ "},
    {"to", " → "},         {"infty", "∞"},        {"in", " ∈ "},     {"dots", "…"},       {"ldots", "…"},
    {"cdots", "…"},        {"circ", "°"},         {"lvert", "|"},    {"rvert", "|"},      {"mid", "|"},
    {"quad", "  "},        {"qquad", "  "},       {"perp", " ⊥ "},   {"parallel", " ∥ "}, {"sum", "∑"},
    {"prime", "'"},        {"partial", "∂"},      {"ll", " ≪ "},     {"gg", " ≫ "},       {"iff", " ⇔ "},
    {"Rightarrow", " ⇒ "}, {"rightarrow", " → "}, {"mapsto", " ↦ "}, {"lVert", "‖"},      {"rVert", "‖"},
    {"alpha", "α"},        {"beta", "β"},         {"gamma", "γ"},    {"delta", "δ"},      {"epsilon", "ε"},
    {"varepsilon", "ε"},   {"theta", "θ"},        {"lambda", "λ"},   {"mu", "μ"},         {"pi", "π"},
    {"rho", "ρ"},          {"sigma", "σ"},        {"tau", "τ"},      {"phi", "φ"},        {"varphi", "φ"},
    {"omega", "ω"},        {"Delta", "Δ"},        {"Sigma", "Σ"},    {"Omega", "Ω"},
};

/// Only their argument matters, or nothing at all: fonts, sizes of brackets.
const std::set<std::string_view> dress{"mathbf", "mathrm", "mathit", "boldsymbol", "text",         "operatorname",
                                       "vec",    "hat",    "left",   "right",      "big",          "Big",
                                       "bigl",   "bigr",   "Bigl",   "Bigr",       "displaystyle", "limits"};

struct Reader {
    std::string_view rest;

    char take() {
        const char c = rest.front();
        rest.remove_prefix(1);
        return c;
    }

    std::string_view letters() {
        std::size_t n = 0;
        while (n < rest.size() && std::isalpha(static_cast<unsigned char>(rest[n]))) ++n;
        const std::string_view name = rest.substr(0, n);
        rest.remove_prefix(n);
        return name;
    }

    /// `{a b}`, or the next character or command.
    std::string argument() {
        while (rest.starts_with(' ')) take();
        if (rest.empty()) return "";
        if (rest.front() != '{') return one();
        take();
        return until('}');
    }

    std::string until(char stop) {
        std::string out;
        while (!rest.empty() && rest.front() != stop) add_next(out);
        if (!rest.empty()) take();
        return out;
    }

    static std::string bracketed(const std::string &part) {
        const bool single = part.find_first_of(" +-*/") == part.npos;
        const bool has_brackets = part.starts_with('(') && part.find(')') == part.size() - 1;
        return single || has_brackets ? part : '(' + part + ')';
    }

    std::string power() {
        const std::string exponent = argument();
        if (exponent == "°" || exponent == "'") return exponent;
        if (exponent.find_first_not_of("-0123456789") != exponent.npos || exponent.empty())
            return '^' + bracketed(exponent);
        constexpr std::string_view raised[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
        std::string power;
        for (const char c : exponent) power += c == '-' ? "⁻" : raised[c - '0'];
        return power;
    }

    std::string command() {
        if (rest.empty()) return "\\";
        const std::string_view name = letters();
        if (name.empty()) { // a single sign: a space, a line's end, or a brace that is meant
            const char sign = take();
            if (sign == '!') return "";
            return ",;: \\"sv.find(sign) != ""sv.npos ? " " : std::string{sign};
        }
        if (name == "frac" || name == "dfrac" || name == "tfrac") {
            const std::string above = argument(), below = argument();
            return above == "1" && below == "2" ? "½" : bracketed(above) + " / " + bracketed(below);
        }
        if (name == "sqrt") return "√" + bracketed(argument());
        if (name == "begin" || name == "end") return argument(), "";
        if (dress.contains(name)) return "";
        const auto symbol = symbols.find(name);
        if (symbol == symbols.end()) return std::string{name}; // `\sin`
        while (rest.starts_with(' ')) take();                  // `\Delta x` is one name
        return std::string{symbol->second};
    }

    /// A name keeps apart from what it follows: `e\sin E` is "e sin E".
    void add_next(std::string &out) {
        const bool is_command = rest.front() == '\\';
        const std::string next = one();
        const bool is_name =
            is_command && next.size() > 1 && std::isalpha(static_cast<unsigned char>(next.front())) != 0;
        const unsigned char before = out.empty() ? ' ' : static_cast<unsigned char>(out.back());
        if (is_name && (std::isalnum(before) != 0 || before >= 0x80)) out += ' ';
        out += next;
    }

    std::string one() {
        const char c = take();
        switch (c) {
        case '\\': return command();
        case '{': return until('}');
        case '^': return power();
        case '_': return '_' + argument();
        case '~':
        case '&': return " ";
        default: return {c};
        }
    }
};

} // namespace

std::string plain_formula(std::string_view tex) {
    Reader reader{tex};
    std::string text;
    while (!reader.rest.empty()) reader.add_next(text);
    std::string tidy; // one space at a time, none at the ends
    for (const char c : text)
        if (c == ' ' || c == '\n' || c == '\r') {
            if (!tidy.empty() && tidy.back() != ' ') tidy += ' ';
        } else tidy += c;
    if (tidy.ends_with(' ')) tidy.pop_back();
    return tidy;
}

} // namespace course
