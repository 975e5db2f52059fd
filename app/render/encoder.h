// A film file, written by the program ffmpeg from the pixels of one frame after another.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/case/case.h"

namespace voussoir::app::render
{

/// ffmpeg runs beside this program and writes under a temporary name, FILE.part, which becomes FILE when the film
/// is whole. A film that does not become whole leaves nothing.
class Encoder
{
 public:
    /// @throws InputError when there is no ffmpeg, or it cannot be started
    Encoder(const std::filesystem::path& file, FilmFormat format, int width, int height, double frames_per_second);
    ~Encoder();  // stops ffmpeg and removes what it has written, unless the film is finished
    Encoder(const Encoder&) = delete;
    Encoder& operator=(const Encoder&) = delete;

    /// @param pixels (width x height) 0xXXRRGGBB, rows from the top
    /// @throws InputError when ffmpeg has died or takes no more
    void add(const std::vector<std::uint32_t>& pixels);

    /// Waits until ffmpeg has ended, and gives the film its name. @throws InputError when ffmpeg failed
    void finish();

 private:
    void start(const std::vector<std::string>& words);
    [[noreturn]] void fail(const std::string& what);
    std::string last_words() const;
    int wait();

    std::filesystem::path file_, part_;
    pid_t child_ = -1;
    int input_ = -1, errors_ = -1;  // our end of its standard input; a file in memory that it tells its errors to
};

}  // namespace voussoir::app::render
