// Numbers without rounding, held against what the processor knows: the order of doubles, and how much it rounded off. The
// peer of section 7 holds them against others' exact numbers.

#include "../dice.hpp"
#include "../exact.hpp"

#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <vector>

using course::Exact;

namespace {

/// Of either sign, from 2^-power to 2^power.
double any_double(Dice &dice, int power) {
    const double first = dice.whole(1 << 26, (1 << 27) - 1), second = dice.whole(0, (1 << 26) - 1); // 53 bits
    return dice.sign() * std::ldexp(std::ldexp(first, 26) + second, dice.whole(-power, power) - 53);
}

} // namespace

TEST_CASE("an exact sum is the rounded one and what was rounded off", "[exact]") {
    Dice dice{1};
    for (int i = 0; i < 20000; ++i) {
        const double a = any_double(dice, 60), b = any_double(dice, 60), sum = a + b;
        // What was rounded off a sum is a double, and this is it (T. J. Dekker, 1971).
        const double off = std::abs(a) > std::abs(b) ? b - (sum - a) : a - (sum - b);
        REQUIRE(Exact{a} + Exact{b} == Exact{sum} + Exact{off});
        REQUIRE(Exact{a} - Exact{sum} == Exact{off} - Exact{b});
        REQUIRE((Exact{a} + Exact{b} <=> Exact{sum}) == (off <=> 0));
    }
}

TEST_CASE("an exact product is the rounded one and what was rounded off", "[exact]") {
    Dice dice{1};
    for (int i = 0; i < 20000; ++i) {
        const double a = any_double(dice, 400), b = any_double(dice, 400), product = a * b;
        const double off = std::fma(a, b, -product);
        REQUIRE(Exact{a} * Exact{b} == Exact{product} + Exact{off});
        REQUIRE((Exact{a} * Exact{b} <=> Exact{product}) == (off <=> 0));
    }
}

TEST_CASE("exact numbers are in the order of their doubles", "[exact]") {
    const double smallest = 0x1p-1074, greatest = 0x1.fffffffffffffp1023;
    const std::vector<double> rising{-greatest, -0x1p1000, -65536, -65535, -1,    -0x1p-1000, -smallest, 0,
                                     smallest,  0x1p-1000, 1,      65535,  65536, 0x1p1000,   greatest};
    for (const double a : rising) {
        CHECK(Exact{a}.sign() == (a > 0) - (a < 0));
        CHECK(abs(Exact{a}) == Exact{std::abs(a)});
        for (const double b : rising) {
            CHECK((Exact{a} <=> Exact{b}) == (a <=> b));
            CHECK((Exact{a} == Exact{b}) == (a == b));
        }
    }
    CHECK(Exact{-0.0} == Exact{0});
}

TEST_CASE("exact numbers have no greatest one, and no smallest", "[exact]") {
    const Exact smallest{0x1p-1074}, greatest{0x1.fffffffffffffp1023};
    CHECK(smallest * greatest == Exact{0x1.fffffffffffffp-51});
    CHECK(smallest * smallest > Exact{0});
    CHECK(smallest * smallest < smallest);
    CHECK(greatest * greatest > greatest);
    CHECK(greatest + smallest > greatest);
    CHECK(greatest + smallest - greatest == smallest);
    CHECK(greatest * smallest * smallest - smallest * (smallest * greatest) == Exact{0});
}
