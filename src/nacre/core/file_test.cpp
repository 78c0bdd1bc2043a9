#include "nacre/core/file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <optional>

#include "nacre/core/error.h"
#include "nacre/core/progress.h"
#include "nacre/testing/files.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

// A folder of its own for each test.
class AtomicFileTest : public testing::Test {
 protected:
    int files() const {
        return static_cast<int>(
            std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
    }

    nacre::test::TempFolder folder_;
};

TEST_F(AtomicFileTest, WritesNewFilesAndReplacesOldOnes) {
    const fs::path path = folder_ / "paint.h5";
    const std::string bytes("a\0b\n", 4);
    write_file_atomically(path, bytes);
    EXPECT_EQ(read_file(path), bytes);
    write_file_atomically(path, "");
    EXPECT_EQ(read_file(path), "");
    EXPECT_EQ(files(), 1);
}

using Temporary = AtomicFile::Temporary;

TEST_F(AtomicFileTest, WithoutCommitTheOldFileStaysAndTheTemporaryGoes) {
    const fs::path path = folder_ / "paint.h5";
    write_file_atomically(path, "old");
    for (const Temporary temporary : {Temporary::unnamed_if_possible, Temporary::named}) {
        {
            AtomicFile file(path, temporary);
            file.write("half of the ne");
            EXPECT_EQ(read_file(path), "old");
            if (temporary == Temporary::named) {
                EXPECT_EQ(files(), 2);
            }
        }
        EXPECT_EQ(read_file(path), "old");
        EXPECT_EQ(files(), 1);
    }
}

TEST_F(AtomicFileTest, BothKindsOfTemporaryReplaceAndMakeFiles) {
    for (const Temporary temporary : {Temporary::unnamed_if_possible, Temporary::named}) {
        for (const char* name : {"new.csv", "old.csv"}) {
            const fs::path path = folder_ / name;
            fs::remove(path);
            if (path.stem() == "old") {
                write_file_atomically(path, "a longer text that was there before");
                ASSERT_EQ(::chmod(path.c_str(), 0640), 0);
            }
            AtomicFile file(path, temporary);
            file.write("a,");
            file.flush();
            file.write("b\n");
            file.commit();
            EXPECT_EQ(read_file(path), "a,b\n");
            if (path.stem() == "old") {
                EXPECT_EQ(fs::status(path).permissions(), fs::perms(0640));
            }
        }
        EXPECT_EQ(files(), 2);
    }
}

/// A child that is killed while it writes `path`.
void write_and_be_killed(const fs::path& path, Temporary temporary) {
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        AtomicFile file(path, temporary);
        file.write("half of the ne");
        ::raise(SIGKILL);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status));
}

TEST_F(AtomicFileTest, AKilledProcessLeavesNothing) {
    const fs::path path = folder_ / "paint.h5";
    {  // such a name, to learn whether the file system has unnamed files
        AtomicFile file(path);
        if (files() > 0) GTEST_SKIP() << "this file system has no unnamed files";
    }
    write_and_be_killed(path, Temporary::unnamed_if_possible);
    EXPECT_EQ(files(), 0);
}

TEST_F(AtomicFileTest, WhatAKilledProcessLeftGoesWithTheNextWriter) {
    const fs::path path = folder_ / "paint.h5";
    write_and_be_killed(path, Temporary::named);
    write_and_be_killed(folder_ / "other.h5", Temporary::named);
    EXPECT_EQ(files(), 2);
    AtomicFile living(path, Temporary::named);  // of this process, which lives
    write_and_be_killed(path, Temporary::named);
    EXPECT_EQ(files(), 3);
    AtomicFile file(path, Temporary::named);
    EXPECT_EQ(files(), 3);  // other.h5's is another's; the two that are being written
    file.write("new");
    file.commit();
    EXPECT_EQ(read_file(path), "new");
}

TEST_F(AtomicFileTest, StopsWithinALargeFile) {
    const fs::path path = folder_ / "table.bsdf";
    write_file_atomically(path, "old");
    std::string large(40'000'000, 'a');
    for (std::size_t i = 0; i < large.size(); i += 1000) large[i] = static_cast<char>(i / 1000);
    for (int last = 1; last < 4; ++last) {
        int calls = 0;
        const auto progress = [&](double) { return ++calls < last; };
        if (last < 3) {
            EXPECT_THROW(write_file_atomically(path, large, progress), Stopped);
            EXPECT_EQ(read_file(path), "old");
        } else {
            write_file_atomically(path, large, progress);
            EXPECT_EQ(read_file(path), large);
        }
        EXPECT_EQ(files(), 1);
    }
}

TEST_F(AtomicFileTest, TwoWritersOfOneNameDoNotMix) {
    const fs::path path = folder_ / "out.exr";
    for (const Temporary temporary : {Temporary::unnamed_if_possible, Temporary::named}) {
        AtomicFile a(path, temporary), b(path, temporary);
        a.write("a");
        b.write("bb");
        a.commit();
        EXPECT_EQ(read_file(path), "a");
        b.commit();
        EXPECT_EQ(read_file(path), "bb");
        EXPECT_EQ(files(), 1);
    }
}

TEST_F(AtomicFileTest, FollowsLinksAndKeepsPermissions) {
    write_file_atomically(folder_ / "real", "old");
    ASSERT_EQ(::chmod((folder_ / "real").c_str(), 0640), 0);
    fs::create_symlink("real", folder_ / "link");
    write_file_atomically(folder_ / "link", "new");
    EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
    EXPECT_EQ(read_file(folder_ / "real"), "new");
    EXPECT_EQ(fs::status(folder_ / "real").permissions(), fs::perms(0640));
}

TEST_F(AtomicFileTest, ADeviceIsWrittenToAndNotReplaced) {
    write_file_atomically("/dev/null", "bytes");
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(AtomicFileTest, RefusesBeforehandWhatItCouldNotReplace) {
    fs::create_symlink("nowhere", folder_ / "dangling");
    write_file_atomically(folder_ / "locked", "old");
    ASSERT_EQ(::chmod((folder_ / "locked").c_str(), 0444), 0);
    fs::create_directory(folder_ / "sealed");
    ASSERT_EQ(::chmod((folder_ / "sealed").c_str(), 0555), 0);
    ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0666), 0);
    const auto refused = [&](const char* name, const char* why) {
        const fs::path path = folder_ / name;
        EXPECT_THAT([&] { check_output_file(path); },
                    ThrowsMessage<InputError>(AllOf(
                        HasSubstr("cannot write '" + path.string() + "': "), HasSubstr(why))));
        EXPECT_THROW(AtomicFile file(path), InputError) << name;
    };
    refused("dangling", "leads nowhere");
    refused("locked", "write-protected");
    refused("sealed/new", "write-protected");
    refused("locked/new", "is no folder");
    refused("none/new", "there is no folder");
    refused("sealed", "the name of a file");
    EXPECT_THROW(check_output_file(""), InputError);
    EXPECT_NO_THROW(check_output_file(folder_ / "new"));
    EXPECT_NO_THROW(check_output_file(folder_ / "pipe"));  // without waiting for a reader
    EXPECT_NO_THROW(check_output_file("/dev/null"));
    EXPECT_FALSE(fs::exists(folder_ / "new"));
    EXPECT_EQ(read_file(folder_ / "locked"), "old");
}

TEST_F(AtomicFileTest, FoldersAreCheckedUpToTheOneThatExists) {
    fs::create_symlink("nowhere", folder_ / "dangling");
    fs::create_directory(folder_ / "sealed");
    ASSERT_EQ(::chmod((folder_ / "sealed").c_str(), 0555), 0);
    write_file_atomically(folder_ / "file", "");
    for (const char* good : {"", "a", "a/b/c"}) {
        EXPECT_NO_THROW(check_output_folder(folder_ / good)) << good;
    }
    EXPECT_NO_THROW(check_output_folder("."));
    for (const char* bad : {"sealed", "sealed/a", "file", "file/a", "dangling", "dangling/a"}) {
        EXPECT_THROW(check_output_folder(folder_ / bad), InputError) << bad;
    }
    EXPECT_THROW(check_output_folder(""), InputError);
    EXPECT_EQ(files(), 3);
}

TEST_F(AtomicFileTest, LongNamesWork) {
    const fs::path path = folder_ / (std::string(250, 'n') + ".h5");
    write_file_atomically(path, "x");
    EXPECT_EQ(read_file(path), "x");
}

TEST_F(AtomicFileTest, ErrorsNameTheFileAndTheReason) {
    const fs::path missing = folder_ / "no" / "such.csv";
    EXPECT_THAT([&] { write_file_atomically(missing, ""); },
                ThrowsMessage<InputError>(AllOf(HasSubstr(missing.string()), HasSubstr("folder"))));
    EXPECT_THAT([&] { write_file_atomically(folder_, ""); },
                ThrowsMessage<InputError>(HasSubstr(folder_.path().string())));
    EXPECT_THROW(write_file_atomically("", ""), InputError);
    EXPECT_THAT([&] { write_file_atomically("/proc/nacre", ""); },
                ThrowsMessage<Error>(HasSubstr("cannot write '/proc/nacre': ")));
    EXPECT_THAT([&] { write_file_atomically("/dev/full", "x"); },
                ThrowsMessage<Error>(HasSubstr("No space left on device")));
    EXPECT_EQ(files(), 0);
}

TEST_F(AtomicFileTest, ReadingRefusesWhatItCannotHold) {
    EXPECT_THAT([&] { read_file(folder_ / "none"); },
                ThrowsMessage<InputError>(HasSubstr("No such file or directory")));
    EXPECT_THAT([&] { read_file(folder_); }, ThrowsMessage<InputError>(HasSubstr("directory")));
    write_file_atomically(folder_ / "ten", "0123456789");
    EXPECT_EQ(read_file(folder_ / "ten", 10), "0123456789");
    EXPECT_THAT([&] { read_file(folder_ / "ten", 9); },
                ThrowsMessage<InputError>(HasSubstr("longer than 9 bytes")));
}

using testing::HasSubstr;
using testing::ThrowsMessage;

// Sets NACRE_DATA_DIR for one test.
class DataDirectory : public testing::Test {
 protected:
    void SetUp() override {
        if (const char* old = std::getenv("NACRE_DATA_DIR")) old_ = old;
        ::unsetenv("NACRE_DATA_DIR");
    }
    void TearDown() override {
        ::unsetenv("NACRE_DATA_DIR");
        if (old_) ::setenv("NACRE_DATA_DIR", old_->c_str(), 1);
    }
    std::optional<std::string> old_;
};

TEST_F(DataDirectory, IsTheSourceTreeWhenThereIsOne) {
    EXPECT_EQ(data_directory(), std::filesystem::path(NACRE_SOURCE_DIR) / "data");
    EXPECT_TRUE(std::filesystem::is_regular_file(data_file("cie_observers.csv")));
}

TEST_F(DataDirectory, TheEnvironmentComesFirst) {
    const std::string folder = testing::TempDir();
    ::setenv("NACRE_DATA_DIR", folder.c_str(), 1);
    EXPECT_EQ(data_directory(), folder);
}

TEST_F(DataDirectory, AWrongChoiceIsAnErrorThatNamesIt) {
    ::setenv("NACRE_DATA_DIR", "/no/such/folder", 1);
    EXPECT_THAT([] { data_directory(); }, ThrowsMessage<InputError>(HasSubstr("/no/such/folder")));
}

TEST_F(DataDirectory, AMissingFileIsAnErrorThatNamesItAndTheFolder) {
    EXPECT_THAT([] { data_file("no-such-file.csv"); },
                ThrowsMessage<InputError>(
                    testing::AllOf(HasSubstr("no-such-file.csv"), HasSubstr("data"))));
}

/// What read_file() says about a path.
std::string refusal(const fs::path& path) {
    try {
        read_file(path);
    } catch (const InputError& error) {
        return error.what();
    }
    return "read";
}

// A pipe that nobody writes into would keep the program waiting, a device without end reading.
TEST_F(AtomicFileTest, OnlyRegularFilesAreReadByName) {
    const fs::path pipe = folder_ / "pipe.toml";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_THAT(refusal(pipe), AllOf(HasSubstr("pipe.toml"), HasSubstr("is a pipe")));
    EXPECT_THAT(refusal("/dev/zero"), HasSubstr("is a device"));
    EXPECT_THAT(refusal("/dev/null"), HasSubstr("is a device"));
    EXPECT_THAT(refusal(folder_), HasSubstr("Is a directory"));
    EXPECT_THAT(refusal(folder_ / "absent"), HasSubstr("No such file"));
    fs::create_symlink("/dev/zero", folder_ / "link");
    EXPECT_THAT(refusal(folder_ / "link"), HasSubstr("is a device"));
}

/// A pipe with some bytes in it, whose writing end is closed.
class FullPipe {
 public:
    explicit FullPipe(const std::string& bytes) {
        int ends[2];
        if (::pipe(ends) != 0) throw Error("no pipe");
        EXPECT_EQ(::write(ends[1], bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
        ::close(ends[1]);
        end_ = ends[0];
    }
    ~FullPipe() { ::close(end_); }
    std::string name() const { return "/dev/fd/" + std::to_string(end_); }
    int end() const { return end_; }

 private:
    int end_;
};

TEST(ReadFile, ReadsThePipesThatTheProgramWasStartedWith) {
    EXPECT_EQ(read_file(FullPipe("abc").name()), "abc");
    const FullPipe pipe("from the left");
    const int kept = ::dup(STDIN_FILENO);
    ASSERT_GE(::dup2(pipe.end(), STDIN_FILENO), 0);
    EXPECT_EQ(read_file("-"), "from the left");
    ::dup2(kept, STDIN_FILENO);
    ::close(kept);
    EXPECT_TRUE(is_stream("-"));
    EXPECT_TRUE(is_stream("/dev/stdin"));
    for (const char* name :
         {"./-", "", "/dev/fd/", "/dev/fd/x", "/dev/fd/1e3", "/dev/stdin.toml"}) {
        EXPECT_FALSE(is_stream(name)) << name;
    }
}

TEST(ReadFile, AnInterruptEndsTheWaitForAPipe) {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);  // open, and empty
    const InterruptHandler handler;
    raise(SIGINT);
    EXPECT_THROW(read_file("/dev/fd/" + std::to_string(ends[0])), Error);
    ::close(ends[0]);
    ::close(ends[1]);
}

TEST(WriteTogether, ReplacesAllOrNone) {
    const test::TempFolder folder;
    folder.write("a.txt", "old");
    write_together({{folder / "a.txt", "new"}, {folder / "b.txt", "beside"}});
    EXPECT_EQ(read_file(folder / "a.txt"), "new");
    EXPECT_EQ(read_file(folder / "b.txt"), "beside");
    EXPECT_THROW(write_together({{folder / "a.txt", "newer"}, {folder / "none" / "c.txt", ""}}),
                 InputError);
    EXPECT_EQ(read_file(folder / "a.txt"), "new");
}

}  // namespace
}  // namespace nacre
