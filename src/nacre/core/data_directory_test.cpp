#include "nacre/core/data_directory.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>

#include "nacre/core/error.h"

namespace nacre {
namespace {

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

}  // namespace
}  // namespace nacre
