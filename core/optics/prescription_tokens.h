// The first step of reading a prescription: UTF-8 text to words, numbers and marks.

#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace eye_render {

struct PrescriptionToken {
    enum class Kind { Word, Number, Mark };

    Kind kind = Kind::Mark;
    std::string text;    // lower case ASCII; a number without its sign
    char sign = 0;       // of a number: '+', '-' or 0 when none is written
    double value = 0.0;  // of a number, sign included
};

// Marks are `/ @ * ° ^ Δ ( )` and whatever else is neither letter, digit nor space; `:`, `=`, `;`,
// commas that are no decimal commas and points after words only separate and are dropped. Square
// brackets become round, an infinity sign the word "plano", and "dcx" the words "dc" and "x".
// Never fails: what cannot be understood becomes a mark.
[[nodiscard]] std::vector<PrescriptionToken> prescription_tokens(std::string_view text);

}  // namespace eye_render
