// Several pictures at once, handed over in the order in which they were asked for.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "app/render/drawing.h"

namespace voussoir::app::render
{

/// 0xXXRRGGBB, rows from the top; empty where the work has written a file itself.
using Pixels = std::vector<std::uint32_t>;

/// Threads that draw, each with a canvas of its own. What a picture looks like does not depend on their number.
class PictureQueue
{
 public:
    using Work = std::function<Pixels(Drawing&)>;

    /// @param jobs (>= 1) pictures drawn at once, each of this size
    PictureQueue(int jobs, int width, int height);
    ~PictureQueue();  // what was not begun is not drawn
    PictureQueue(const PictureQueue&) = delete;
    PictureQueue& operator=(const PictureQueue&) = delete;

    /// Asks for a picture. The work runs in another thread and only reads what it shares.
    void ask(Work work);

    /// Whether enough was asked for to keep all threads busy; then take the next one first.
    bool is_full() const { return pending_.size() >= 2 * threads_.size(); }
    bool is_empty() const { return pending_.empty(); }

    /// The picture that was asked for first of those not taken yet. @throws what its work threw
    Pixels next();

 private:
    void draw_until_told();

    int width_, height_;
    std::mutex mutex_;
    std::condition_variable asked_;
    bool over_ = false;
    std::deque<std::packaged_task<Pixels(std::unique_ptr<Drawing>&)>> waiting_;
    std::deque<std::future<Pixels>> pending_;
    std::vector<std::thread> threads_;
};

/// How many pictures of this size are drawn at once. @param asked 0: as many as there are cores. No more than find
/// room in the memory that the program may use
int jobs_for(int asked, int width, int height);

}  // namespace voussoir::app::render
