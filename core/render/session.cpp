#include "render/session.h"

#include <algorithm>
#include <exception>

namespace eye_render {

namespace {

// A slice is what is traced before the count of done samples moves on. Slices grow while they are
// short and shrink when they are long: progress is seen, and threads seldom wait for each other.
constexpr std::chrono::duration<double> short_slice(0.25);
constexpr std::chrono::duration<double> long_slice(1.0);

std::uint32_t next_slice(std::uint32_t slice, std::chrono::duration<double> took)
{
    if (took < short_slice) {
        return 2 * slice;
    }
    return took > long_slice ? std::max(slice / 2, 1u) : slice;
}

}  // namespace

Session::Session(RenderJob job, SessionSettings settings)
    : job_(std::move(job)), settings_(std::move(settings)),
      film_(job_.frame.border,
            {.passes = job_.passes,
             .chromatic = job_.chromatic,
             .shadow = settings_.shadow,
             .efficiency = settings_.efficiency,
             .exposure = settings_.exposure})
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
        on_threads(settings_.threads, [this] {
            if (job_.passes.chief_channels() > 0 && !trace_chief_rays(job_, film_, cancelled_)) {
                return;
            }
            std::uint32_t slice = 1;
            for (std::uint32_t first = settings_.samples.first; first < settings_.samples.last;) {
                const auto start = std::chrono::steady_clock::now();
                const std::uint32_t last = first + std::min(slice, settings_.samples.last - first);
                if (!trace_samples(job_, {.first = first, .last = last}, film_, cancelled_)) {
                    return;
                }
                samples_done_.fetch_add(last - first);
                first = last;
                slice = next_slice(slice, std::chrono::steady_clock::now() - start);
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
