// Room for a value that is made only where it is needed: as std::optional, whose room g++ clears
// whole before it is used (GCC bug 86173). A path asks for several; to clear them took 230 of its
// 6,860 instructions in a plain scene.

#pragma once

#include <memory>
#include <type_traits>

namespace eye_render {

template <typename T>
class Room {
    static_assert(std::is_trivially_destructible_v<T>);

public:
    Room() {}  // NOLINT(modernize-use-equals-default): a default one is cleared, too
    ~Room() = default;
    Room(const Room&) = delete;
    Room& operator=(const Room&) = delete;

    const T& fill(const T& value)
    {
        is_filled_ = true;
        return *std::construct_at(&value_, value);
    }

    explicit operator bool() const { return is_filled_; }
    // Of one that is filled.
    const T& operator*() const { return value_; }
    const T* operator->() const { return &value_; }

private:
    union {
        T value_;
    };
    bool is_filled_ = false;
};

}  // namespace eye_render
