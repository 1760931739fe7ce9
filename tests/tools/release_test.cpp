// `course dev release`: what is in its archives, and what it's not made of.

#include "commands/commands.hpp"
#include "small_course.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

using namespace course;
using Catch::Matchers::ContainsSubstring;

namespace {

/// A small course in a repository, all of it committed, with a site that's built already.
struct Repository : SmallCourse {
    Repository() {
        write("CMakeLists.txt", "project(x VERSION 1.2.3)\n");
        write("CHANGELOG.md", "# Changes\n\n## 1.2.3\n\n- All of it.\n");
        write("demos/07_wall_meeting.svg", "<svg/>\n");
        write("demos/07_wall_meeting.js", "\n");
        write(".gitignore", "/build/\n");
        write("build/default/site/index.html", "<p>\n");
        git({"init", "--quiet"});
        commit();
        write("bin/cmake", "#!/bin/sh\n[ \"$1\" = --build ] || exec /usr/bin/cmake \"$@\"\n");
        std::filesystem::permissions(workspace.root / "bin/cmake", std::filesystem::perms::owner_all);
        commit();
        ::setenv("PATH", ((workspace.root / "bin").string() + ":" + before).c_str(), 1);
    }
    ~Repository() { ::setenv("PATH", before.c_str(), 1); }

    std::string listed(const std::string &archive) const {
        return run({"/usr/bin/cmake", "-E", "tar", "tf", (workspace.build / "release" / archive).string()}).out;
    }
    std::string before = std::getenv("PATH");
};

} // namespace

TEST_CASE("a release has the sources, the site and the stills, and its version in their names") {
    const Repository repository;
    release(repository.workspace, false);
    const std::string sources = repository.listed("frame-by-frame-1.2.3.tar.gz");
    CHECK_THAT(sources, ContainsSubstring("frame-by-frame-1.2.3/solutions/07_wall_meeting.cpp\n"));
    CHECK_THAT(sources, !ContainsSubstring("build/default"));
    CHECK(repository.listed("frame-by-frame-1.2.3-site.zip") == "site/\nsite/index.html\n");
    CHECK(repository.listed("frame-by-frame-1.2.3-stills.zip") == "demos/07_wall_meeting.svg\n");
    const Finished summed =
        run({"sha256sum", "--check", "--strict", "SHA256SUMS"}, {.folder = repository.workspace.build / "release"});
    CHECK(summed.out
          == "frame-by-frame-1.2.3.tar.gz: OK\nframe-by-frame-1.2.3-site.zip: OK\n"
             "frame-by-frame-1.2.3-stills.zip: OK\n");
}

TEST_CASE("a release of which CHANGELOG says nothing, or with a change that isn't committed, is refused") {
    const Repository repository;
    repository.write("solutions/07_wall_meeting.cpp", "// changed\n");
    CHECK_THROWS_WITH(release(repository.workspace, false), ContainsSubstring(" M solutions/07_wall"));
    repository.write("CMakeLists.txt", "project(x VERSION 1.2.4)\n");
    repository.commit();
    CHECK_THROWS_WITH(release(repository.workspace, false), ContainsSubstring("\"## 1.2.4\""));
    CHECK_FALSE(repository.has("build/default/release"));
}
