// Prescriptions as people write them, and back.
//
// Read are, in any letter case, with Unicode minus, plus, times, degree and space characters,
// decimal commas, and `:` after labels:
//   -2.00DS -0.75DC 160A      the paper's notation, and what format_prescription writes
//   -2.00 / -0.75 x 160       also `@`, `ax`, `axis`, a bare whole number, or a degree sign
//   OD -1.25 DS, LE +1.50 sph, R plano -0.75 x 090, sph -2 cyl. -0.5 axis 20, ... add +2.00
//   Rx: -2.00 dpt, (-2.00 -0.75 x 160), OD [-2.00DS-0.75DCx160] add +2.00, 0.00/0.00x0
//   -2.00 (-0.75 x 160)       as minus-cylinder forms print it
//   -2.00 2Δ BU 1.5Δ BI        prisms with their bases; also `^`, `pd`, `base up`, `prism 2 BO`,
//                             `(2 BO)`
// Eyes: OD RE R right, OS LE L left, OU BE both. Plano, PL or an infinity sign is a sphere of 0.
// Nothing is guessed: a cylinder needs its sign and its axis, a power needs its decimal point once
// it has three digits, a bracket its other half. Axis 0 becomes 180; a zero cylinder drops its
// axis and, after a slash, needs no sign.

#pragma once

#include "optics/prescription.h"

#include <stdexcept>
#include <string>
#include <string_view>

namespace eye_render {

enum class PrescriptionErrorCode { Syntax, AxisMissing, AxisRange, PowerRange };

// "syntax", "axis_missing", "axis_range", "power_range".
[[nodiscard]] std::string_view to_string(PrescriptionErrorCode code);

// A text that is no prescription; what() is a sentence for the one who typed it.
class PrescriptionError : public std::invalid_argument {
public:
    PrescriptionError(PrescriptionErrorCode code, const std::string& sentence)
        : std::invalid_argument(sentence), code_(code)
    {
    }

    [[nodiscard]] PrescriptionErrorCode code() const { return code_; }

private:
    PrescriptionErrorCode code_;
};

// The one prescription in `text` (UTF-8). Throws PrescriptionError.
[[nodiscard]] Prescription parse_prescription(std::string_view text);

// "OD -2.00DS -0.75DC 160A add +2.00", leaving out what is absent. Two decimals, or as many as it
// takes for parse_prescription to give back the same numbers.
[[nodiscard]] std::string format_prescription(const Prescription& rx);

}  // namespace eye_render
