// How far a film is: a bar with the remaining time on a terminal, a few plain lines elsewhere.
#pragma once

#include <chrono>

namespace voussoir::app::commands
{

class FilmProgress
{
 public:
    explicit FilmProgress(bool quiet);
    ~FilmProgress();  // ends the bar's line

    /// @param done of `all` frames, drawn and handed to ffmpeg
    void frame(int done, int all);

 private:
    using Clock = std::chrono::steady_clock;

    bool quiet_ = false, on_terminal_ = false, line_open_ = false;
    int tenths_ = 0;
    Clock::time_point began_ = Clock::now(), told_;
};

}  // namespace voussoir::app::commands
