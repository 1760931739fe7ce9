// What keeps the differences between a solution and its peer: tests/peers/peer.hpp.

#include "../peers/peer.hpp"
#include "base/files.hpp"
#include "own_folder.hpp"

#include <catch2/catch_test_macros.hpp>

namespace {

/// A file of kept differences, and the comparison that is made against it.
struct Kept {
    int compare(double apart, const std::string &what = "a speed [m/s]") const {
        std::string program = "peer", kept = file().string();
        char *arguments[]{program.data(), kept.data()};
        return course::compare_with_peer(
            2, arguments, "Compared with a peer",
            {{what, [=](Dice &) { return apart; }}, {"answers", [](Dice &) { return 0; }}});
    }
    void write(double apart) const {
        ::setenv("COURSE_GOLDEN", "write", 1);
        CHECK(compare(apart) == 0);
        ::unsetenv("COURSE_GOLDEN");
    }
    std::filesystem::path file() const { return folder.path / "07_wall.txt"; }

    course::OwnFolder folder;
};

} // namespace

TEST_CASE("what is kept of a peer is its largest differences, rounded up to two digits", "[peers]") {
    const Kept kept;
    kept.write(1.2301e-14);
    CHECK(course::read_file(kept.file()) == "#> Compared with a peer\n1.3e-14  a speed [m/s]\n0        answers\n");
    CHECK(kept.compare(1.2301e-14) == 0);
}

TEST_CASE("a difference from a peer that is larger than the kept one, less than half of it, or new is red", "[peers]") {
    const Kept kept;
    CHECK(kept.compare(0) == 1); // nothing is kept yet
    kept.write(3);
    CHECK(kept.compare(3) == 0);
    CHECK(kept.compare(1.6) == 0);
    CHECK(kept.compare(3.1) == 1);
    CHECK(kept.compare(1.4) == 1);
    CHECK(kept.compare(std::nan("")) == 1);
    CHECK(kept.compare(3, "another speed [m/s]") == 1);
}
