#include "render/session.h"

#include <tbb/info.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <exception>

namespace eye_render {

namespace {

// A slice is what is traced between two looks at the clock. The first ones are short, so that
// something shows at once.
constexpr std::uint32_t longest_slice = 16;

}  // namespace

Session::Session(RenderJob job, SessionSettings settings)
    : job_(std::move(job)), settings_(std::move(settings)),
      film_(job_.frame.border,
            {.first_surface = job_.integrator.first_surface, .chief = settings_.chief_rays})
{
}

Session::~Session()
{
    cancel();
    if (thread_.joinable()) {
        thread_.join();
    }
}

void Session::start()
{
    if (!thread_.joinable()) {
        thread_ = std::thread([this] { run(); });
    }
}

void Session::cancel() { cancelled_.store(true); }

bool Session::wait(std::chrono::duration<double> timeout)
{
    std::unique_lock lock(mutex_);
    return ended_changed_.wait_for(lock, timeout, [this] { return ended_; });
}

std::vector<PassImage> Session::snapshot() const { return film_.snapshot(settings_.passes); }

std::optional<std::string> Session::error() const
{
    const std::scoped_lock lock(mutex_);
    return error_;
}

void Session::run()
{
    std::optional<std::string> error;
    try {
        const int available = tbb::info::default_concurrency();
        tbb::task_arena arena(settings_.threads > 0 ? std::min(settings_.threads, available)
                                                    : available);
        arena.execute([this] {
            if (settings_.chief_rays && !trace_chief_rays(job_, film_, cancelled_)) {
                return;
            }
            std::uint32_t slice = 1;
            for (std::uint32_t first = settings_.samples.first; first < settings_.samples.last;) {
                const std::uint32_t last = std::min(first + slice, settings_.samples.last);
                if (!trace_samples(job_, {.first = first, .last = last}, film_, cancelled_)) {
                    return;
                }
                samples_done_.fetch_add(last - first);
                first = last;
                slice = std::min(2 * slice, longest_slice);
            }
        });
    } catch (const std::exception& exception) {
        error = exception.what();
    }
    const std::scoped_lock lock(mutex_);
    error_ = std::move(error);
    ended_ = true;
    ended_changed_.notify_all();
}

}  // namespace eye_render
