#include "check/picture.hpp"

#include "base/text.hpp"
#include "check/marks.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>

namespace course {
namespace {

using Box = Eigen::AlignedBox2d;
using Kind = Mark::Kind;
using Role = Mark::Role;

constexpr double width = 480, height = 300, longest_arrow = 85; // [px]

const char *class_of(Role role) {
    constexpr const char *names[] = {"given", "yours", "right", "expected", "unjudged"};
    return names[static_cast<int>(role)];
}

/// "yours", "expected velocity", "velocity".
std::string words_of(const Mark &mark) {
    if (!mark.named) return {};
    if (mark.role != Role::yours && mark.role != Role::expected) return mark.label;
    const std::string who = class_of(mark.role);
    return who + (mark.label.empty() ? "" : " ") + mark.label;
}

std::size_t letters(const std::string &text) {
    return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

/// Words at the side of what they name, where they cover as little as can be.
class Labels {
  public:
    /// Something is drawn along here.
    void avoid(const Vec2 &from, const Vec2 &to) {
        const int steps = std::max(1, static_cast<int>((to - from).norm() / 8));
        for (int i = 0; i <= steps; ++i) drawn.push_back(from + double(i) / steps * (to - from));
    }
    void add(const std::string &words, const Vec2 &at, Role role) {
        if (!words.empty()) wanted.push_back({words, at, role});
    }
    /// When all is drawn.
    std::string text() const {
        std::string all;
        std::vector<Box> taken;
        for (const Label &label : wanted) {
            const Box box = best_place(label, taken);
            taken.push_back(box);
            all += fmt::format("<text class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", class_of(label.role),
                               box.min().x(), box.max().y() - 4, escaped(label.words));
        }
        return all;
    }

  private:
    struct Label {
        std::string words;
        Vec2 at;
        Role role;
    };

    Box best_place(const Label &label, const std::vector<Box> &taken) const {
        const Vec2 size{7.6 * double(letters(label.words)), 16};
        const Box canvas{Vec2{2, 2}, Vec2{width - 2, height - 2}};
        Box best;
        std::ptrdiff_t least = 1 << 20;
        for (const double far : {8.0, 20.0})
            for (const Vec2 &side : {Vec2{1, 0}, {-1, 0}, {0, -1}, {0, 1}, {1, 1}, {1, -1}, {-1, 1}, {-1, -1}}) {
                const Vec2 middle = label.at + side.cwiseProduct(size / 2) + far * side.normalized();
                const Box box{middle - size / 2, middle + size / 2};
                const std::ptrdiff_t cost =
                    std::ranges::count_if(drawn, [&](const Vec2 &each) { return box.contains(each); })
                    + 20 * std::ranges::count_if(taken, [&](const Box &other) { return other.intersects(box); })
                    + (canvas.contains(box) ? 0 : 100);
                if (cost < least) best = box, least = cost;
            }
        return best;
    }

    std::vector<Label> wanted;
    std::vector<Vec2> drawn;
};

/// How the plane lies in the picture.
class Plane {
  public:
    explicit Plane(const std::vector<Mark> &marks) {
        Box box = around(marks, false);
        if (box.isEmpty()) box = around(marks, true);
        else { // an answer that is far out stays at the edge, so that the rest can be seen
            const double near = 2 * std::max(box.sizes().maxCoeff(), 1e-9);
            Box reach{box.min() - Vec2{near, near}, box.max() + Vec2{near, near}};
            const Box all = around(marks, true);
            if (box.sizes().maxCoeff() > 0) box.extend(all.intersection(reach));
            else box.extend(all);
        }
        const bool has_arrows = std::ranges::any_of(marks, [](const Mark &each) { return each.kind == Kind::arrow; });
        const double margin = has_arrows ? longest_arrow : 50;
        const Vec2 room{width - 2 * margin, height - 2 * margin};
        if (!box.isEmpty()) {
            middle = box.center();
            const Vec2 size = box.sizes().cwiseMax(1e-12);
            scale = std::min(room.x() / size.x(), room.y() / size.y());
            if (box.sizes().maxCoeff() <= 0) scale = 1;
        }
        for (const Mark &mark : marks) {
            if (mark.kind != Kind::arrow) continue;
            double &longest = mark.role == Role::yours ? longest_yours[mark.unit] : longest_other[mark.unit];
            longest = std::max(longest, mark.at[1].norm());
        }
    }

    Vec2 to_pixels(const Vec2 &at) const {
        const Vec2 away = scale * (at - middle);
        return Vec2{width / 2 + away.x(), height / 2 - away.y()}.cwiseMax(6).cwiseMin(Vec2{width - 6, height - 6});
    }
    double pixels(double length) const { return scale * length; }
    /// An arrow is as long as others of its unit say, but for an answer that is far too long.
    Vec2 tip(const Mark &arrow) const {
        const double longest =
            longest_of(longest_other, arrow) > 0 ? longest_of(longest_other, arrow) : longest_of(longest_yours, arrow);
        Vec2 along = longest > 0 ? Vec2{longest_arrow / longest * arrow.at[1]} : Vec2{0, 0};
        if (along.norm() > 1.3 * longest_arrow) along *= 1.3 * longest_arrow / along.norm();
        return to_pixels(arrow.at[0]) + Vec2{along.x(), -along.y()};
    }

  private:
    using ByUnit = std::map<std::string, double>;

    static double longest_of(const ByUnit &lengths, const Mark &arrow) {
        const auto length = lengths.find(arrow.unit);
        return length == lengths.end() ? 0 : length->second;
    }
    static Box around(const std::vector<Mark> &marks, bool with_yours) {
        Box box;
        for (const Mark &mark : marks) {
            if (mark.kind == Kind::number || (mark.role == Role::yours && !with_yours)) continue;
            const std::size_t places = mark.kind == Kind::arrow ? 1 : mark.at.size();
            const Vec2 size{mark.radius, mark.radius};
            for (std::size_t i = 0; i < places; ++i) box.extend(Box{mark.at[i] - size, mark.at[i] + size});
        }
        return box;
    }

    Vec2 middle{0, 0};
    double scale = 1;
    ByUnit longest_other, longest_yours;
};

std::string head_of(const Vec2 &from, const Vec2 &to, const char *role) {
    const Vec2 along = (to - from).normalized(), side{-along.y(), along.x()};
    const Vec2 left = to - 10 * along + 4.5 * side, right = to - 10 * along - 4.5 * side;
    return fmt::format("<path class=\"{} head\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}Z\"/>\n", role, to.x(),
                       to.y(), left.x(), left.y(), right.x(), right.y());
}

std::string draw(const Mark &mark, const Plane &plane, Labels &labels) {
    const char *role = class_of(mark.role);
    std::vector<Vec2> at;
    for (const Vec2 &each : mark.at) at.push_back(plane.to_pixels(each));
    if (mark.kind == Kind::arrow) at[1] = plane.tip(mark);
    const auto circle = [&](double radius, const char *more = "") {
        return fmt::format("<circle class=\"{}{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\"/>\n", role, more, at[0].x(),
                           at[0].y(), radius);
    };
    const auto path = [&] {
        std::string text;
        for (std::size_t i = 0; i < at.size(); ++i) {
            text += fmt::format("{}{:.1f} {:.1f}", i == 0 ? "M" : "L", at[i].x(), at[i].y());
            if (i > 0) labels.avoid(at[i - 1], at[i]);
        }
        return fmt::format("<path class=\"{}\" d=\"{}\"/>\n", role, text);
    };
    switch (mark.kind) {
    case Kind::point:
        labels.avoid(at[0], at[0]);
        labels.add(words_of(mark), at[0], mark.role);
        return circle(mark.role == Role::expected ? 7.5 : 4.5, " dot"); // a ring around what is right
    case Kind::circle: {
        const double radius = std::max(plane.pixels(mark.radius), 3.0);
        labels.add(words_of(mark), at[0] + Vec2{0, radius}, mark.role);
        return circle(radius);
    }
    case Kind::box: {
        const Vec2 low = at[0].cwiseMin(at[1]), high = at[0].cwiseMax(at[1]), size = high - low;
        labels.add(words_of(mark), high, mark.role);
        for (const Vec2 &corner : {low, high}) {
            labels.avoid(corner, {low.x(), high.y()});
            labels.avoid(corner, {high.x(), low.y()});
        }
        return fmt::format("<rect class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>\n", role,
                           low.x(), low.y(), size.x(), size.y());
    }
    case Kind::arrow:
        if ((at[1] - at[0]).norm() < 1) { // 0 has no direction
            labels.add(words_of(mark) + " 0", at[0], mark.role);
            return circle(7);
        }
        labels.add(words_of(mark), at[1], mark.role);
        return path() + head_of(at[0], at[1], role);
    case Kind::line: labels.add(words_of(mark), at.back(), mark.role); return path();
    case Kind::number: break;
    }
    return {};
}

std::string opened(double high) {
    return fmt::format(
        "<svg class=\"verdict-picture\" xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
        "viewBox=\"0 0 {0} {1}\" role=\"img\" aria-label=\"the call, your answer and the expected one\">\n",
        width, high);
}

bool is_far(const std::vector<Mark> &marks, const Plane &plane) {
    return std::ranges::any_of(marks, [&](const Mark &mark) {
        const Vec2 at = mark.kind == Kind::number ? Vec2{9, 9} : plane.to_pixels(mark.at[0]);
        return mark.role == Role::yours && (at.x() <= 6 || at.y() <= 6 || at.x() >= width - 6 || at.y() >= height - 6);
    });
}

std::string draw_plane(const std::vector<Mark> &marks) {
    const Plane plane{marks};
    Labels labels;
    std::string picture =
        opened(height)
        + "<path class=\"axis\" d=\"M14 262V286H38\"/>\n"
          "<text class=\"axis\" x=\"42\" y=\"291\">x</text><text class=\"axis\" x=\"10\" y=\"256\">y</text>\n";
    for (const Mark &mark : marks) picture += draw(mark, plane, labels);
    picture += labels.text();
    const auto any = [&](Role role) { return std::ranges::count(marks, role, &Mark::role) > 0; };
    const std::string trouble = is_far(marks, plane)                       ? "yours is far out"
                                : any(Role::expected) && !any(Role::yours) ? "yours has no place here"
                                                                           : "";
    if (!trouble.empty())
        picture +=
            fmt::format("<text class=\"yours\" x=\"{}\" y=\"291\" text-anchor=\"end\">{}</text>\n", width - 8, trouble);
    return picture + "</svg>\n";
}

/// Bars to the right and the left of 0.
std::string draw_bars(const std::vector<Mark> &numbers) {
    constexpr double row = 26, most = 85, zero = 310; // [px]
    double largest = 0;
    for (const Mark &mark : numbers)
        if (mark.role != Role::yours) largest = std::max(largest, std::abs(mark.at[0].x()));
    const double high = row * double(numbers.size()) + 16;
    std::string picture = opened(high) + fmt::format("<path class=\"axis\" d=\"M{0} 4V{1:.0f}\"/>\n", zero, high - 4);
    double y = 8;
    for (const Mark &mark : numbers) {
        const double part = largest > 0 ? mark.at[0].x() / largest : std::copysign(1.5, mark.at[0].x()),
                     length = most * std::clamp(part, -1.3, 1.3);
        const char *role = class_of(mark.role);
        picture += fmt::format("<rect class=\"{} bar\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{}\"/>\n",
                               role, zero + std::min(0.0, length), y + 4, std::max(std::abs(length), 1.0), row - 10);
        const bool left = length < 0;
        picture += fmt::format("<text class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\"{}>{:.4g} {}</text>\n", role,
                               zero + length + (left ? -6 : 6), y + 17, left ? " text-anchor=\"end\"" : "",
                               mark.at[0].x(), escaped(mark.unit));
        picture +=
            fmt::format("<text class=\"{}\" x=\"8\" y=\"{:.1f}\">{}</text>\n", role, y + 17, escaped(words_of(mark)));
        y += row;
    }
    return picture + "</svg>\n";
}

bool is_number(const Mark &mark) { return mark.kind == Kind::number; }
bool is_given(const Mark &mark) { return mark.role == Role::given; }

/// Of the units that both the arguments and the answer have.
std::vector<Mark> comparable(const std::vector<Mark> &numbers) {
    const auto has = [&](const std::string &unit, bool given) {
        return !unit.empty() && std::ranges::any_of(numbers, [&](const Mark &mark) {
            return mark.unit == unit && is_given(mark) == given;
        });
    };
    std::vector<Mark> some;
    std::ranges::copy_if(numbers, std::back_inserter(some),
                         [&](const Mark &mark) { return has(mark.unit, true) && has(mark.unit, false); });
    return some;
}

/// Whether what differs can be seen; or, where the answer itself has no place in the plane, what it is about.
bool tells_something(const std::vector<Mark> &marks, const std::vector<Mark> &numbers) {
    const auto any = [&](auto... roles) {
        return std::ranges::any_of(marks, [&](const Mark &mark) { return ((mark.role == roles) || ...); });
    };
    if (any(Role::yours, Role::expected)) return true;
    if (any(Role::right, Role::unjudged)) return false;
    constexpr std::size_t enough = 3; // two balls, or a velocity and two places
    const bool is_count =
        std::ranges::any_of(numbers, [](const Mark &mark) { return !is_given(mark) && mark.unit.empty(); });
    return (marks.size() >= enough && !is_count) || std::ranges::any_of(marks, [](const Mark &mark) {
               return mark.kind == Kind::line || mark.kind == Kind::box || mark.kind == Kind::circle;
           });
}

} // namespace

std::optional<std::string> picture_of(const Verdict &verdict) {
    if (verdict.kind == Outcome::not_started || verdict.kind == Outcome::missing) return {}; // no input is to blame
    std::vector<Mark> marks = marks_of(verdict), numbers;
    std::ranges::copy_if(marks, std::back_inserter(numbers), is_number);
    std::erase_if(marks, is_number);
    constexpr std::ptrdiff_t most_words = 14, most_bars = 10; // and all can still be read
    if (tells_something(marks, numbers) && std::ranges::count_if(marks, &Mark::named) <= most_words)
        return draw_plane(marks);
    numbers = comparable(numbers);
    if (!marks.empty() || numbers.empty() || std::ssize(numbers) > most_bars) return {};
    return draw_bars(numbers);
}

std::string style_of_pictures() {
    return R"(.verdict-picture { max-width: 100%; height: auto; color-scheme: light dark; font: 14px Inter, "Segoe UI", Helvetica, Arial, sans-serif;
  --ink: light-dark(#1d2430, #e3e8f0); --dim: light-dark(#66707f, #97a2b3); --yours: light-dark(#d9480f, #ff9c66);
  --expected: light-dark(#2563eb, #6ea8fe); --right: light-dark(#0b8562, #3ddca0) }
.verdict-picture :is(path, circle, rect) { fill: none; stroke: var(--role); stroke-width: 2.2; stroke-linejoin: round; stroke-linecap: round }
.verdict-picture text { fill: var(--role); stroke: Canvas; stroke-width: 3; paint-order: stroke }
.verdict-picture .given { --role: var(--ink) }
.verdict-picture .yours { --role: var(--yours) }
.verdict-picture .right { --role: var(--right) }
.verdict-picture .unjudged { --role: color-mix(in srgb, var(--yours) 60%, Canvas) }
.verdict-picture .expected { --role: var(--expected); stroke-dasharray: 6 5 }
.verdict-picture .expected.dot { stroke-dasharray: 4 3 }
.verdict-picture text.expected, .verdict-picture .head { stroke-dasharray: none }
.verdict-picture .axis { --role: var(--dim); stroke-width: 1 }
.verdict-picture :is(.dot, .head, .bar):not(.expected), .verdict-picture .expected.head { fill: var(--role) }
)";
}

} // namespace course
