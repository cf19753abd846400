#include "optics/prescription_cursor.h"

#include "base/error.h"
#include "optics/prescription_text.h"

#include <algorithm>

namespace eye_render {

void fail_syntax(const std::string& sentence)
{
    throw PrescriptionError(PrescriptionErrorCode::Syntax,
                            sentence + "; write for example " + std::string(example_prescription));
}

std::string as_typed(const PrescriptionToken& token)
{
    return token.sign != 0 ? token.sign + token.text : token.text;
}

double checked_power(std::string_view name,
                     const PrescriptionToken& number,
                     double minimum,
                     double maximum,
                     std::string_view unit)
{
    const bool implied_point =
        number.text.size() > 2 && number.text.find('.') == std::string::npos;
    if (implied_point || !(number.value >= minimum && number.value <= maximum)) {
        throw PrescriptionError(PrescriptionErrorCode::PowerRange,
                                std::string(name) + " is " + as_typed(number) + ' ' +
                                    std::string(unit) + "; expected " + number_text(minimum) +
                                    " to " + number_text(maximum) + ' ' + std::string(unit) +
                                    ", with its decimal point, as in -2.00");
    }
    return number.value;
}

PrescriptionCursor::PrescriptionCursor(std::string_view text) : tokens_(prescription_tokens(text))
{
}

bool PrescriptionCursor::next_is(PrescriptionToken::Kind kind, std::size_t ahead) const
{
    return next_ + ahead < tokens_.size() && tokens_[next_ + ahead].kind == kind;
}

bool PrescriptionCursor::next_is_one_of(std::initializer_list<std::string_view> texts,
                                        std::size_t ahead) const
{
    return next_ + ahead < tokens_.size() &&
           std::find(texts.begin(), texts.end(), tokens_[next_ + ahead].text) != texts.end();
}

bool PrescriptionCursor::take_word(std::initializer_list<std::string_view> words)
{
    const bool found = next_is(PrescriptionToken::Kind::Word) && next_is_one_of(words);
    next_ += found ? 1 : 0;
    return found;
}

bool PrescriptionCursor::take_mark(std::string_view mark)
{
    const bool found = next_is(PrescriptionToken::Kind::Mark) && next_is_one_of({mark});
    next_ += found ? 1 : 0;
    return found;
}

const PrescriptionToken& PrescriptionCursor::take_number(const std::string& what)
{
    if (!next_is(PrescriptionToken::Kind::Number)) {
        fail_syntax(next_ < tokens_.size()
                        ? "cannot read '" + as_typed(tokens_[next_]) + "' as " + what
                        : what + " is missing at the end of the prescription");
    }
    return tokens_[next_++];
}

bool PrescriptionCursor::take_opening()
{
    const bool found = take_mark("(");
    if (found && next_is_one_of({")"})) {
        fail_syntax("a bracket is empty");
    }
    return found;
}

void PrescriptionCursor::require_end() const
{
    if (next_ < tokens_.size()) {
        fail_syntax("cannot read '" + as_typed(tokens_[next_]) +
                    "' at the end of the prescription");
    }
}

}  // namespace eye_render
