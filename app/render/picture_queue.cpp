#include "app/render/picture_queue.h"

#include <algorithm>
#include <utility>

namespace voussoir::app::render
{

PictureQueue::PictureQueue(int jobs, int width, int height) : width_(width), height_(height)
{
    for (int i = 0; i < jobs; ++i) threads_.emplace_back([this] { draw_until_told(); });
}

PictureQueue::~PictureQueue()
{
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        over_ = true;
    }
    asked_.notify_all();
    for (std::thread& thread : threads_) thread.join();
}

void PictureQueue::ask(Work work)
{
    std::packaged_task<Pixels(std::unique_ptr<Drawing>&)> task(
        [this, work = std::move(work)](std::unique_ptr<Drawing>& drawing) {
            if (!drawing)
                drawing = std::make_unique<Drawing>(width_, height_);  // what it throws is of the picture
            return work(*drawing);
        });
    pending_.push_back(task.get_future());
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        waiting_.push_back(std::move(task));
    }
    asked_.notify_one();
}

Pixels PictureQueue::next()
{
    std::future<Pixels> first = std::move(pending_.front());
    pending_.pop_front();
    return first.get();
}

/// A canvas belongs to its thread, which makes and ends it.
void PictureQueue::draw_until_told()
{
    std::unique_ptr<Drawing> drawing;
    while (true) {
        std::packaged_task<Pixels(std::unique_ptr<Drawing>&)> task;
        {
            std::unique_lock<std::mutex> lock(mutex_);
            asked_.wait(lock, [this] { return over_ || !waiting_.empty(); });
            if (over_) return;
            task = std::move(waiting_.front());
            waiting_.pop_front();
        }
        task(drawing);
    }
}

int jobs_for(int asked, int width, int height)
{
    constexpr double room = 6e9;                          // bytes, of the 8 GiB that voussoir-render allows itself
    constexpr double each_pixel = 64, each_thread = 3e8;  // bytes
    const double one = each_pixel * width * height + each_thread;
    const int fit = std::max(1, static_cast<int>(room / one));
    const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    return std::min(asked > 0 ? asked : cores, fit);
}

}  // namespace voussoir::app::render
