// Which channels a pixel needs for the passes that are wanted, Combined apart: nothing else is
// computed, summed or kept.

#pragma once

#include "base/vector.h"
#include "render/passes.h"

#include <span>
#include <vector>

namespace eye_render {

// What is kept where shadow catchers are in the scene, besides Combined with all there is: first
// channels of light (shadow_catcher.h).
struct CatcherChannels {
    std::size_t matte = 0;        // all but what a catcher was the first to catch
    std::size_t bare = 0;         // on catchers, as if there were nothing else
    std::size_t behind = 0;       // of the world behind catchers
    std::size_t matte_alpha = 0;  // one channel, not of light
};

// What of a scene the layout must know.
struct PassSubjects {
    bool has_shadow_catcher = false;
    // In the order of their numbers.
    std::vector<std::string> light_groups{};
    std::vector<std::string> aovs{};
};

// Of a value that materials write out.
struct AovChannels {
    int number = 0;  // the scene's
    std::size_t first = 0;
    bool is_color = false;  // of four channels, the last one how much of the sample has the value
};

class PassLayout {
public:
    static constexpr int none = -1;

    // Of Combined alone.
    PassLayout() : PassLayout(std::vector<PassRequest>{}) {}
    explicit PassLayout(const std::vector<PassRequest>& passes, const PassSubjects& subjects = {});

    // Channels of one sample: those of light first, three a colour, then the others.
    [[nodiscard]] std::size_t light_channels() const { return light_channels_; }
    [[nodiscard]] std::size_t channels() const { return channels_; }
    // Of the one ray a pixel that the others come from.
    [[nodiscard]] std::size_t chief_channels() const { return chief_channels_; }
    // Kinds of Cryptomatte.
    [[nodiscard]] std::size_t matte_kinds() const { return matte_kinds_; }

    // The pass's first channel, or for Cryptomatte its kind, among those of its source; or none.
    [[nodiscard]] int first(Pass pass) const { return first_[static_cast<std::size_t>(pass)]; }
    [[nodiscard]] bool has(Pass pass) const { return first(pass) != none; }
    // The same of one that was asked for, with its name.
    [[nodiscard]] std::size_t first(const PassRequest& request) const;

    // First channel of the light group of this number, or none.
    [[nodiscard]] int light_group(int number) const
    {
        return number < 0 ? none : light_groups_[static_cast<std::size_t>(number)];
    }
    [[nodiscard]] const std::vector<AovChannels>& aovs() const { return aovs_; }

    // Some sample has something to say besides Combined.
    [[nodiscard]] bool has_values() const { return channels_ + matte_kinds_ > 0; }
    // Some pass tells light by what scattered it first.
    [[nodiscard]] bool has_scattered_light() const { return has_scattered_light_; }
    // Some pass tells what is there.
    [[nodiscard]] bool has_surface() const
    {
        return channels_ > light_channels_ || matte_kinds_ > 0;
    }
    [[nodiscard]] const std::optional<CatcherChannels>& catcher() const { return catcher_; }

private:
    std::array<int, pass_count> first_{};
    struct Named {
        PassRequest request;
        std::size_t first;
    };

    void add_named(const std::vector<PassRequest>& passes, PassSource source);
    void note_subjects(const PassSubjects& subjects);

    std::vector<Named> named_;
    std::vector<int> light_groups_;
    std::vector<AovChannels> aovs_;
    std::optional<CatcherChannels> catcher_;
    std::size_t light_channels_ = 0;
    std::size_t channels_ = 0;
    std::size_t chief_channels_ = 0;
    std::size_t matte_kinds_ = 0;
    bool has_scattered_light_ = false;
};

}  // namespace eye_render
