#include "importers/process/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <utility>

extern char** environ;

namespace voussoir::importers::process
{

namespace
{

using Clock = std::chrono::steady_clock;

/// A file descriptor that closes itself.
class Descriptor
{
 public:
    Descriptor() = default;
    explicit Descriptor(int number) : number_(number) {}
    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept
    {
        std::swap(number_, other.number_);
        return *this;
    }
    ~Descriptor() { close(); }
    void close()
    {
        if (number_ >= 0) ::close(std::exchange(number_, -1));
    }
    int number() const { return number_; }

 private:
    int number_ = -1;
};

/// Two ends of a socket. Sockets, not pipes: writing to a child that has died is an error code, not a signal.
struct Channel {
    Descriptor ours, theirs;
    bool open()
    {
        std::array<int, 2> ends{};
        if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) return false;
        ours = Descriptor(ends[0]);
        theirs = Descriptor(ends[1]);
        return fcntl(ends[0], F_SETFL, O_NONBLOCK) == 0;
    }
};

struct Conversation {
    Channel text;    // the child's standard input and output
    Channel errors;  // its standard error
    std::string unsent, output, error_output;
    std::size_t max_output = 0, told = 0;  // bytes; told: of the output, to on_line
    bool is_cut_off = false;               // the output: it could not be received to its end
    std::function<void(const std::string&)> on_line;
};

int start(const std::filesystem::path& program, const Conversation& talk, pid_t& child)
{
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, talk.text.theirs.number(), STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, talk.text.theirs.number(), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, talk.errors.theirs.number(), STDERR_FILENO);
    std::string path = program.string();
    std::array<char*, 2> arguments{path.data(), nullptr};
    const int error = posix_spawn(&child, path.c_str(), &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    return error;
}

void send_some(Conversation& talk)
{
    const ssize_t sent = send(talk.text.ours.number(), talk.unsent.data(), talk.unsent.size(), MSG_NOSIGNAL);
    if (sent > 0) talk.unsent.erase(0, static_cast<std::size_t>(sent));
    if (sent < 0 && errno != EAGAIN && errno != EINTR) talk.unsent.clear();  // it has died; its end says why
    if (talk.unsent.empty()) shutdown(talk.text.ours.number(), SHUT_WR);
}

enum class Stream { open, ended, broken };

Stream receive_some(const Descriptor& from, std::string& text)
{
    std::array<char, 65536> buffer{};
    const ssize_t got = recv(from.number(), buffer.data(), buffer.size(), 0);
    if (got == 0) return Stream::ended;
    if (got < 0) return errno == EAGAIN || errno == EINTR ? Stream::open : Stream::broken;
    text.append(buffer.data(), static_cast<std::size_t>(got));
    return Stream::open;
}

/// Tells the lines that have come whole.
void tell_lines(Conversation& talk)
{
    if (!talk.on_line) return;
    for (std::size_t end; (end = talk.output.find('\n', talk.told)) != std::string::npos; talk.told = end + 1)
        talk.on_line(talk.output.substr(talk.told, end - talk.told));
}

/// Why a child has to be stopped; no words when it ended by itself.
struct Stop {
    std::string why;
    bool out_of_time = false;
};

/// Until the child closes both its streams.
Stop converse(Conversation& talk, double seconds)
{
    const auto deadline = Clock::now() + std::chrono::duration<double>(seconds);
    Stream text = Stream::open, errors = Stream::open;
    while (text == Stream::open || errors == Stream::open) {
        const std::chrono::duration<double, std::milli> left = deadline - Clock::now();
        if (left.count() <= 0)
            return {"it did not finish within " + std::to_string(std::lround(seconds)) + " s", true};
        const short text_events = static_cast<short>(POLLIN | (talk.unsent.empty() ? 0 : POLLOUT));
        std::array<pollfd, 2> streams{pollfd{text == Stream::open ? talk.text.ours.number() : -1, text_events, 0},
                                      pollfd{errors == Stream::open ? talk.errors.ours.number() : -1, POLLIN, 0}};
        if (poll(streams.data(), streams.size(), static_cast<int>(std::min(left.count() + 1, 1e6))) < 0) continue;
        if (streams[0].revents & POLLOUT) send_some(talk);
        if (streams[0].revents & (POLLIN | POLLHUP | POLLERR)) text = receive_some(talk.text.ours, talk.output);
        tell_lines(talk);
        if (streams[1].revents & (POLLIN | POLLHUP | POLLERR))
            errors = receive_some(talk.errors.ours, talk.error_output);
        if (talk.output.size() > talk.max_output || talk.error_output.size() > talk.max_output)
            return {"its output exceeded " + std::to_string(talk.max_output >> 20) + " MiB"};
    }
    talk.is_cut_off = text == Stream::broken;
    return {};
}

/// Waits for the child's end; kills it when it closed its streams but lives on.
int wait_for_end(pid_t child, bool kill_now)
{
    int status = 0;
    for (int i = 0; !kill_now && i < 500; ++i) {
        if (waitpid(child, &status, WNOHANG) == child) return status;
        usleep(1000U * static_cast<unsigned>(std::min(i, 10)));
    }
    kill(child, SIGKILL);
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return status;
}

std::string last_line(const std::string& text)
{
    const std::size_t end = text.find_last_not_of(" \r\n");
    if (end == std::string::npos) return "";
    const std::size_t start = text.find_last_of('\n', end);
    return text.substr(start == std::string::npos ? 0 : start + 1,
                       end - (start == std::string::npos ? -1 : start));
}

std::string describe_end(int status, const std::string& error_output)
{
    std::string said = last_line(error_output);
    if (!said.empty()) said = " (it said: " + said.substr(0, 200) + ")";
    if (WIFSIGNALED(status)) {
        if (WTERMSIG(status) == SIGXCPU) return "it exceeded its CPU time limit" + said;
        return "it crashed with signal " + std::to_string(WTERMSIG(status)) + ", " + strsignal(WTERMSIG(status)) +
               said;
    }
    if (WEXITSTATUS(status) != 0) return "it ended with exit code " + std::to_string(WEXITSTATUS(status)) + said;
    return "";
}

}  // namespace

ChildAnswer ask_child(const std::filesystem::path& program, const std::string& input, double seconds,
                      std::size_t max_output, const std::function<void(const std::string& line)>& on_line)
{
    Conversation talk;
    talk.on_line = on_line;
    talk.unsent = input;
    talk.max_output = max_output;
    if (!talk.text.open() || !talk.errors.open())
        return {"", std::string("no channel to it could be opened: ") + std::strerror(errno)};
    pid_t child = 0;
    if (const int error = start(program, talk, child); error != 0)
        return {"", program.string() + " cannot be started: " + std::strerror(error)};
    talk.text.theirs.close();
    talk.errors.theirs.close();
    const Stop stopped = converse(talk, seconds);
    const int status = wait_for_end(child, !stopped.why.empty());
    if (!stopped.why.empty()) return {std::move(talk.output), stopped.why, stopped.out_of_time};
    const bool out_of_time = WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU;
    std::string failure = describe_end(status, talk.error_output);
    if (failure.empty() && talk.is_cut_off) failure = "its answer could not be received";
    return {std::move(talk.output), std::move(failure), out_of_time};
}

std::filesystem::path helper_folder()
{
    const char* folder = std::getenv("VOUSSOIR_BIN_DIR");
    if (folder != nullptr && *folder != '\0') return folder;
    std::error_code error;
    const std::filesystem::path beside = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
    const std::filesystem::path installed = beside / VOUSSOIR_HELPERS;
    return std::filesystem::is_directory(installed, error) ? installed.lexically_normal() : beside;
}

}  // namespace voussoir::importers::process
