#pragma once
// Numbers without rounding, for tests of what rounding may do.

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstdint>
#include <vector>

namespace course {

/// A whole number times a power of two, however long: as every double is, and so are sums and products of them.
class Exact {
  public:
    explicit Exact(double x) { ///< not of an infinity, nor of NaN
        int exponent = 0;
        const auto whole = std::int64_t(std::ldexp(std::frexp(x, &exponent), 53)); // a double has no more bits
        exponent -= 53;
        lowest = exponent >> 4;
        const int shift = exponent & 15;
        digits = {(whole & 0xffffffff) << shift, 0, (whole >> 32) << shift, 0, 0};
        carry();
    }

    /// -1, 0 or 1.
    int sign() const { return digits.empty() ? 0 : digits.back() < 0 ? -1 : 1; }

    Exact operator-() const {
        Exact result = *this;
        for (std::int64_t &digit : result.digits) digit = -digit;
        result.carry();
        return result;
    }
    friend Exact operator+(const Exact &a, const Exact &b) {
        if (a.lowest > b.lowest) return b + a;
        const std::size_t shift = b.lowest - a.lowest;
        Exact result = a;
        result.digits.resize(std::max(a.digits.size(), shift + b.digits.size()) + 1);
        for (std::size_t i = 0; i < b.digits.size(); ++i) result.digits[shift + i] += b.digits[i];
        result.carry();
        return result;
    }
    friend Exact operator-(const Exact &a, const Exact &b) { return a + -b; }
    friend Exact operator*(const Exact &a, const Exact &b) {
        Exact result{a.lowest + b.lowest, a.digits.size() + b.digits.size()};
        for (std::size_t i = 0; i < a.digits.size(); ++i)
            for (std::size_t k = 0; k < b.digits.size(); ++k) result.digits[i + k] += a.digits[i] * b.digits[k];
        result.carry();
        return result;
    }
    friend Exact abs(const Exact &x) { return x.sign() < 0 ? -x : x; }

    friend std::strong_ordering operator<=>(const Exact &a, const Exact &b) { return (a - b).sign() <=> 0; }
    friend bool operator==(const Exact &a, const Exact &b) { return (a - b).sign() == 0; }

  private:
    Exact(int lowest_, std::size_t size) : lowest{lowest_}, digits(size) {}

    /// Makes every digit 0 to 65535 again, but for a -1 above them in a number below 0; and the last one is not 0.
    void carry() {
        std::int64_t carried = 0;
        for (std::int64_t &digit : digits) {
            carried += digit;
            digit = carried & 0xffff;
            carried >>= 16;
        }
        const int idle = carried < 0 ? 0xffff : 0; // a digit that makes no difference where it is the last
        while (!digits.empty() && digits.back() == idle) digits.pop_back();
        if (carried != 0) digits.push_back(carried); // -1, as all operations leave room enough
    }

    int lowest;                       ///< the power of 65536 that the first digit counts
    std::vector<std::int64_t> digits; ///< and each one 65536 times that of the one before
};

} // namespace course
