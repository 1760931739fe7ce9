#include "check/marks.hpp"

#include "check/described.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

namespace course {
namespace {

using Kind = Mark::Kind;

bool is_length(const std::string &unit) { return unit == "m" || unit == "px"; }
bool is_angle(const std::string &unit) { return unit == "rad" || unit == "°"; }
bool is_place(const Described &value) { return value.kind == Described::Kind::vector && is_length(value.unit); }
Vec2 vector_of(const Described &value) { return {value.x, value.y}; }

const Described *part(const Described &value, std::initializer_list<std::string_view> names) {
    if (value.kind != Described::Kind::fields) return nullptr;
    const auto found = std::ranges::find_if(
        value.parts, [&](const Described &each) { return std::ranges::find(names, each.name) != names.end(); });
    return found == value.parts.end() ? nullptr : &*found;
}

/// Where a thing is: a ball, a ship, or a place itself.
std::optional<Vec2> anchor_in(const Described &value) {
    if (is_place(value)) return vector_of(value);
    const Described *at = part(value, {"position", "place", "centre", "point", "origin"});
    if (at != nullptr && is_place(*at)) return vector_of(*at);
    return {};
}

/// A direction, which is as long as all others.
Vec2 direction(const Described &angle) {
    const double radians = angle.unit == "°" ? angle.x * std::numbers::pi / 180 : angle.x;
    return {std::cos(radians), std::sin(radians)};
}

bool is_link(const Described &value) { return part(value, {"length"}) != nullptr && part(value, {"angle"}) != nullptr; }

/// The two links of a robot's arm, and where it stands; its poses are two angles under the same names.
struct Arm {
    double first, second;
    Vec2 base;
};

bool is_pose(const Described &value) {
    const Described *first = part(value, {"first"}), *second = part(value, {"second"});
    return first != nullptr && second != nullptr && is_angle(first->unit) && is_angle(second->unit);
}

std::optional<Arm> arm_in(const Described &value) {
    const Described *first = part(value, {"first"}), *second = part(value, {"second"}),
                    *height = part(value, {"height"});
    if (first == nullptr || second == nullptr || !is_length(first->unit) || !is_length(second->unit)) return {};
    if (first->kind != Described::Kind::number) return {};
    return Arm{first->x, second->x, {0, height == nullptr ? 0 : height->x}};
}

class Collector {
  public:
    std::vector<Mark> marks;

    explicit Collector(const std::optional<Arm> &of_poses) : arm{of_poses} {}

    /// @param from  where arrows begin
    void add(const Described &value, const std::string &path, const std::string &label, const Vec2 &from) {
        using enum Described::Kind;
        if (value.kind == number && is_angle(value.unit))
            put(Kind::arrow, {from, direction(value)}, label, path, "rad");
        else if (value.kind == number) put(Kind::number, {{value.x, 0}}, path.empty() ? label : path, path, value.unit);
        else if (is_place(value)) put(Kind::point, {vector_of(value)}, label, path);
        else if (value.kind == vector) put(Kind::arrow, {from, vector_of(value)}, label, path, value.unit);
        else if (value.kind == list) add_list(value, path, label, from);
        else if (value.kind == fields) add_fields(value, path, label, from);
    }

    /// Links, one after the other, each turned from the one before.
    void add_arm(const std::vector<Described> &links, const std::string &path, const std::string &label,
                 const Vec2 &base) {
        std::vector<Vec2> lengths_and_angles;
        for (const Described &link : links)
            lengths_and_angles.push_back({part(link, {"length"})->x, part(link, {"angle"})->x});
        add_chain(lengths_and_angles, path, label, base);
    }

  private:
    bool put(Kind kind, std::vector<Vec2> at, const std::string &label, const std::string &path,
             const std::string &unit = {}, double radius = 0) {
        if (!std::ranges::all_of(at, [](const Vec2 &each) { return each.allFinite(); })) return false;
        marks.push_back({kind, std::move(at), label, path, unit, radius});
        return true;
    }

    void add_chain(const std::vector<Vec2> &lengths_and_angles, const std::string &path, const std::string &label,
                   Vec2 at) {
        std::vector<Vec2> joints{at};
        double angle = 0;
        for (const Vec2 &link : lengths_and_angles) {
            angle += link.y();
            joints.push_back(at += link.x() * Vec2{std::cos(angle), std::sin(angle)});
        }
        put(Kind::line, std::move(joints), label, path);
    }

    void add_list(const Described &value, const std::string &path, const std::string &label, const Vec2 &from) {
        if (value.parts.empty()) return;
        if (std::ranges::all_of(value.parts, is_link)) return add_arm(value.parts, path, label, from);
        constexpr std::size_t few = 6; // each has room for words of its own
        const bool is_long = value.parts.size() > few;
        const std::size_t before = marks.size();
        for (const Described &each : value.parts) add(each, path + each.name, label + each.name, from);
        if (is_long)
            std::for_each(marks.begin() + std::ptrdiff_t(before), marks.end(), [](Mark &mark) { mark.named = false; });
        if (!std::ranges::all_of(value.parts, is_place)) return;
        std::vector<Vec2> points;
        for (const Described &each : value.parts) points.push_back(vector_of(each));
        if (put(Kind::line, std::move(points), label, path)) marks.back().named = is_long;
    }

    void add_fields(const Described &value, const std::string &path, const std::string &label, const Vec2 &from) {
        if (is_pose(value)) {
            const double first = part(value, {"first"})->x, second = part(value, {"second"})->x;
            if (arm) add_chain({{arm->first, first}, {arm->second, second}}, path, label, arm->base);
            return; // the second angle is from the first link: without an arm, neither says where that points
        }
        const Described *start = part(value, {"start", "low"}), *end = part(value, {"end", "high"}),
                        *radius = part(value, {"radius"});
        if (start != nullptr && end != nullptr && is_place(*start) && is_place(*end)) {
            put(start->name == "low" ? Kind::box : Kind::line, {vector_of(*start), vector_of(*end)}, label, path);
            return;
        }
        const auto anchor = anchor_in(value);
        if (anchor && radius != nullptr) put(Kind::circle, {*anchor}, label, path, {}, radius->x);
        for (const Described &each : value.parts) {
            const bool is_anchor = anchor && is_place(each) && vector_of(each) == *anchor;
            if (is_anchor && radius != nullptr) continue; // the circle shows it
            const std::string inside = (path.empty() ? "" : path + '.') + each.name;
            add(each, inside, is_anchor ? label : each.name, anchor.value_or(from));
        }
    }

    std::optional<Arm> arm;
};

/// A call's arguments, and where the answer's arrows begin.
struct Given {
    std::vector<Described> arguments;
    std::map<std::string, Vec2> anchors; ///< by argument
    Vec2 first = {0, 0};                 ///< of the anchors
    std::optional<Arm> arm = {};

    explicit Given(const Call &call) {
        for (const std::string &argument : call.arguments) {
            const std::size_t equals = argument.find(" = ");
            if (equals == argument.npos) continue;
            if (auto value = read_described(argument.substr(equals + 3), argument.substr(0, equals)))
                arguments.push_back(std::move(*value));
        }
        for (const Described &value : arguments) {
            if (!arm) arm = arm_in(value);
            if (const auto at = anchor_in(value)) {
                if (anchors.empty()) first = *at;
                anchors.emplace(value.name, *at);
            }
        }
    }
    std::vector<Mark> marks() const {
        Collector all{arm};
        std::vector<Described> links;
        for (const Described &value : arguments) {
            if (is_link(value)) links.push_back(value);
            else all.add(value, value.name, value.name, is_angle(value.unit) ? Vec2{0, 0} : first);
        }
        if (!links.empty()) all.add_arm(links, "links", "", first);
        return std::move(all.marks);
    }
    /// An answer whose fields are called as arguments are is about those.
    std::vector<Mark> marks_of_answer(const Described &value) const {
        Collector all{arm};
        const bool by_name =
            value.kind == Described::Kind::fields
            && std::ranges::any_of(value.parts, [&](const Described &each) { return anchors.contains(each.name); });
        if (!by_name) all.add(value, "", "", first);
        else
            for (const Described &each : value.parts) {
                const auto at = anchors.find(each.name);
                all.add(each, each.name, each.name, at == anchors.end() ? first : at->second);
            }
        return std::move(all.marks);
    }
};

/// "[2].x = 3 m" in two: where in the answer, and what.
std::pair<std::string, std::string> split_path(const std::string &text) {
    const std::size_t equals = text.find(" = ");
    if (equals == text.npos) return {"", text};
    return {text.substr(0, equals), text.substr(equals + 3)};
}

bool is_near(const Mark &one, const Mark &other) {
    if (one.kind != other.kind || one.path != other.path || one.at.size() != other.at.size()) return false;
    for (std::size_t i = 0; i < one.at.size(); ++i)
        if ((one.at[i] - other.at[i]).norm() > 1e-6 * std::max(1.0, other.at[i].norm())) return false;
    return true;
}

/// The part of a value at this path: "[2].x"; nothing if there's none.
Described *at_path(Described &value, const std::string &path) {
    if (path.empty()) return &value;
    for (Described &each : value.parts) {
        if (!path.starts_with(each.name)) continue;
        std::string rest = path.substr(each.name.size());
        if (!rest.empty() && rest[0] != '.' && rest[0] != '[') continue;
        if (rest.starts_with('.')) rest.erase(0, 1);
        return at_path(each, rest);
    }
    return nullptr;
}

/// What was expected, with the answer's own values where the verdict doesn't say.
std::optional<Described> expected_by(const Verdict &verdict, const std::optional<Described> &answer) {
    if (!verdict.label.empty()) return {}; // something else was compared
    const auto &[path, text] = split_path(verdict.whole.empty() ? verdict.expected : verdict.whole);
    auto value = read_described(text);
    if (path.empty() || !value || !answer) return path.empty() ? value : std::nullopt;
    Described all = *answer;
    Described *place = at_path(all, path);
    if (place == nullptr) return {};
    value->name = place->name;
    *place = std::move(*value);
    return all;
}

} // namespace

std::vector<Mark> marks_of(const Verdict &verdict) {
    if (!verdict.call) return {};
    const Given given{*verdict.call};
    std::vector<Mark> all = given.marks();
    const auto answer = read_described(verdict.call->answer);
    const auto expected = expected_by(verdict, answer);
    auto yours = answer ? given.marks_of_answer(*answer) : std::vector<Mark>{},
         wanted = expected ? given.marks_of_answer(*expected) : std::vector<Mark>{};
    const bool of_a_part = verdict.whole.empty() && !split_path(verdict.expected).first.empty();
    for (Mark &mark : yours) {
        const bool is_right = std::ranges::any_of(wanted, [&](const Mark &other) { return is_near(mark, other); });
        mark.role = !is_right ? Mark::Role::yours : of_a_part ? Mark::Role::unjudged : Mark::Role::right;
    }
    std::erase_if(wanted, [&](const Mark &mark) {
        return std::ranges::any_of(yours, [&](const Mark &other) { return is_near(other, mark); });
    });
    for (Mark &mark : wanted) mark.role = Mark::Role::expected;
    for (auto *of : {&wanted, &yours}) all.insert(all.end(), of->begin(), of->end());
    return all;
}

} // namespace course
