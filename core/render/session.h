// One render from start to end: runs in the background, is cancelled at any time, and hands out
// pictures by pull.

#pragma once

#include "render/tracer.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace eye_render {

struct SessionSettings {
    SampleRange samples;
    std::vector<PassRequest> passes;
    CaughtShadow shadow = CaughtShadow::OverWorld;  // of shadow catchers
    // The share of light that counts of what the eye loses, 0 to 1; nothing: lost light is left
    // out of the means (FilmLayout::efficiency).
    std::optional<double> efficiency{};
    double exposure = 1.0;  // a factor of all light in the picture
    int threads = 0;        // at most; 0: all the processor has
};

class Session {
public:
    Session(RenderJob job, SessionSettings settings);
    ~Session();  // cancels and waits
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    // Starts the render, once.
    void start();

    // Asks it to stop; it does so within a pixel's samples.
    void cancel();

    // Waits until the render has ended, at most `timeout`. True if it has.
    bool wait(std::chrono::duration<double> timeout);

    // Samples that every pixel has.
    [[nodiscard]] std::uint32_t samples_done() const { return samples_done_.load(); }
    [[nodiscard]] std::uint32_t samples_total() const
    {
        return settings_.samples.last - settings_.samples.first;
    }

    [[nodiscard]] double progress() const
    {
        return static_cast<double>(samples_done()) / samples_total();
    }

    [[nodiscard]] std::vector<PassImage> snapshot() const;

    [[nodiscard]] RayFates fates() const { return film_.fates(); }

    // What went wrong while it ran; nothing if all went well.
    [[nodiscard]] std::optional<std::string> error() const;

private:
    void run();

    RenderJob job_;
    SessionSettings settings_;
    Film film_;
    std::atomic<bool> cancelled_{false};
    std::atomic<std::uint32_t> samples_done_{0};
    mutable std::mutex mutex_;  // guards the members below
    std::condition_variable ended_changed_;
    bool ended_ = false;
    std::optional<std::string> error_;
    std::thread thread_;
};

}  // namespace eye_render
