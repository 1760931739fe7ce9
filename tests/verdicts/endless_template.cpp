// A template that keeps the compiler for hours, and takes its time for each leaf, so that its memory grows slowly.
#include "rest.hpp"

namespace segment_intersection {

template <int N, int M> struct Tree {
    static constexpr int leaves = Tree<N - 1, 2 * M>::leaves + Tree<N - 1, 2 * M + 1>::leaves;
};
constexpr int one(int leaf) {
    int sum = leaf;
    for (int i = 0; i < 1000; ++i) sum = (31 * sum + i) % 1000;
    return sum < 0 ? 2 : 1;
}
template <int M> struct Tree<0, M> { static constexpr int leaves = one(M); };

std::optional<LineIntersection> intersect_lines(const Segment &motion, const Segment &wall) {
    static_cast<void>(Tree<28, 0>::leaves);
    return right_answer(motion, wall);
}

} // namespace segment_intersection
