#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>  // mkdtemp()

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

// Only for tests: files to read and write, and texts for readers.

namespace nacre::test {

/// A new folder, removed at the end with all that is in it.
class TempFolder {
 public:
    TempFolder() {
        std::string name = ::testing::TempDir() + "nacre_XXXXXX";
        if (!::mkdtemp(name.data())) {
            throw std::system_error(errno, std::generic_category(), name);
        }
        path_ = name;
    }
    ~TempFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TempFolder(const TempFolder&) = delete;
    TempFolder& operator=(const TempFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    operator const std::filesystem::path&() const { return path_; }
    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

    /// @return the file's path
    std::filesystem::path write(const std::string& name, const std::string& bytes) const {
        std::ofstream file(path_ / name, std::ios::binary);
        file << bytes;
        EXPECT_TRUE(file.flush()) << path_ / name;
        return path_ / name;
    }

 private:
    std::filesystem::path path_;
};

/// A text with the first `from` in it replaced.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    if (at == std::string::npos) {
        ADD_FAILURE() << "the test looks for text that is not there: " << from;
        return text;
    }
    return text.replace(at, from.size(), to);
}

}  // namespace nacre::test
