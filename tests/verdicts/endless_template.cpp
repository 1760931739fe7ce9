// A template that keeps the compiler for hours.
#include "rest.hpp"

namespace segment_intersection {

template <int N, int M> struct Tree {
    static constexpr int leaves = Tree<N - 1, 2 * M>::leaves + Tree<N - 1, 2 * M + 1>::leaves;
};
template <int M> struct Tree<0, M> {
    static constexpr int leaves = 1;
};

std::optional<LineIntersection> intersect_lines(const Segment &motion, const Segment &wall) {
    static_cast<void>(Tree<28, 0>::leaves);
    return right_answer(motion, wall);
}

} // namespace segment_intersection
