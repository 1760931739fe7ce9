#include "files.hpp"

#include <catch2/catch_test_macros.hpp>

#include <regex>

TEST_CASE("the verdict that the README shows is a real one") {
    const std::filesystem::path root = COURSE_ROOT;
    std::string verdict = course::read_file(root / "tests/verdicts/wrong_answer.txt");
    verdict.erase(verdict.find("exit code"));
    const std::string readme =
        std::regex_replace(course::read_file(root / "README.md"), std::regex{R"((see   tests/\w+\.cpp):\d+)"}, "$1:…");
    CHECK(readme.find("$ ./course check 7\n" + verdict + "```") != std::string::npos);
}
