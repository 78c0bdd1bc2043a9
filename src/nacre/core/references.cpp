#include "nacre/core/references.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <system_error>

#include "nacre/core/error.h"
#include "nacre/core/file.h"

namespace nacre {

namespace fs = std::filesystem;

struct References::Contents::Files {
    std::mutex mutex;
    std::map<fs::path, std::shared_ptr<const std::string>> bytes;
};

References::References() : contents_{std::make_shared<Contents::Files>()} {}

References References::anywhere(const fs::path& folder) {
    References references;
    references.folder_ = folder;
    references.allowed_ = Allowed::anywhere;
    return references;
}

References References::within(const fs::path& folder) {
    References references;
    references.folder_ = references.root_ = folder.empty() ? "." : folder;
    references.allowed_ = Allowed::within_root;
    return references;
}

References References::of_file(const fs::path& file) {
    return is_stream(file) ? References() : anywhere(file.parent_path());
}

References References::of_untrusted_file(const fs::path& file) {
    return is_stream(file) ? References() : within(file.parent_path());
}

References References::beside(const fs::path& file) const {
    References references = *this;
    references.folder_ = file.parent_path();
    references.named_ = true;
    return references;
}

References References::checked_by(std::function<void(const fs::path&)> check) const {
    References references = *this;
    references.check_ =
        std::make_shared<const std::function<void(const fs::path&)>>(std::move(check));
    return references;
}

fs::path References::resolve(const fs::path& name) const {
    fs::path path = permitted(name);
    if (check_) (*check_)(path);
    return path;
}

std::shared_ptr<const std::string> References::read(const fs::path& path,
                                                    std::size_t max_bytes) const {
    const std::lock_guard lock(contents_.files->mutex);
    std::shared_ptr<const std::string>& bytes = contents_.files->bytes[path];
    if (!bytes || bytes->size() > max_bytes) {
        bytes = std::make_shared<const std::string>(read_file(path, max_bytes));
    }
    return bytes;
}

fs::path References::permitted(const fs::path& name) const {
    if (allowed_ == Allowed::none) {
        throw InputError("is a file; a text that is in no folder may name none");
    }
    const fs::path path = folder_ / name;
    if (allowed_ == Allowed::anywhere) return path;
    std::error_code root_error, path_error;
    const fs::path root = fs::canonical(root_, root_error);
    const fs::path target = fs::weakly_canonical(path, path_error);
    const bool inside =
        !root_error && !path_error &&
        std::mismatch(root.begin(), root.end(), target.begin(), target.end()).first == root.end();
    if (!inside) {
        throw InputError(fmt::format("is outside the folder '{}'; only files in it may be named",
                                     root_.string()));
    }
    return path;
}

}  // namespace nacre
