// The random numbers of one path, four at a time, a pure function of (seed, pixel, sample).

#pragma once

#include "base/sobol.h"

namespace eye_render {

class SampleSequence {
public:
    SampleSequence(std::uint64_t key, std::uint32_t sample) : key_(key), sample_(sample) {}

    // Other numbers of the same path, for what must not move those that follow.
    [[nodiscard]] SampleSequence branch(std::uint64_t purpose) const
    {
        return {sobol_key(key_, purpose), sample_};
    }

    [[nodiscard]] std::array<float, 4> next() { return sobol_4d(key_, sample_, group_++); }

private:
    std::uint64_t key_;
    std::uint32_t sample_;
    std::uint32_t group_ = 0;
};

}  // namespace eye_render
