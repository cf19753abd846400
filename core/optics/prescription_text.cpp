// The grammar over the tokens: ["Rx"] [eye] sphere [cylinder axis] {prism} [add] {prism}, all, its
// tail or a part of it bracketed.

#include "optics/prescription_text.h"

#include "base/error.h"
#include "optics/prescription_cursor.h"

#include <cmath>

namespace eye_render {

namespace {

using Kind = PrescriptionToken::Kind;

class Parser {
public:
    explicit Parser(std::string_view text) : next_(text) {}

    Prescription parse()
    {
        int open_brackets = next_.take_opening() ? 1 : 0;
        next_.take_word({"rx"});
        Prescription rx{.eye = take_eye()};
        open_brackets += next_.take_opening() ? 1 : 0;
        rx.sphere_d = take_sphere();
        open_brackets -= take_closing(open_brackets);
        const bool announced = next_.take_mark("/");
        if (!prism_is_next()) {
            open_brackets += next_.take_opening() ? 1 : 0;
        }
        if (!announced || !next_.take_word({"ds", "sph", "sphere"})) {
            take_cylinder(rx, announced);
        }
        open_brackets -= take_closing(open_brackets);
        take_prisms(rx);
        if (next_.take_word({"add"})) {
            rx.add_d = checked_power("add_d", next_.take_number("an addition"), 0.0, max_add_d);
            next_.take_word({"d", "ds", "dpt"});
        }
        take_prisms(rx);
        for (const double sum_pd : {rx.base_in_pd, rx.base_up_pd}) {
            if (std::abs(sum_pd) > max_prism_pd) {
                throw PrescriptionError(PrescriptionErrorCode::PowerRange,
                                        "prism is " + number_text(std::abs(sum_pd)) +
                                            " prism dioptres in all; expected 0 to " +
                                            number_text(max_prism_pd) + " prism dioptres");
            }
        }
        if (take_closing(open_brackets) < open_brackets) {
            fail_syntax("a bracket is not closed");
        }
        next_.require_end();
        return rx;
    }

private:
    // Any number of prisms, such as "2\u0394 BU 1.5\u0394 BI" or "(prism 2 BO)"; those of one
    // direction add up.
    void take_prisms(Prescription& rx)
    {
        while (prism_is_next()) {
            const bool bracketed = next_.take_opening();
            do {
                take_prism(rx);
            } while (bracketed && prism_is_next());
            if (bracketed && !next_.take_mark(")")) {
                fail_syntax("a bracket is not closed");
            }
        }
    }

    void take_prism(Prescription& rx)
    {
        next_.take_word({"prism"});
        const PrescriptionToken& number = next_.take_number("a prism");
        if (number.sign != 0) {
            fail_syntax("a prism has a base, not a sign: " + as_typed(number));
        }
        const double power_pd =
            checked_power("prism", number, 0.0, max_prism_pd, "prism dioptres");
        if (!next_.take_mark("\u0394") && !next_.take_mark("^")) {
            next_.take_word({"pd", "prism"});
        }
        next_.take_word({"base"});
        if (next_.take_word({"bu", "up"})) {
            rx.base_up_pd += power_pd;
        } else if (next_.take_word({"bd", "down"})) {
            rx.base_up_pd -= power_pd;
        } else if (next_.take_word({"bi", "in"})) {
            rx.base_in_pd += power_pd;
        } else if (next_.take_word({"bo", "out"})) {
            rx.base_in_pd -= power_pd;
        } else {
            fail_syntax("a prism needs its base: BU, BD, BI or BO");
        }
    }

    // "prism 2", or a number and what follows that of a prism; with or without a bracket before.
    [[nodiscard]] bool prism_is_next() const
    {
        const std::size_t begin = next_.next_is_one_of({"("}) ? 1 : 0;
        return next_.next_is_one_of({"prism"}, begin) ||
               (next_.next_is(Kind::Number, begin) &&
                next_.next_is_one_of(
                    {"\u0394", "^", "pd", "prism", "base", "bu", "bd", "bi", "bo"}, begin + 1));
    }

    EyeSide take_eye()
    {
        if (next_.take_word({"od", "re", "r", "right"})) {
            return EyeSide::Right;
        }
        if (next_.take_word({"os", "le", "l", "left"})) {
            return EyeSide::Left;
        }
        if (next_.take_word({"ou", "be", "both"})) {
            return EyeSide::Both;
        }
        return EyeSide::Unspecified;
    }

    double take_sphere()
    {
        next_.take_word({"sph", "sphere", "s"});
        if (next_.take_word({"plano", "pl"})) {
            next_.take_word({"ds", "sph", "sphere"});
            return 0.0;
        }
        const double sphere_d =
            checked_power("sphere_d", next_.take_number("a sphere"), -max_sphere_d, max_sphere_d);
        next_.take_word({"ds", "d", "dpt", "s", "sph", "sphere"});
        return sphere_d;
    }

    // Cylinder and axis; nothing at all unless a slash has announced them.
    void take_cylinder(Prescription& rx, bool announced)
    {
        const bool labelled = next_.take_word({"cyl", "cylinder", "c"});
        if (!announced && !labelled && (!next_.next_is(Kind::Number) || prism_is_next())) {
            return;
        }
        const PrescriptionToken& cylinder = next_.take_number("a cylinder");
        // Nothing after a slash can only be no cylinder; elsewhere it may be a slip.
        const bool surely_none = announced && cylinder.value == 0.0;
        if (cylinder.sign == 0 && !surely_none) {
            fail_syntax("the cylinder " + cylinder.text + " needs its sign, + or -");
        }
        const double cylinder_d =
            checked_power("cylinder_d", cylinder, -max_cylinder_d, max_cylinder_d);
        next_.take_word({"dc", "d", "dpt", "c", "cyl"});
        next_.take_mark("/");
        const bool has_axis = take_axis(rx);
        if (cylinder_d == 0.0) {
            rx.axis_deg = Prescription{}.axis_deg;
            return;
        }
        if (!has_axis) {
            throw PrescriptionError(PrescriptionErrorCode::AxisMissing,
                                    "the cylinder " + as_typed(cylinder) +
                                        " needs its axis, 0 to 180; write for example " +
                                        std::string(example_prescription));
        }
        rx.cylinder_d = cylinder_d;
    }

    bool take_axis(Prescription& rx)
    {
        const bool marked =
            next_.take_word({"x", "ax", "axis"}) || next_.take_mark("@") || next_.take_mark("*");
        if (!marked && !next_.next_is(Kind::Number)) {
            return false;
        }
        const PrescriptionToken& axis = next_.take_number("an axis");
        const bool suffixed =
            next_.take_word({"a", "deg", "degrees"}) || next_.take_mark("\u00b0");
        // Without any mark only a whole number is surely an axis: 2.00 could be an addition.
        if (!marked && !suffixed && (axis.sign != 0 || axis.text.find('.') != std::string::npos)) {
            fail_syntax("cannot tell whether " + axis.text + " is an axis");
        }
        if (!(axis.value >= 0.0 && axis.value <= 180.0)) {
            throw PrescriptionError(PrescriptionErrorCode::AxisRange, "axis_deg is " +
                                                                          number_text(axis.value) +
                                                                          "; expected 0 to 180");
        }
        rx.axis_deg = normalized_axis_deg(axis.value);
        return true;
    }

    // How many of the open brackets close here.
    int take_closing(int open_brackets)
    {
        int closed = 0;
        while (closed < open_brackets && next_.take_mark(")")) {
            ++closed;
        }
        return closed;
    }

    PrescriptionCursor next_;
};

}  // namespace

std::string_view to_string(PrescriptionErrorCode code)
{
    switch (code) {
    case PrescriptionErrorCode::Syntax: return "syntax";
    case PrescriptionErrorCode::AxisMissing: return "axis_missing";
    case PrescriptionErrorCode::AxisRange: return "axis_range";
    case PrescriptionErrorCode::PowerRange: return "power_range";
    }
    return "";
}

Prescription parse_prescription(std::string_view text) { return Parser(text).parse(); }

}  // namespace eye_render
