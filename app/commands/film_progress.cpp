#include "app/commands/film_progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <string>

#include "app/commands/say.h"
#include "app/commands/stopwatch.h"

namespace voussoir::app::commands
{

FilmProgress::FilmProgress(bool quiet) : quiet_(quiet), on_terminal_(isatty(STDOUT_FILENO) == 1) {}

FilmProgress::~FilmProgress()
{
    if (line_open_) say("");
}

void FilmProgress::frame(int done, int all)
{
    if (quiet_ || all <= 0 || done > all) return;
    const Clock::time_point now = Clock::now();
    const double share = static_cast<double>(done) / all;
    const int tenths = static_cast<int>(10 * share);
    const bool tell =
        on_terminal_ ? now - told_ > std::chrono::milliseconds(100) || done == all : tenths > tenths_;
    if (!tell) return;
    told_ = now;
    tenths_ = tenths;
    const double elapsed = std::chrono::duration<double>(now - began_).count();
    const std::string left =
        done < all ? ", " + duration_in_words(elapsed * (1 - share) / share) + " left" : std::string();
    if (on_terminal_) {
        constexpr int width = 30;
        const int filled = static_cast<int>(share * width);
        say_over(fmt::format("[{}{}] {:3.0f} %  film: frame {} of {}{}", std::string(filled, '#'),
                             std::string(width - filled, '.'), 100 * share, done, all, left),
                 false);
    } else {
        say(fmt::format("{:3.0f} %  film: frame {} of {}{}", 100 * share, done, all, left));
    }
    std::fflush(stdout);
    line_open_ = on_terminal_;
}

}  // namespace voussoir::app::commands
