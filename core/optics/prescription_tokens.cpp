// Normalises the many ways of typing a sign, a space or a degree to ASCII, then splits.

#include "optics/prescription_tokens.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <system_error>

namespace eye_render {

namespace {

struct Spelling {
    std::string_view typed;
    std::string_view meant;
};

constexpr std::string_view degree_sign = "\u00b0";
constexpr std::string_view prism_sign = "\u0394";

constexpr std::array spellings{
    Spelling{"\u2212", "-"},  // minus sign
    Spelling{"\u2013", "-"},  // en dash
    Spelling{"\u2014", "-"},  // em dash
    Spelling{"\u2010", "-"},  // hyphen
    Spelling{"\u2011", "-"},  // non-breaking hyphen
    Spelling{"\uff0d", "-"},  // fullwidth
    Spelling{"\uff0b", "+"},  // fullwidth
    Spelling{"\uff0f", "/"},  // fullwidth
    Spelling{"\uff0e", "."},  // fullwidth
    Spelling{"\uff0c", ","},  // fullwidth
    Spelling{"\uff08", "("},  // fullwidth
    Spelling{"\uff09", ")"},  // fullwidth
    Spelling{"[", "("},
    Spelling{"]", ")"},
    Spelling{"\u00d7", "x"},          // multiplication sign
    Spelling{"\u2715", "x"},          // multiplication x
    Spelling{"\u00a0", " "},          // no-break space
    Spelling{"\u2007", " "},          // figure space
    Spelling{"\u2009", " "},          // thin space
    Spelling{"\u202f", " "},          // narrow no-break space
    Spelling{"\u3000", " "},          // ideographic space
    Spelling{"\u221e", " plano "},    // infinity
    Spelling{"\u00ba", degree_sign},  // masculine ordinal, on many keyboards
    Spelling{"\u02da", degree_sign},  // ring above
    Spelling{"\u2206", prism_sign},   // increment
};

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return c >= 'a' && c <= 'z'; }
bool is_sign(char c) { return c == '+' || c == '-'; }
bool is_separator(char c)
{
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == ':' || c == '=' || c == ';' ||
           c == ',';
}

std::string normalized(std::string_view text)
{
    std::string result;
    while (!text.empty()) {
        std::string_view meant;
        std::size_t length = 1;
        for (const Spelling& spelling : spellings) {
            if (text.starts_with(spelling.typed)) {
                meant = spelling.meant;
                length = spelling.typed.size();
            }
        }
        if (!meant.empty()) {
            result += meant;
        } else {
            const char c = text.front();
            result += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
        }
        text.remove_prefix(length);
    }
    return result;
}

// A comma is a decimal comma between digits and between a sign and a digit.
void replace_decimal_commas(std::string& text)
{
    for (std::size_t i = 1; i + 1 < text.size(); ++i) {
        if (text[i] == ',' && is_digit(text[i + 1]) &&
            (is_digit(text[i - 1]) || is_sign(text[i - 1]))) {
            text[i] = '.';
        }
    }
}

// The length of the digits at the front, with at most one point; 0 when there are none.
std::size_t number_length(std::string_view text)
{
    std::size_t length = 0;
    bool has_digit = false;
    bool has_point = false;
    while (length < text.size() &&
           (is_digit(text[length]) || (text[length] == '.' && !has_point))) {
        has_digit = has_digit || is_digit(text[length]);
        has_point = has_point || text[length] == '.';
        ++length;
    }
    return has_digit ? length : 0;
}

// The number at the front of `text`, which is shortened by it; a mark of one character if the
// sign there has no number.
PrescriptionToken take_number(std::string_view& text)
{
    PrescriptionToken token;
    token.kind = PrescriptionToken::Kind::Number;
    std::size_t begin = 0;
    if (is_sign(text.front())) {
        token.sign = text.front();
        begin = std::min(text.find_first_not_of(" \t", 1), text.size());
    }
    const std::size_t length = number_length(text.substr(begin));
    if (length == 0) {
        token = {.text = std::string(1, text.front())};
        text.remove_prefix(1);
        return token;
    }
    token.text = text.substr(begin, length);
    const auto parsed =
        std::from_chars(token.text.data(), token.text.data() + length, token.value);
    if (parsed.ec != std::errc()) {
        // Hundreds of digits; from_chars leaves 0, which is in every range.
        token.value = std::numeric_limits<double>::infinity();
    }
    if (token.sign == '-') {
        token.value = -token.value;
    }
    text.remove_prefix(begin + length);
    return token;
}

// The letters at the front; where an axis mark is glued to a unit, as in "dcx", those of the unit.
std::size_t word_length(std::string_view text)
{
    std::size_t length = 0;
    while (length < text.size() && is_letter(text[length])) {
        ++length;
    }
    const std::string_view word = text.substr(0, length);
    for (const std::string_view unit : {"d", "dc", "c", "cyl", "dpt"}) {
        if (word.starts_with(unit)) {
            const std::string_view rest = word.substr(unit.size());
            if (rest == "x" || rest == "ax" || rest == "axis") {
                return unit.size();
            }
        }
    }
    return length;
}

// "cyl." and "dpt.": the point of an abbreviation, and not of a number.
bool ends_abbreviation(std::string_view text)
{
    return text.starts_with('.') && !(text.size() > 1 && is_digit(text[1]));
}

}  // namespace

std::vector<PrescriptionToken> prescription_tokens(std::string_view text)
{
    std::string ascii = normalized(text);
    replace_decimal_commas(ascii);
    std::vector<PrescriptionToken> tokens;
    std::string_view rest = ascii;
    while (!rest.empty()) {
        const char c = rest.front();
        if (is_separator(c)) {
            rest.remove_prefix(1);
        } else if (const std::size_t letters = word_length(rest); letters > 0) {
            tokens.push_back({.kind = PrescriptionToken::Kind::Word,
                              .text = std::string(rest.substr(0, letters))});
            rest.remove_prefix(letters);
            rest.remove_prefix(ends_abbreviation(rest) ? 1 : 0);
        } else if (is_digit(c) || is_sign(c) || c == '.') {
            tokens.push_back(take_number(rest));
        } else {
            // A whole UTF-8 character: continuation bytes are 10xxxxxx.
            std::size_t length = 1;
            while (length < rest.size() && (static_cast<unsigned char>(rest[length]) >> 6) == 2) {
                ++length;
            }
            tokens.push_back({.text = std::string(rest.substr(0, length))});
            rest.remove_prefix(length);
        }
    }
    return tokens;
}

}  // namespace eye_render
