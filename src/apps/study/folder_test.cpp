#include "apps/study/folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/io/image.h"
#include "nacre/testing/files.h"

namespace nacre::study {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;

class StudyFolder : public ::testing::Test {
 protected:
    /// What the lock says; "locked" where it succeeds.
    static std::string complaint(const fs::path& folder) {
        try {
            const FolderLock lock(folder);
        } catch (const InputError& error) {
            return error.what();
        }
        return "locked";
    }

    test::TempFolder folder_;
};

TEST_F(StudyFolder, IsLockedWhileTheLockLives) {
    const fs::path folder = folder_ / "made" / "for-it";
    {
        const FolderLock lock(folder);
        EXPECT_THAT(complaint(folder), AllOf(HasSubstr(folder.string()), HasSubstr("process"),
                                             HasSubstr(std::to_string(::getpid()))));
        EXPECT_EQ(complaint(folder_), "locked") << "another folder";
    }
    EXPECT_EQ(complaint(folder), "locked");
}

TEST_F(StudyFolder, IsFreeAgainWhenAProcessDiesThatHadIt) {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    const pid_t child = ::fork();
    if (child == 0) {
        auto* lock = new FolderLock(folder_);
        (void)!::write(ends[1], lock, 1);
        for (;;) ::pause();
    }
    char byte;
    ASSERT_EQ(::read(ends[0], &byte, 1), 1);
    EXPECT_THAT(complaint(folder_), HasSubstr(std::to_string(child)));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    EXPECT_EQ(complaint(folder_), "locked");
    ::close(ends[0]);
    ::close(ends[1]);
}

TEST_F(StudyFolder, CannotBeWhereAFileIs) {
    const fs::path file = folder_.write("file", "x");
    EXPECT_THAT(complaint(file), HasSubstr(file.string()));
    fs::create_directory(folder_ / "odd");
    fs::create_symlink("/dev/null", folder_ / "odd" / ".lock");
    EXPECT_THAT(complaint(folder_ / "odd"), HasSubstr("cannot use"));
}

TEST_F(StudyFolder, ARecordHoldsForItsOwnFilesOnly) {
    const fs::path record = folder_ / "a.json", exr = folder_ / "a.exr", png = folder_ / "a.png";
    const auto found = [&](const std::string& fingerprint = "made so") {
        return !find_record(record, fingerprint, {exr, png}).is_null();
    };
    const auto make = [&] {
        write_file_atomically(exr, "the light");
        write_file_atomically(png, "the look");
        write_record(record, {{"render_s", 2.5}}, "made so", {exr, png});
    };
    EXPECT_FALSE(found());
    make();
    ASSERT_TRUE(found());
    EXPECT_EQ(find_record(record, "made so", {exr, png}).at("render_s"), 2.5);
    EXPECT_FALSE(found("made otherwise"));
    // Killed between picture and record: the picture of another seed beside the old record.
    write_file_atomically(exr, "the tight");
    EXPECT_FALSE(found());
    make();
    write_file_atomically(png, "the l");
    EXPECT_FALSE(found()) << "cut short";
    make();
    fs::remove(exr);
    EXPECT_FALSE(found()) << "missing";
    make();
    for (const char* damaged :
         {"", "{", "[]", "{\"fingerprint\":3}", "{\"fingerprint\":\"made so\"}",
          "{\"fingerprint\":\"made so\",\"sha256\":[]}"}) {
        write_file_atomically(record, damaged);
        EXPECT_FALSE(found()) << damaged;
    }
}

TEST_F(StudyFolder, KeepsFilesThatNacreDidNotMake) {
    const auto refused = [](const fs::path& file, const fs::path& companion = {}) {
        try {
            check_own(file, companion);
        } catch (const InputError& error) {
            EXPECT_THAT(error.what(), AllOf(HasSubstr("'" + file.string() + "'"),
                                            HasSubstr("Nacre did not make")));
            return true;
        }
        return false;
    };
    io::Image image{1, 1, {{"R", {1}}, {"G", {1}}, {"B", {1}}}, {}};
    for (const char* extension : {".exr", ".png"}) {
        const fs::path file = folder_ / (std::string("a") + extension);
        const auto write = [&] {
            extension == std::string(".exr") ? io::write_exr(file, image)
                                             : io::write_png(file, image);
        };
        EXPECT_FALSE(refused(file)) << "there is none";
        image.metadata.clear();
        write();
        EXPECT_TRUE(refused(file)) << "of another program";
        image.metadata = {{"nacre:study", "flakes"}};
        write();
        EXPECT_FALSE(refused(file));
        // Cut short, it shows by its record only.
        write_file_atomically(file, read_file(file).substr(0, 60));
        EXPECT_TRUE(refused(file));
        const fs::path record = folder_ / "a.json";
        write_file_atomically(record, "{\"mine\": 1}");
        EXPECT_TRUE(refused(file, record));
        EXPECT_TRUE(refused(record));
        write_record(record, {{"title", "a"}}, "made so", {file});
        EXPECT_FALSE(refused(file, record));
        EXPECT_FALSE(refused(record));
    }
    check_page(folder_);
    const fs::path page = folder_ / "index.html", results = folder_ / "results.json";
    write_file_atomically(page, "<html>mine</html>");
    EXPECT_THROW(check_page(folder_), InputError);
    EXPECT_EQ(write_page(folder_, "<html>", {{"study", "flakes"}, {"version", "1"}}), page);
    check_page(folder_);
    write_file_atomically(results, "[]");
    EXPECT_THROW(check_page(folder_), InputError);
    fs::remove(results);
    EXPECT_THROW(check_page(folder_), InputError);
}

}  // namespace
}  // namespace nacre::study
