#include "apps/cli/video.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <map>
#include <vector>

#include "apps/cli/options.h"
#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/core/text.h"

extern char** environ;

namespace nacre::cli {
namespace {

/// ffmpeg's name of the format.
const char* format_of(const std::string& path) {
    static const std::map<std::string, const char*> kFormats{
        {".mp4", "mp4"}, {".mkv", "matroska"}, {".webm", "webm"}, {".gif", "gif"}};
    const auto found = kFormats.find(lowercase(std::filesystem::path(path).extension().string()));
    if (found != kFormats.end()) return found->second;
    throw UsageError(fmt::format("--video = {}: must end in .mp4, .mkv, .webm or .gif", path));
}

/// Runs a program that is found on PATH and waits for it.
/// @param said  what it wrote to its standard error, the last of it
/// @return its exit status, or -1 if it could not be started or a signal ended it
int run_program(const std::vector<std::string>& arguments, std::string& said) {
    int pipe_ends[2];
    if (pipe2(pipe_ends, O_CLOEXEC) != 0) return -1;
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, pipe_ends[1], STDERR_FILENO);
    std::vector<char*> words;
    for (const std::string& word : arguments) words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    pid_t process = 0;
    const int failed = posix_spawnp(&process, words[0], &actions, nullptr, words.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(pipe_ends[1]);
    if (failed != 0) {
        close(pipe_ends[0]);
        said = std::strerror(failed);
        return -1;
    }
    constexpr std::size_t kKept = 2000;
    std::array<char, 512> piece;
    for (ssize_t size; (size = read(pipe_ends[0], piece.data(), piece.size())) != 0;) {
        if (size < 0 && errno != EINTR) break;
        if (size > 0) said.append(piece.data(), static_cast<std::size_t>(size));
        if (said.size() > kKept) said.erase(0, said.size() - kKept);
    }
    close(pipe_ends[0]);
    int status = 0;
    while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

void check_video(const VideoOptions& options) {
    format_of(options.path);
    std::string said;
    if (run_program({"ffmpeg", "-version"}, said) != 0) {
        throw UsageError(
            fmt::format("--video = {}: needs the program ffmpeg, which is not here (Debian and "
                        "Ubuntu: apt install ffmpeg); the frames alone need no --video",
                        options.path));
    }
}

void write_video(const VideoOptions& options, const std::string& pictures, long first, long count) {
    AtomicFile file(options.path, AtomicFile::Temporary::named);
    std::string said;
    const int status = run_program(
        {"ffmpeg", "-nostdin", "-loglevel", "error", "-y", "-framerate",
         fmt::format("{}", options.frames_per_s), "-start_number", fmt::format("{}", first), "-i",
         pictures, "-frames:v", fmt::format("{}", count),
         // Most players want chroma at half the resolution, and so even sides.
         "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt",
         format_of(options.path) == std::string("gif") ? "rgb8" : "yuv420p", "-f",
         format_of(options.path), file.temporary().string()},
        said);
    if (status != 0) {
        throw Error(fmt::format("{}: ffmpeg could not make the video (exit status {}): {}",
                                options.path, status, excerpt(said, 500)));
    }
    file.commit();
}

}  // namespace nacre::cli
