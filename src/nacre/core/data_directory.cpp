#include "nacre/core/data_directory.h"

#include <cstdlib>
#include <system_error>
#include <vector>

#include "nacre/core/error.h"

namespace nacre {

namespace fs = std::filesystem;

fs::path data_directory() {
    std::error_code ec;
    if (const char* chosen = std::getenv("NACRE_DATA_DIR"); chosen && *chosen) {
        // A wrong choice is an error; other data than the user asked for would be a trap.
        if (fs::is_directory(chosen, ec)) return chosen;
        throw InputError(fmt::format("NACRE_DATA_DIR = '{}' is not a folder", chosen));
    }
    std::vector<fs::path> candidates = {NACRE_SOURCE_DATA_DIR};
    const fs::path program = fs::read_symlink("/proc/self/exe", ec);
    if (!ec) {
        candidates.push_back(program.parent_path().parent_path() / NACRE_INSTALL_DATA_DIR / "data");
    }
    std::string tried;
    for (const fs::path& candidate : candidates) {
        if (fs::is_directory(candidate, ec)) return candidate;
        tried += (tried.empty() ? "'" : ", '") + candidate.string() + "'";
    }
    throw InputError(
        fmt::format("Nacre's data folder was not found; tried {}. Set NACRE_DATA_DIR.", tried));
}

namespace {

fs::path file_in(const fs::path& folder, const std::string& name, const char* what) {
    std::error_code ec;
    if (!fs::is_regular_file(folder / name, ec)) {
        throw InputError(
            fmt::format("there is no file '{}' in {} '{}'", name, what, folder.string()));
    }
    return folder / name;
}

}  // namespace

fs::path data_file(const std::string& name) {
    return file_in(data_directory(), name, "the data folder");
}

fs::path shipped_file(const std::string& name) {
    return file_in(fs::absolute(data_directory()).lexically_normal().parent_path(), name,
                   "the folder with Nacre's data,");
}

}  // namespace nacre
