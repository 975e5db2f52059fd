#include "app/render/encoder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include "libdda/errors.h"

extern char** environ;

namespace voussoir::app::render
{

namespace
{

namespace fs = std::filesystem;

constexpr int patience = 120;  // s for which ffmpeg may take no frame, or need to end

/// How the frames become a film. MP4: H.264 in 4:2:0 with the colours of television and the index in front, which
/// is what browsers play. GIF: each frame its own 256 colours, so that no frame has to wait in memory for the
/// last.
std::vector<std::string> codec(FilmFormat format)
{
    switch (format) {
        case FilmFormat::gif:
            return {"-filter_complex",
                    "split[a][b];[a]palettegen=stats_mode=single[p];[b][p]paletteuse=new=1",
                    "-loop",
                    "0",
                    "-f",
                    "gif"};
        case FilmFormat::webp:
            return {"-c:v", "libwebp_anim", "-quality", "80", "-loop", "0", "-f", "webp"};
        case FilmFormat::mp4:
            break;
    }
    return {"-vf",
            "scale=out_color_matrix=bt709:out_range=tv",
            "-c:v",
            "libx264",
            "-preset",
            "fast",
            "-crf",
            "20",
            "-pix_fmt",
            "yuv420p",
            "-colorspace",
            "bt709",
            "-color_primaries",
            "bt709",
            "-color_trc",
            "bt709",
            "-color_range",
            "tv",
            "-movflags",
            "+faststart",
            "-f",
            "mp4"};
}

/// Two ends of a socket: writing to a child that has died is an error code, not a signal.
std::pair<int, int> channel()
{
    std::array<int, 2> ends{};
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
        throw InputError("ffmpeg", std::string("no channel to it could be opened: ") + std::strerror(errno),
                         "close other programs");
    const timeval limit{patience, 0};
    setsockopt(ends[0], SOL_SOCKET, SO_SNDTIMEO, &limit, sizeof limit);
    return {ends[0], ends[1]};
}

void close_once(int& descriptor)
{
    if (descriptor >= 0) close(std::exchange(descriptor, -1));
}

}  // namespace

Encoder::Encoder(const fs::path& file, FilmFormat format, int width, int height, double frames_per_second)
    : file_(fs::absolute(file)), part_(file_.string() + ".part")
{
    if (width % 2 != 0 || height % 2 != 0)
        throw InputError("size", fmt::format("{}x{}", width, height), "a film needs an even width and height");
    std::error_code error;
    fs::create_directories(file_.parent_path(), error);
    if (error)
        throw InputError(file_.parent_path().string(), error.message(), "name a folder that can be created");
    std::vector<std::string> words = {"ffmpeg",
                                      "-hide_banner",
                                      "-loglevel",
                                      "error",
                                      "-nostdin",
                                      "-y",
                                      "-f",
                                      "rawvideo",
                                      "-pixel_format",
                                      "bgr0",
                                      "-video_size",
                                      fmt::format("{}x{}", width, height),
                                      "-framerate",
                                      fmt::format("{}", frames_per_second),
                                      "-i",
                                      "pipe:0",
                                      "-an"};
    for (const std::string& word : codec(format)) words.push_back(word);
    for (const char* word : {"-fflags", "+bitexact", "-flags:v", "+bitexact", "-map_metadata", "-1"})
        words.emplace_back(word);  // the same film from the same results
    words.push_back("file:" + part_.string());
    fs::remove(part_, error);  // a link there may lead anywhere
    start(words);
}

void Encoder::start(const std::vector<std::string>& words)
{
    const auto [ours, theirs] = channel();
    input_ = ours;
    errors_ = memfd_create("ffmpeg errors", MFD_CLOEXEC);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, theirs, STDIN_FILENO);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    if (errors_ >= 0) posix_spawn_file_actions_adddup2(&actions, errors_, STDERR_FILENO);
    std::vector<std::string> own = words;
    std::vector<char*> pointers;
    pointers.reserve(own.size() + 1);
    for (std::string& word : own) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    const int error = posix_spawnp(&child_, "ffmpeg", &actions, nullptr, pointers.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(theirs);
    if (error == 0) return;
    child_ = -1;
    close_once(input_);
    close_once(errors_);
    if (error == ENOENT)
        throw InputError("ffmpeg", "there is no such program",
                         "install it, as scripts/install does, or ask for pictures alone");
    throw InputError("ffmpeg", std::string("cannot be started: ") + std::strerror(error), "see the reason");
}

void Encoder::add(const std::vector<std::uint32_t>& pixels)
{
    const char* bytes = reinterpret_cast<const char*>(pixels.data());
    std::size_t left = pixels.size() * sizeof(std::uint32_t);
    while (left > 0) {
        const ssize_t sent = send(input_, bytes, left, MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR) continue;
        if (sent < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) {
            kill(child_, SIGKILL);
            fail(fmt::format("took no frame for {} s", patience));
        }
        if (sent < 0) fail("stopped taking frames");
        bytes += sent;
        left -= static_cast<std::size_t>(sent);
    }
}

void Encoder::finish()
{
    close_once(input_);
    const int status = wait();
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
        throw InputError(file_.string(), "ffmpeg wrote no film" + last_words(),
                         "give a writable folder on a disk with free space, and an ffmpeg with H.264 (libx264)");
    }
    std::error_code error;
    fs::rename(part_, file_, error);
    if (error) throw InputError(file_.string(), error.message(), "give a file name that can be written");
}

/// The exit status of ffmpeg, which is killed if it takes too long.
int Encoder::wait()
{
    int status = 0;
    for (int i = 0; i < patience * 100; ++i) {
        const pid_t ended = waitpid(child_, &status, WNOHANG);
        if (ended == child_ || (ended < 0 && errno != EINTR)) {
            child_ = -1;
            return status;
        }
        usleep(10'000);
    }
    kill(child_, SIGKILL);
    while (waitpid(child_, &status, 0) < 0 && errno == EINTR) {
    }
    child_ = -1;
    return status;
}

void Encoder::fail(const std::string& what)
{
    close_once(input_);
    wait();
    throw InputError(file_.string(), "ffmpeg " + what + last_words(),
                     "give a writable folder on a disk with free space, and an ffmpeg with H.264 (libx264)");
}

/// The last line that it wrote to its errors.
std::string Encoder::last_words() const
{
    std::array<char, 4096> buffer{};
    const off_t size = errors_ >= 0 ? lseek(errors_, 0, SEEK_END) : 0;
    const off_t from = std::max<off_t>(0, size - static_cast<off_t>(buffer.size()));
    const ssize_t got = size > 0 ? pread(errors_, buffer.data(), buffer.size(), from) : 0;
    std::string said(buffer.data(), got > 0 ? static_cast<std::size_t>(got) : 0);
    said.erase(said.find_last_not_of(" \r\n") + 1);
    if (said.empty()) return "";
    return " (it said: " + said.substr(said.find_last_of('\n') + 1).substr(0, 200) + ")";
}

Encoder::~Encoder()
{
    close_once(input_);
    if (child_ > 0) {
        kill(child_, SIGKILL);
        while (waitpid(child_, nullptr, 0) < 0 && errno == EINTR) {
        }
    }
    close_once(errors_);
    std::error_code none;
    fs::remove(part_, none);
}

}  // namespace voussoir::app::render
