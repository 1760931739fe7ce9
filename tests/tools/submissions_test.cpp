// What a class hands in: found by the platforms' names, and read as if each file came from an enemy.

#include "base/files.hpp"
#include "grade/archive.hpp"
#include "grade/submissions.hpp"
#include "made_zip.hpp"
#include "own_folder.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <cstdlib>
#include <ctime>
#include <fstream>
#include <sys/stat.h>

using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;
using Catch::Matchers::StartsWith;
using namespace course;
namespace fs = std::filesystem;

namespace {

const Section handed_in_for{"05_inclined_planes"};
using Listed = std::vector<std::string>;

/// A folder with one class in it.
struct ClassOfOne : OwnFolder {
    const fs::path zip = path / "class.zip", copies = path / "copies";

    Submissions of(const MadeZip &made) const {
        made.write(zip);
        return read_submissions(zip, handed_in_for, copies);
    }
    Submissions of(const std::vector<std::string> &names) const {
        MadeZip made;
        for (const std::string &name : names) made.file(name, "// " + name);
        return of(made);
    }
    Submissions on_disk(bool wrapped = true) const {
        return read_submissions(path / "class", handed_in_for, copies, {}, wrapped);
    }
    void put(const std::string &name, const std::string &bytes = "int x;\n") const {
        write_file(path / "class" / name, bytes);
    }
};

Listed ids(const Submissions &all) {
    Listed names;
    for (const Submission &each : all.all) names.push_back(each.id);
    return names;
}

/// Writes over what libzip insists on.
void replace_bytes(const fs::path &file, const std::string &old, const std::string &with) {
    std::string bytes = read_file(file);
    bool any = false;
    for (std::size_t at = 0; (at = bytes.find(old, at)) != std::string::npos; at += with.size(), any = true)
        bytes.replace(at, old.size(), with);
    REQUIRE(any);
    write_file(file, bytes);
}

auto complains(const std::string &words) { return MessageMatches(ContainsSubstring(words)); }

} // namespace

TEST_CASE("reads an archive's files, and no more of them than asked for", "[submissions]") {
    const ClassOfOne folder;
    MadeZip{}.file("a/b.cpp", "four").file("c.cpp", "").special("d/", S_IFDIR, "").write(folder.zip);
    const Archive archive{folder.zip};
    REQUIRE(archive.entries().size() == 2);
    CHECK(archive.entries()[0].name == "a/b.cpp");
    CHECK(archive.entries()[0].size == 4);
    CHECK(archive.read(archive.entries()[0], 4) == "four");
    CHECK(archive.read(archive.entries()[1], 4).empty());
    CHECK_THROWS_AS(archive.read(archive.entries()[0], 3), TooLarge);
}

TEST_CASE("says in a sentence that an archive is none, or broken", "[submissions]") {
    const ClassOfOne folder;
    CHECK_THROWS_MATCHES(Archive{folder.zip}, UserError, complains("there is no file"));
    write_file(folder.zip, "no zip");
    CHECK_THROWS_MATCHES(Archive{folder.zip}, UserError, complains("is no zip archive, or only a part of one"));
    MadeZip{}.file("x_1_2_a.cpp", "one").file("x_1_3_b.cpp", "two").write(folder.zip);
    const std::string whole = read_file(folder.zip);
    for (const std::size_t kept : {whole.size() - 1, whole.size() / 2, std::size_t{40}}) {
        write_file(folder.zip, whole.substr(0, kept));
        CHECK_THROWS_MATCHES(Archive{folder.zip}, UserError, complains("download it again"));
    }
    write_file(folder.zip, "");
    CHECK_THROWS_AS(read_submissions(folder.zip, handed_in_for, folder.copies), UserError);
}

TEST_CASE("refuses an archive with too many files", "[submissions]") {
    const ClassOfOne folder;
    MadeZip many;
    for (std::size_t i = 0; i <= most_entries; ++i) many.file("x_1_" + std::to_string(i) + "_a.cpp", "");
    CHECK_THROWS_MATCHES(folder.of(many), UserError, complains("has 20001 files in it"));
    for (std::size_t i = 0; i <= most_entries; ++i) {
        fs::create_directories(folder.path / "class/1");
        std::ofstream{folder.path / "class/1" / std::to_string(i)};
    }
    CHECK_THROWS_MATCHES(folder.on_disk(), UserError, complains("more than 20000 files"));
}

TEST_CASE("reads nothing of links, devices and encrypted files", "[submissions]") {
    const ClassOfOne folder;
    MadeZip{}
        .link("link.cpp", "/etc/passwd")
        .special("pipe.cpp", S_IFIFO, "")
        .special("device.cpp", S_IFCHR, "")
        .special("folder.cpp", S_IFDIR, "")
        .encrypted("locked.cpp")
        .write(folder.zip);
    const Archive archive{folder.zip};
    Listed why;
    for (const Archive::Entry &each : archive.entries()) {
        why.push_back(each.unsafe);
        CHECK_THROWS_MATCHES(archive.read(each, 100), UserError, complains("so it's not read"));
    }
    CHECK(why
          == Listed{"is a link", "is no ordinary file", "is no ordinary file", "is no ordinary file", "is encrypted"});
}

TEST_CASE("touches no name that leads elsewhere, or isn't what it looks like", "[submissions]") {
    CHECK(unsafe_name("a/..b/c...cpp").empty());
    CHECK(unsafe_name("Öz Ærø_7_assignsubmission_file_/ü.cpp").empty());
    CHECK(unsafe_name(std::string(4096, 'a')).empty());
    CHECK(unsafe_name(std::string(4097, 'a')) == "has a name of more than 4096 bytes");
    for (const char *out : {"..", "../a.cpp", "a/../../b.cpp", "a/.."})
        CHECK(unsafe_name(out) == "leads out of its folder");
    CHECK(unsafe_name("/etc/passwd") == "begins at the root of the disk");
    CHECK(unsafe_name("a\\b.cpp") == "has a backslash in its name");
    CHECK(unsafe_name("") == "has no name");
    for (const char *odd : {"a\nb", "a\tb", "\x1b[31m", "a\x7f",
                            "a\xff"
                            "b",
                            "\u202Eppc.a", "a\u2066"})
        CHECK(unsafe_name(odd) == "has a name with characters that can't be shown");
}

TEST_CASE("takes neither of two files whose names are the same, but for capitals", "[submissions]") {
    const ClassOfOne folder;
    MadeZip{}.file("1/a.cpp").file("1/A.cpp").file("1/b.cpp").file("1/c.cpp").write(folder.zip);
    replace_bytes(folder.zip, "1/c.cpp", "1/b.cpp");
    const Archive archive{folder.zip};
    REQUIRE(archive.entries().size() == 4);
    for (const Archive::Entry &each : archive.entries())
        CHECK(each.unsafe == "is there twice, or differs from another only by capitals");
}

TEST_CASE("believes no size, and unpacks no bomb", "[submissions]") {
    const ClassOfOne folder;
    MadeZip made;
    made.zeros("x_1_2_bomb.cpp", 200'000'000).file("x_2_3_broken.cpp", std::string(5000, 'a'));
    made.write(folder.zip);
    std::string bytes = read_file(folder.zip);
    CHECK(bytes.size() < 1'000'000);
    const std::string size{"\x00\xc2\xeb\x0b", 4}, lie{"\x05\x00\x00\x00", 4}; // 200,000,000 and 5
    replace_bytes(folder.zip, size, lie);
    {
        const Archive archive{folder.zip};
        CHECK(archive.entries()[0].size == 5);
        CHECK_THROWS_AS(archive.read(archive.entries()[0], 1'000'000), UserError);
    }
    const Submissions all = folder.of(made);
    CHECK_THAT(all.all.at(0).trouble, StartsWith("Your bomb.cpp is larger than 1 MB"));
    CHECK(all.all.at(0).file.empty());
    CHECK(!fs::exists(folder.copies / "1.cpp"));

    std::string broken = read_file(folder.zip); // a byte in the midst of the second file's packed ones
    broken[broken.find("x_2_3_broken.cpp") + 16 + 4] ^= 0x55;
    write_file(folder.zip, broken);
    fs::remove_all(folder.copies);
    const Submissions rest = read_submissions(folder.zip, handed_in_for, folder.copies);
    REQUIRE(ids(rest) == Listed{"1", "2"}); // nobody else pays for it, and neither does this student
    CHECK(rest.all[1].unread == "x_2_3_broken.cpp can't be unpacked: download the archive again.");
    CHECK(rest.all[1].trouble.empty());
    CHECK(rest.all[1].file.empty());
    CHECK(!fs::exists(folder.copies / "2.cpp"));
}

TEST_CASE("writes an archive with the same bytes each time", "[submissions]") {
    const ClassOfOne folder;
    const std::vector<std::pair<std::string, std::string>> files{{"b_1_2_ü.cpp", "one"}, {"a/feedback.txt", ""}};
    write_archive(folder.path / "one.zip", files);
    ::setenv("TZ", "Asia/Tokyo", 1);
    ::tzset();
    write_archive(folder.path / "two.zip", files);
    ::unsetenv("TZ");
    ::tzset();
    CHECK(read_file(folder.path / "one.zip") == read_file(folder.path / "two.zip"));
    const Archive back{folder.path / "one.zip"};
    REQUIRE(back.entries().size() == 2);
    CHECK(back.entries()[0].name == "b_1_2_ü.cpp");
    CHECK(back.read(back.entries()[0], 10) == "one");
    CHECK(back.read(back.entries()[1], 10).empty());
}

TEST_CASE("tells Canvas' students apart by their numbers", "[submissions]") {
    const ClassOfOne folder;
    const Submissions all = folder.of({
        "amberash_1010_88_05_inclined_planes.cpp",
        "öztürkåsa_LATE_1009_87_05_inclined_planes.cpp",
        "_200_86_05_inclined_planes.cpp",
        "x_y_201_85_05_inclined_planes-1.cpp",
        "anon_202_84_05_inclined_planes (1).cpp",
        "anon_LATE_203_83_my_own_2.cpp",
    });
    CHECK(all.platform == Platform::canvas);
    CHECK(all.left_alone == Listed{});
    REQUIRE(ids(all) == Listed{"200", "201", "202", "203", "1009", "1010"});
    for (const Submission &each : all.all) {
        CHECK(each.trouble.empty());
        CHECK(each.file == folder.copies / (each.id + ".cpp"));
        CHECK(read_file(each.file) == "// " + each.feedback_name);
        CHECK(each.others.empty());
        CHECK(each.late == (each.id == "1009" || each.id == "203"));
    }
    CHECK(all.all[1].taken == "05_inclined_planes-1.cpp");
    CHECK(all.all[2].taken == "05_inclined_planes (1).cpp");
    CHECK(all.all[3].taken == "my_own_2.cpp");
    CHECK(all.all[4].feedback_name == "öztürkåsa_LATE_1009_87_05_inclined_planes.cpp");
}

TEST_CASE("tells anonymous students apart, whose ids are words", "[submissions]") {
    const ClassOfOne folder;
    const Submissions all =
        folder.of({"anon_x7bQz_88_05_inclined_planes.cpp", "LATE_anon_12aBc_7_05_inclined_planes.cpp",
                   "anon_33_9_05_inclined_planes.cpp", "anon_Tee_text.html"});
    CHECK(all.left_alone == Listed{});
    REQUIRE(ids(all) == Listed{"33", "12aBc", "Tee", "x7bQz"});
    CHECK(all.all[1].late);
    CHECK(!all.all[3].late);
    CHECK(all.all[3].taken == "05_inclined_planes.cpp");
    CHECK_THAT(all.all[2].trouble, StartsWith("You typed in a text"));
}

TEST_CASE("counts Canvas' newest upload, and lists older ones", "[submissions]") {
    const ClassOfOne folder;
    const Submissions all = folder.of({
        "a_1_99_05_inclined_planes.cpp",
        "a_1_100_05_inclined_planes-1.cpp",
        "a_1_101_notes.txt",
        "a_1_102_own.cpp",
        "b_2_60_mine.cpp",
        "b_2_70_mine-1.cpp",
        "b_2_71_mine (2)-1.cpp",
    });
    REQUIRE(ids(all) == Listed{"1", "2"});
    CHECK(all.all[0].taken == "05_inclined_planes-1.cpp");
    CHECK(all.all[0].feedback_name == "a_1_100_05_inclined_planes-1.cpp");
    CHECK(all.all[0].others == Listed{"own.cpp", "notes.txt", "05_inclined_planes.cpp (older)"});
    CHECK(all.all[1].taken == "mine (2)-1.cpp");
    CHECK(all.all[1].others == Listed{"mine-1.cpp (older)", "mine.cpp (older)"});
}

TEST_CASE("tells a student why there is no file", "[submissions]") {
    const ClassOfOne folder;
    MadeZip made;
    made.file("a_1_9_work.zip").file("a_1_8_notes.txt");
    made.file("b_2_link.html").file("c_3_text.html");
    made.file("d_4_10_one.cpp").file("d_4_11_two.cpp");
    made.file("e_5_12_05_inclined_planes.cpp", std::string(1'000'001, '/'));
    made.file("f_6_13_05_inclined_planes.cpp", std::string(1'000'000, '/'));
    made.link("g_7_14_05_inclined_planes.cpp", "/etc/passwd").encrypted("h_8_15_05_inclined_planes.cpp");
    made.file("i_9_16_notes.txt").file("i_LATE_10_17_NOTES.CPP");
    const Submissions all = folder.of(made);
    REQUIRE(all.left_alone == Listed{});
    REQUIRE(all.all.size() == 10);
    const Listed begins{
        "You handed in an archive, work.zip: hand in 05_inclined_planes.cpp itself, unpacked.",
        "You handed in a link: hand in the file itself, 05_inclined_planes.cpp.",
        "You typed in a text, but there's no file: hand in 05_inclined_planes.cpp.",
        "You handed in 2 C++ files, but none of them is called 05_inclined_planes.cpp: hand in just that one.",
        "Your 05_inclined_planes.cpp is larger than 1 MB: hand in just your C++ code.",
        "",
        "Your 05_inclined_planes.cpp is a link, so we didn't read it: hand in just the file itself.",
        "Your 05_inclined_planes.cpp is encrypted, so we didn't read it: hand in just the file itself.",
        "You handed in notes.txt, but no .cpp file: hand in 05_inclined_planes.cpp.",
        "",
    };
    for (std::size_t i = 0; i < begins.size(); ++i) {
        CHECK(all.all[i].trouble == begins[i]);
        CHECK(all.all[i].file.empty() == !begins[i].empty());
        CHECK(all.all[i].taken.empty() == !begins[i].empty());
        CHECK(fs::exists(folder.copies / (all.all[i].id + ".cpp")) == begins[i].empty());
    }
    CHECK(all.all[0].feedback_name == "a_1_9_work.zip");
    CHECK(all.all[0].others == Listed{"work.zip", "notes.txt"});
    CHECK(all.all[1].others == Listed{"link.html (a link)"});
    CHECK(all.all[1].feedback_name == "b_2_link.html");
    CHECK(all.all[6].others == Listed{"05_inclined_planes.cpp (is a link)"});
    CHECK(all.all[9].taken == "NOTES.CPP");
}

TEST_CASE("guesses nothing about names that are hard to understand", "[submissions]") {
    const ClassOfOne folder;
    const Submissions all = folder.of({
        "amberash_1010_88_05_inclined_planes.cpp",
        "123_1001_55_05_inclined_planes.cpp",   // a name that is a number
        "x_7_y_1003_88_05_inclined_planes.cpp", // or has one in it
        "anon_x7bQz_88_05_inclined_planes.cpp", // not all are anonymous
        "b_1002_77_05_inclined_planes.cpp",
        "c_1002_78_05_inclined_planes.cpp", // both say they're 1002
        "d_1004_90_",
        "index.html",
        "d_1004.cpp",
    });
    CHECK(ids(all) == Listed{"1010"});
    CHECK(all.left_alone
          == Listed{"123_1001_55_05_inclined_planes.cpp: isn't named as Canvas names what's handed in",
                    "x_7_y_1003_88_05_inclined_planes.cpp: isn't named as Canvas names what's handed in",
                    "anon_x7bQz_88_05_inclined_planes.cpp: isn't named as Canvas names what's handed in",
                    "d_1004_90_: isn't named as Canvas names what's handed in",
                    "index.html: isn't named as Canvas names what's handed in",
                    "d_1004.cpp: isn't named as Canvas names what's handed in",
                    "b_1002_77_05_inclined_planes.cpp: somebody else has the id 1002 too",
                    "c_1002_78_05_inclined_planes.cpp: somebody else has the id 1002 too"});
}

TEST_CASE("goes by what most names look like, and leaves one of another kind alone", "[submissions]") {
    const ClassOfOne folder;
    const Submissions all = folder.of({"1001/f.cpp", "a_1_2_f.cpp", "b_2_3_f.cpp"});
    CHECK(all.platform == Platform::canvas);
    CHECK(ids(all) == Listed{"1", "2"});
    CHECK(all.left_alone == Listed{"1001/f.cpp: isn't named as Canvas names what's handed in"});
    CHECK(ids(folder.of({"1001/f.cpp", "1002/f.cpp", "a_1_2_f.cpp"})) == Listed{"1001", "1002"});
}

TEST_CASE("leaves unsafe names alone, whoever they belong to, and says so", "[submissions]") {
    const ClassOfOne folder;
    const Submissions all = folder.of({"a_1_2_05_inclined_planes.cpp", "../b_2_3_05_inclined_planes.cpp",
                                       "c_3_4_a\\b.cpp", "/e_5_6_f.cpp", "f_6_7_$(id).cpp"});
    CHECK(ids(all) == Listed{"1", "6"});
    CHECK(all.all[1].taken == "$(id).cpp");
    CHECK(all.left_alone
          == Listed{"../b_2_3_05_inclined_planes.cpp: leads out of its folder",
                    "c_3_4_a\\b.cpp: has a backslash in its name", "/e_5_6_f.cpp: begins at the root of the disk"});
    CHECK(std::distance(fs::directory_iterator{folder.path}, fs::directory_iterator{}) == 2); // class.zip and copies
}

TEST_CASE("reads Moodle's folders, old and new, and its flat names", "[submissions]") {
    const ClassOfOne folder;
    const Submissions all = folder.of({
        "Amber Ash_1001_assignsubmission_file_/05_inclined_planes.cpp",
        "Group B-Åsa Öz_1002_assignsubmission_file/sub/dirs/05_inclined_planes.cpp",
        "Birch Bo_1003_assignsubmission_file_05_inclined_planes.cpp",
        "Participant_1004_assignsubmission_file_/my own.cpp",
        "Cedar Cy_1005_assignsubmission_onlinetext_/onlinetext.html",
        "Dahlia Du_1006_assignsubmission_file_/05_inclined_planes.cpp",
        "Dahlia Du_1006_assignsubmission_file_/a/05_inclined_planes (1).cpp",
        "Elm Ed_1007_assignsubmission_file_/__MACOSX/._05_inclined_planes.cpp",
        "Elm Ed_1007_assignsubmission_file_/.DS_Store",
        "Elm Ed_1007_assignsubmission_file_/2_3_x.cpp",
        "Elm Ed_1007_assignsubmission_onlinetext_/onlinetext.html",
    });
    CHECK(all.platform == Platform::moodle);
    CHECK(all.left_alone == Listed{});
    REQUIRE(ids(all) == Listed{"1001", "1002", "1003", "1004", "1005", "1006", "1007"});
    CHECK(all.all[0].taken == "05_inclined_planes.cpp");
    CHECK(all.all[0].feedback_name == "Amber Ash_1001_assignsubmission_file_/feedback.txt");
    CHECK(all.all[1].taken == "sub/dirs/05_inclined_planes.cpp");
    CHECK(all.all[1].feedback_name == "Group B-Åsa Öz_1002_assignsubmission_file/feedback.txt");
    CHECK(all.all[2].taken == "05_inclined_planes.cpp");
    CHECK(all.all[2].feedback_name == "Birch Bo_1003_assignsubmission_file_feedback.txt");
    CHECK(all.all[3].taken == "my own.cpp");
    CHECK_THAT(all.all[4].trouble, StartsWith("You typed in a text"));
    CHECK(all.all[4].others == Listed{"onlinetext.html (typed text)"});
    CHECK(all.all[5].taken == "05_inclined_planes.cpp");
    CHECK(all.all[5].others == Listed{"a/05_inclined_planes (1).cpp (a copy)"});
    CHECK(all.all[6].taken == "2_3_x.cpp");
    CHECK(all.all[6].others == Listed{"onlinetext.html (typed text)"});
    CHECK(!all.all[0].late);
}

TEST_CASE("leaves alone what Moodle wouldn't call so", "[submissions]") {
    const ClassOfOne folder;
    const Submissions all = folder.of({"Amber Ash_1001_assignsubmission_file_/05_inclined_planes.cpp", "notes.txt",
                                       "Bo_x3_assignsubmission_file_f.cpp"});
    CHECK(ids(all) == Listed{"1001"});
    CHECK(all.left_alone
          == Listed{"notes.txt: isn't named as Moodle names what's handed in",
                    "Bo_x3_assignsubmission_file_f.cpp: isn't named as Moodle names what's handed in"});
}

TEST_CASE("reads a folder with a folder for each student, on disk and packed", "[submissions]") {
    const ClassOfOne folder;
    folder.put("1010/05_inclined_planes.cpp", "ten");
    folder.put("9/sub/05_inclined_planes.cpp", "nine");
    folder.put("ann.b-c_d/mine.cpp", "ann");
    folder.put("empty/05_inclined_planes.cpp", "");
    folder.put("-o/05_inclined_planes.cpp");
    folder.put("a b/05_inclined_planes.cpp");
    folder.put("$(id)/05_inclined_planes.cpp");
    folder.put("stray.cpp");
    folder.put(".DS_Store");
    const auto check = [&](const Submissions &all) {
        CHECK(all.platform == Platform::folder);
        REQUIRE(ids(all) == Listed{"9", "1010", "ann.b-c_d", "empty"});
        CHECK(read_file(all.all[0].file) == "nine");
        CHECK(all.all[0].taken == "sub/05_inclined_planes.cpp");
        CHECK(read_file(all.all[1].file) == "ten");
        CHECK(all.all[2].file == folder.copies / "ann.b-c_d.cpp");
        CHECK(read_file(all.all[3].file).empty());
        CHECK(all.all[3].trouble.empty());
        const std::string why = "has an id with other characters than letters, digits, . _ -";
        CHECK(all.left_alone
              == Listed{"$(id)/05_inclined_planes.cpp: " + why, "-o/05_inclined_planes.cpp: " + why,
                        "a b/05_inclined_planes.cpp: " + why, "stray.cpp: is in no student's folder"});
    };
    check(folder.on_disk());
    check(folder.of(MadeZip{}
                        .file("$(id)/05_inclined_planes.cpp")
                        .file("-o/05_inclined_planes.cpp")
                        .file("1010/05_inclined_planes.cpp", "ten")
                        .file("9/sub/05_inclined_planes.cpp", "nine")
                        .file("__MACOSX/9/._x.cpp")
                        .file("a b/05_inclined_planes.cpp")
                        .file("ann.b-c_d/mine.cpp", "ann")
                        .file("empty/05_inclined_planes.cpp", "")
                        .file("stray.cpp")));
}

TEST_CASE("follows no link on disk, and opens no pipe", "[submissions]") {
    const ClassOfOne folder;
    write_file(folder.path / "solution.cpp", "the solution");
    folder.put("1/05_inclined_planes.cpp");
    folder.put("4/05_inclined_planes.cpp", std::string(1'000'001, ' '));
    fs::create_directories(folder.path / "class/2");
    fs::create_symlink(folder.path / "solution.cpp", folder.path / "class/2/05_inclined_planes.cpp");
    fs::create_directories(folder.path / "class/3");
    REQUIRE(::mkfifo((folder.path / "class/3/05_inclined_planes.cpp").c_str(), 0600) == 0);
    fs::create_directory_symlink(folder.path / "class/1", folder.path / "class/5");
    const Submissions all = folder.on_disk();
    REQUIRE(ids(all) == Listed{"1", "2", "3", "4"});
    CHECK(all.all[0].trouble.empty());
    CHECK_THAT(all.all[1].trouble, ContainsSubstring("is a link"));
    CHECK_THAT(all.all[2].trouble, ContainsSubstring("is no ordinary file"));
    CHECK_THAT(all.all[3].trouble, ContainsSubstring("is larger than 1 MB"));
    for (std::size_t i = 1; i < 4; ++i) CHECK(all.all[i].file.empty());
    CHECK(all.left_alone == Listed{"5: is a link"});
}

TEST_CASE("takes no two students for one, whatever the disk makes of capitals", "[submissions]") {
    const ClassOfOne folder;
    folder.put("ann/05_inclined_planes.cpp");
    folder.put("Ann/05_inclined_planes.cpp");
    folder.put("bo/05_inclined_planes.cpp");
    const Submissions all = folder.on_disk();
    CHECK(ids(all) == Listed{"bo"});
    CHECK(all.left_alone.size() == 2);
}

TEST_CASE("lists at most twenty files of a student", "[submissions]") {
    const ClassOfOne folder;
    folder.put("1/05_inclined_planes.cpp");
    folder.put("2/05_inclined_planes.cpp");
    for (int i = 0; i < 30; ++i) folder.put("1/" + std::to_string(i));
    const Submissions all = folder.on_disk();
    CHECK(all.all[0].others.size() == 21);
    CHECK(all.all[0].others.back() == "and more");
}

TEST_CASE("says what it accepts when it's given something else", "[submissions]") {
    const ClassOfOne folder;
    const auto refused = [&](const std::vector<std::string> &names, const std::string &words) {
        CHECK_THROWS_MATCHES(folder.of(names), UserError, complains(words));
        CHECK_THROWS_MATCHES(folder.of(names), UserError,
                             complains("give the zip that Canvas or Moodle lets you download"));
    };
    refused({"a.cpp", "b.txt", "c", "d"}, "isn't what a class hands in");
    refused({"a.cpp", "b.txt", "c", "d"}, "It begins with a.cpp, b.txt, c");
    refused({".DS_Store"}, "is empty");
    refused({"a_1_2_f.cpp", "Amber Ash_1001_assignsubmission_file_/f.cpp"},
            "has a name as from Canvas, a_1_2_f.cpp, and one as from Moodle, Amber");
    refused({"a_1_2_f.cpp", "1001/f.cpp"},
            "has a name as from Canvas, a_1_2_f.cpp, and one as from a folder, 1001/f.cpp");
    refused({"../a_1_2_f.cpp"}, "isn't what a class hands in");
    CHECK_THROWS_MATCHES(folder.of(MadeZip{}.encrypted("a_1_2_f.cpp")), UserError,
                         complains("is encrypted: unpack it"));
    CHECK_THROWS_MATCHES(read_submissions(folder.path / "none", handed_in_for, folder.copies), UserError,
                         complains("there is no file"));
    CHECK(ids(folder.of({"1001/f.cpp"})) == Listed{"1001"});
}

TEST_CASE("takes C++ by other names, where it's clear which file is meant", "[submissions]") {
    const ClassOfOne folder;
    const auto taken = [&](const std::vector<std::string> &names) {
        std::vector<std::string> uploads;
        for (const std::string &name : names)
            uploads.push_back("a_1_" + std::to_string(50 + uploads.size()) + '_' + name);
        const Submissions all = folder.of(uploads);
        REQUIRE(all.all.size() == 1);
        return all.all[0].taken;
    };
    for (const std::string name :
         {"05_inclined_planes.cc", "05_inclined_planes.cxx", "05_inclined_planes.c++", "05_inclined_planes.C",
          "05_inclined_planes.cpp.txt", "05_inclined_planes.txt", "05_inclined_planes", "05_Inclined_Planes (1).cc",
          "mine.cc", "mine.cpp.txt", "mine (1).C"}) {
        CHECK(taken({name}) == name);
        CHECK(taken({name, "05_inclined_planes.cpp"}) == "05_inclined_planes.cpp");
        CHECK(taken({"05_inclined_planes.final.cpp", "05_inclined_planes-1.final.cpp"})
              == "05_inclined_planes-1.final.cpp");
    }
    CHECK(taken({"main.cpp", "05_inclined_planes.cc"}) == "05_inclined_planes.cc");
    CHECK(taken({"helpers.cc", "main.cpp"}) == "main.cpp");
    for (const std::string name : {"mine", "mine.txt", "05_inclined_planes.zip", "05_inclined_planes.docx",
                                   "05_inclined_planes.o", "05_inclined_planes_notes"})
        CHECK(taken({name}).empty());
    CHECK(taken({"05_inclined_planes.cc", "05_inclined_planes.txt"}).empty());
}

TEST_CASE("takes the file that the instructor names, and no other", "[submissions]") {
    const ClassOfOne folder;
    MadeZip{}.file("a_1_2_one.cpp").file("a_1_3_two.cpp").file("a_1_4_work").file("b_2_text.html").write(folder.zip);
    const auto read = [&](const std::map<std::string, std::string> &take) {
        return read_submissions(folder.zip, handed_in_for, folder.copies, take).all[0];
    };
    CHECK_THAT(read({}).trouble, StartsWith("You handed in 2 C++ files"));
    CHECK(read({{"1", "one.cpp"}}).taken == "one.cpp");
    CHECK(read({{"1", "work"}}).feedback_name == "a_1_4_work");
    CHECK(read({{"1", "work"}}).trouble.empty());
    CHECK_THROWS_MATCHES(
        read({{"1", "three.cpp"}}), UserError,
        complains("--take 1=three.cpp means no file of theirs. They handed in work, two.cpp, one.cpp."));
    CHECK_THROWS_MATCHES(read({{"2", "text.html"}}), UserError, complains("means no file of theirs"));
    CHECK_THROWS_MATCHES(read({{"3", "one.cpp"}}), UserError, complains("nobody with that id has handed anything in"));
    folder.put("9/a/05_inclined_planes.cpp", "a");
    folder.put("9/b/05_inclined_planes.cpp", "b");
    CHECK_THAT(folder.on_disk().all[0].trouble, StartsWith("You handed in 2 files called"));
    CHECK(read_file(
              read_submissions(folder.path / "class", handed_in_for, folder.copies, {{"9", "b/05_inclined_planes.cpp"}})
                  .all[0]
                  .file)
          == "b");
}

TEST_CASE("reads UTF-16 that says so, as UTF-8", "[submissions]") {
    const ClassOfOne folder;
    using namespace std::string_literals;
    folder.put("1/05_inclined_planes.cpp", "\xFF\xFEx\0 \0\xFC\0\x3D\xD8\x00\xDE\n\0"s); // little-endian
    folder.put("2/05_inclined_planes.cpp", "\xFE\xFF\0x\0 \0\xFC\xD8\x3D\xDE\x00\0\n"s);
    folder.put("3/05_inclined_planes.cpp", "\xFF\xFEx\0\x3D\xD8"s); // half a character
    folder.put("4/05_inclined_planes.cpp", "\xEF\xBB\xBFx"s);
    const Submissions all = folder.on_disk();
    for (const std::size_t i : {0, 1}) CHECK(read_file(all.all[i].file) == "x \u00FC\U0001F600\n");
    CHECK(read_file(all.all[2].file) == "\xFF\xFEx\0\x3D\xD8"s);
    CHECK(read_file(all.all[3].file) == "\xEF\xBB\xBFx");
}

TEST_CASE("takes names with marks of direction, and with bytes that are no text", "[submissions]") {
    const ClassOfOne folder;
    MadeZip{}
        .file("cohendavid_1003_501_\u200Fמישורים.cpp")
        .file("levidana_1004_502_05_inclined_planes\u200E.cpp")
        .file("d_1005_503_\u202Eppc.cpp")
        .file("e_1006_504_a\tb.cpp")
        .file("f~_1007_505_f.cpp")
        .write(folder.zip);
    replace_bytes(folder.zip, "f~_1007", "f\xF6_1007");
    const Submissions all = read_submissions(folder.zip, handed_in_for, folder.copies);
    CHECK(all.left_alone == Listed{});
    REQUIRE(ids(all) == Listed{"1003", "1004", "1005", "1006", "1007"});
    CHECK(all.all[0].taken == "מישורים.cpp");
    CHECK(all.all[1].feedback_name == "levidana_1004_502_05_inclined_planes.cpp");
    CHECK(all.all[2].taken == "ppc.cpp");
    CHECK(all.all[3].taken == "a b.cpp");
    CHECK(all.all[4].feedback_name == "f?_1007_505_f.cpp");
    CHECK(ids(folder.of({"1/f.cpp", "2/.\u200E./f.cpp", ".\u200E./f.cpp"})) == Listed{"1"});
}

TEST_CASE("reads a download that was packed anew, in a folder", "[submissions]") {
    const ClassOfOne folder;
    const Submissions canvas = folder.of(
        {"HW5 submissions/a_1003_501_05_inclined_planes.cpp", "HW5 submissions/c_1004_502_05_inclined_planes.cpp",
         "HW5 submissions/index.html", "__MACOSX/HW5 submissions/._a_1003_501_05_inclined_planes.cpp"});
    CHECK(canvas.platform == Platform::canvas);
    CHECK(ids(canvas) == Listed{"1003", "1004"});
    CHECK(canvas.all[0].feedback_name == "a_1003_501_05_inclined_planes.cpp");
    const Submissions moodle = folder.of({"m/Amber Ash_1001_assignsubmission_file_/f.cpp"});
    CHECK(moodle.platform == Platform::moodle);
    CHECK(ids(moodle) == Listed{"1001"});
    CHECK(ids(folder.of({"class/1001/f.cpp", "class/1002/f.cpp"})) == Listed{"1001", "1002"});
    CHECK(ids(folder.of({"1001/src/f.cpp"})) == Listed{"1001"});
    CHECK(ids(folder.of({"Amber Ash_1001_assignsubmission_file_/2_3_4_x.cpp"})) == Listed{"1001"});
}

TEST_CASE("of a clone of the course, takes the exercise", "[submissions]") {
    const ClassOfOne folder;
    for (const std::string file :
         {"exercises/05_inclined_planes.cpp", "exercises/04_trajectories.cpp", "tests/05_inclined_planes/tests.cpp",
          "tests/05_inclined_planes/stub.cpp", "build/default/a/b.cpp", "README.md"}) {
        folder.put("ann-b/" + file, file);
        folder.put("bo/" + file, file);
    }
    MadeZip packed;
    for (const std::string file : {"exercises/05_inclined_planes.cpp", "tests/05_inclined_planes/tests.cpp"})
        packed.file("ann-b/" + file, file).file("bo/" + file, file);
    for (const Submissions &all : {folder.on_disk(), folder.of(packed)}) {
        REQUIRE(ids(all) == Listed{"ann-b", "bo"});
        for (const Submission &each : all.all) CHECK(read_file(each.file) == "exercises/05_inclined_planes.cpp");
    }
    CHECK(folder.on_disk().all[0].others == Listed{"README.md", "exercises/04_trajectories.cpp"});
    CHECK(ids(folder.of({"ann-b/exercises/05_inclined_planes.cpp", "ann-b/tests/05_inclined_planes/tests.cpp"}))
          == Listed{"ann-b"});
}

TEST_CASE("tells whose feedback Canvas doesn't hand back as a text", "[submissions]") {
    const ClassOfOne folder;
    const Submissions all = folder.of({"a_1_2_homework5.docx", "b_2_text.html", "c_3_link.html", "d_4_5_f.cpp",
                                       "e_5_6_notes.txt", "f_6_7_f.docx", "f_6_8_f.cc"});
    CHECK(all.all[0].undelivered == "Canvas calls it homework5.docx");
    for (const std::size_t i : {1, 2})
        CHECK(all.all[i].undelivered == "Canvas drops it, for there's no file that it's about");
    for (const std::size_t i : {3, 4, 5}) CHECK(all.all[i].undelivered.empty());
    CHECK(folder.of({"Amber Ash_1001_assignsubmission_file_/f.docx"}).all[0].undelivered.empty());
}

TEST_CASE("one student's folders, however many or deep, keep nobody else's from being read", "[submissions]") {
    const ClassOfOne folder;
    folder.put("ann/05_inclined_planes.cpp", "ann");
    std::string deep = "bo/";
    for (int i = 0; i < 60; ++i) deep += "d/";
    folder.put(deep + "05_inclined_planes.cpp", "bo");
    CHECK(ids(folder.on_disk()) == Listed{"ann", "bo"});
    CHECK(folder.on_disk().all[1].file.empty());
    for (int i = 0; i <= 20'000; ++i) folder.put("cy/" + std::to_string(i), "");
    CHECK_THROWS_WITH(folder.on_disk(), ContainsSubstring("and most of them in cy"));
}

TEST_CASE("a folder in a list of clones is one student's, though its own folders are called as others'",
          "[submissions]") {
    const ClassOfOne folder;
    for (const char *name : {"s5-ann", "s5-bob"})
        folder.put(std::string{"s5-mallory/"} + name + "/05_inclined_planes.cpp", "x");
    CHECK(ids(folder.on_disk()) == Listed{"s5-ann", "s5-bob"});
    CHECK(ids(folder.on_disk(false)) == Listed{"s5-mallory"});
}
