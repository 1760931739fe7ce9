#include "check/described.hpp"

#include <charconv>
#include <limits>
#include <utility>

namespace course {
namespace {

constexpr std::string_view not_in_units = ",]})"; // what ends a unit, or a word

class DescribedReader {
  public:
    explicit DescribedReader(std::string_view text) : rest{text} {}

    /// @throws NoValue
    Described whole(std::string name) {
        Described value = next(std::move(name));
        if (!rest.empty()) throw NoValue{};
        return value;
    }
    struct NoValue {};

  private:
    Described next(std::string name) {
        Described value{.name = std::move(name)};
        if (skip("(")) {
            value.kind = Described::Kind::vector;
            value.x = number();
            need(", ");
            value.y = number();
            need(")");
            value.unit = unit();
        } else if (skip("[")) {
            value.kind = Described::Kind::list;
            bool is_whole = true;
            for (int i = 0; !skip("]"); ++i) {
                if (i > 0) need(", ");
                if (skip("… ")) is_whole = word().empty(); // "12 in all"
                else value.parts.push_back(next('[' + std::to_string(i) + ']'));
            }
            value.unit = unit();
            if (!is_whole) value.parts.clear();
            for (Described &part : value.parts)
                if (part.unit.empty()) part.unit = value.unit;
        } else if (skip("{")) {
            value.kind = Described::Kind::fields;
            while (!skip("}")) {
                if (!value.parts.empty()) need(", ");
                std::string field{rest.substr(0, rest.find(' '))};
                rest.remove_prefix(field.size());
                need(" ");
                value.parts.push_back(next(std::move(field)));
            }
        } else if (const auto x = try_number()) {
            value.kind = Described::Kind::number;
            value.x = *x;
            value.unit = unit();
        } else word(); // "true", "nothing"
        return value;
    }

    bool skip(std::string_view sign) {
        if (!rest.starts_with(sign)) return false;
        rest.remove_prefix(sign.size());
        return true;
    }
    void need(std::string_view sign) {
        if (!skip(sign)) throw NoValue{};
    }
    std::string word() {
        std::string text{rest.substr(0, rest.find_first_of(not_in_units))};
        if (text.empty()) throw NoValue{};
        rest.remove_prefix(text.size());
        return text;
    }
    std::string unit() { return skip(" ") ? word() : ""; }

    std::optional<double> try_number() {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        if (skip("not a number")) return std::numeric_limits<double>::quiet_NaN();
        if (skip("infinity")) return infinity;
        if (skip("-infinity")) return -infinity;
        double x = 0;
        const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), x);
        if (error != std::errc{}) return {};
        rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
        return x;
    }
    double number() {
        const auto x = try_number();
        if (!x) throw NoValue{};
        return *x;
    }

    std::string_view rest;
};

} // namespace

std::optional<Described> read_described(std::string_view text, std::string name) try {
    return DescribedReader{text}.whole(std::move(name));
} catch (const DescribedReader::NoValue &) {
    return {};
}

} // namespace course
