// Steps through the tokens of a prescription; what is not as expected is answered in sentences.

#pragma once

#include "optics/prescription_tokens.h"

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace eye_render {

// What the sentences give as an example.
inline constexpr std::string_view example_prescription = "-2.00DS -0.75DC 160A";

// Throws PrescriptionError of the code Syntax.
[[noreturn]] void fail_syntax(const std::string& sentence);

// The token with its sign.
[[nodiscard]] std::string as_typed(const PrescriptionToken& token);

// The value of a power in range; else throws PrescriptionError of the code PowerRange. Also
// refused is what looks like an implied decimal point: "-075" is how some write -0.75, and nobody
// writes so of 75 dioptres.
[[nodiscard]] double checked_power(std::string_view name,
                                   const PrescriptionToken& number,
                                   double minimum,
                                   double maximum,
                                   std::string_view unit = "D");

class PrescriptionCursor {
public:
    explicit PrescriptionCursor(std::string_view text);

    // What comes `ahead` tokens after the next one; nothing of that kind past the end.
    [[nodiscard]] bool next_is(PrescriptionToken::Kind kind, std::size_t ahead = 0) const;
    [[nodiscard]] bool next_is_one_of(std::initializer_list<std::string_view> texts,
                                      std::size_t ahead = 0) const;

    // Steps over the next token if it is one of those words, or that mark.
    bool take_word(std::initializer_list<std::string_view> words);
    bool take_mark(std::string_view mark);

    // The next token; `what` names what was expected, such as "a sphere".
    const PrescriptionToken& take_number(const std::string& what);

    // A bracket that opens, and holds something.
    bool take_opening();

    void require_end() const;

private:
    std::vector<PrescriptionToken> tokens_;
    std::size_t next_ = 0;
};

}  // namespace eye_render
