#include "figures/demo_picture.hpp"

#include "ground/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <sstream>
#include <vector>

namespace course {
namespace {

constexpr double picture_width = 640; // [px]

// As chapters/demo.hpp has them, in its order; `line` is a faint `dim`.
enum class ShapeKind { discs, line, area, arrow, words, handle };
constexpr std::array<const char *, 9> light_colours{"#1d2430", "#66707f", "#66707f", "#2563eb", "#d9480f",
                                                    "#0b8562", "#a16207", "#7c3aed", "#c02672"};
constexpr std::size_t faint_colour = 2;

struct Spot {
    double x, y;
};

/// A row as tools/play/host/frame.hpp writes it.
class DemoRow {
  public:
    explicit DemoRow(const std::string &line) {
        std::istringstream words{line};
        for (std::string word; words >> word;) numbers.push_back(std::strtod(word.c_str(), nullptr));
    }

    double number() {
        if (at == numbers.size()) throw std::out_of_range{"the row is too short"};
        return numbers[at++];
    }
    std::size_t count() { return static_cast<std::size_t>(number()); }
    Spot place() {
        const double x = number();
        return {x, number()};
    }
    std::string text() {
        std::string words(count(), ' ');
        for (char &c : words) c = static_cast<char>(static_cast<unsigned char>(number()));
        return words;
    }

  private:
    std::vector<double> numbers;
    std::size_t at = 0;
};

struct DrawnShape {
    ShapeKind kind;
    std::size_t colour;
    double size, strength;
    std::vector<Spot> places; // [px], y down
    std::string words;
};

/// From the demo's world to the picture.
struct DemoView {
    Spot low, high;
    double scale() const { return picture_width / (high.x - low.x); }
    double height() const { return scale() * (high.y - low.y); }
    Spot onto(const Spot &p) const { return {scale() * (p.x - low.x), scale() * (high.y - p.y)}; }
};

DrawnShape read_shape(DemoRow &row, const DemoView &frame) {
    DrawnShape shape{static_cast<ShapeKind>(row.count()), row.count(), row.number(), row.number(), {}, {}};
    for (std::size_t left = row.count(); left > 0; --left) shape.places.push_back(frame.onto(row.place()));
    shape.words = row.text();
    return shape;
}

/// A number with one digit after the point; never "-0.0".
std::string digits(double x) { return fmt::format("{:.1f}", std::round(10 * x) / 10 + 0.0); }

std::string outline_of(const std::vector<Spot> &places) {
    std::string data;
    for (const Spot &p : places) data += (data.empty() ? "M" : "L") + digits(p.x) + ' ' + digits(p.y);
    return data;
}

/// Each disc is a line without a length, whose round ends are the disc.
std::string dots_of(const std::vector<Spot> &places) {
    std::string data;
    for (const Spot &p : places) data += 'M' + digits(p.x) + ' ' + digits(p.y) + "h0";
    return data;
}

std::string arrow_of(const std::vector<Spot> &places, double head) {
    const Spot &from = places.at(0), &to = places.at(1);
    const double turn = std::atan2(to.y - from.y, to.x - from.x);
    std::string data = outline_of({from, to});
    for (const double side : {2.6, -2.6})
        data += outline_of({to, {to.x + head * std::cos(turn + side), to.y + head * std::sin(turn + side)}});
    return data;
}

std::string opacity(const char *of, const DrawnShape &shape) {
    const double strength = shape.strength * (shape.colour == faint_colour ? 0.35 : 1);
    return strength < 1 ? fmt::format(" {}-opacity=\"{:.2f}\"", of, strength) : "";
}

std::string stroked(const DrawnShape &shape, const std::string &data, double width) {
    return fmt::format("<path fill=\"none\" stroke=\"{}\"{} stroke-width=\"{}\"{} d=\"{}\"/>\n",
                       light_colours.at(shape.colour), opacity("stroke", shape), digits(width),
                       shape.size < 0 ? " stroke-dasharray=\"1 6\"" : "", data);
}

std::string as_svg(const DrawnShape &shape, double scale) {
    if (shape.places.empty()) return "";
    const double width = shape.size == 0 ? 2 : std::abs(shape.size);
    switch (shape.kind) {
    case ShapeKind::discs: return stroked(shape, dots_of(shape.places), std::max(2 * scale * shape.size, 2.0));
    case ShapeKind::line: return stroked(shape, outline_of(shape.places), width);
    case ShapeKind::arrow: return stroked(shape, arrow_of(shape.places, 5 + 2 * shape.size), width);
    case ShapeKind::area:
        return fmt::format("<path fill=\"{}\"{} d=\"{}Z\"/>\n", light_colours.at(shape.colour), opacity("fill", shape),
                           outline_of(shape.places));
    case ShapeKind::words:
        return fmt::format("<text fill=\"{}\" x=\"{}\" y=\"{}\">{}</text>\n", light_colours.at(shape.colour),
                           digits(shape.places[0].x), digits(shape.places[0].y), escaped(shape.words));
    case ShapeKind::handle: return "";
    }
    throw std::out_of_range{"a shape of a kind that is not known"};
}

} // namespace

std::string demo_picture(const std::string &printed, const Colours &colours, const std::string &name) try {
    std::istringstream lines{printed};
    std::string first, second;
    std::getline(lines, first);
    std::getline(lines, second);
    DemoRow about{first}, seen{second};
    const std::string title = about.text();
    const Spot low = about.place();
    const DemoView frame{low, about.place()};
    std::string svg = fmt::format(
        "<svg width=\"{0}\" height=\"{1:.0f}\" viewBox=\"0 0 {0} {1:.0f}\" xmlns=\"http://www.w3.org/2000/svg\" "
        "stroke-linecap=\"round\" stroke-linejoin=\"round\" font-family=\"Inter,Segoe UI,Helvetica,Arial,sans-serif\" "
        "font-size=\"16\">\n<title/>\n",
        picture_width, frame.height());
    for (std::size_t left = seen.count(); left > 0; --left) svg += as_svg(read_shape(seen, frame), frame.scale());
    return recoloured(svg + "</svg>", title, colours, name);
} catch (const std::out_of_range &) {
    throw FigureFault{name + ": its program has not written a picture"};
}

bool show_the_same(std::string_view one, std::string_view other) {
    std::size_t i = 0, j = 0;
    while (i < one.size() && j < other.size()) {
        if (!is_digit(one[i]) || !is_digit(other[j])) {
            if (one[i++] != other[j++]) return false;
            continue;
        }
        char *end_i = nullptr, *end_j = nullptr;
        const std::string a{one.substr(i, 20)}, b{other.substr(j, 20)};
        if (std::abs(std::strtod(a.c_str(), &end_i) - std::strtod(b.c_str(), &end_j)) > 0.11) return false;
        i += static_cast<std::size_t>(end_i - a.c_str());
        j += static_cast<std::size_t>(end_j - b.c_str());
    }
    return i == one.size() && j == other.size();
}

} // namespace course
