// The notations of prescriptions, what is refused and how, and the way back to text.

#include "optics/prescription_text.h"

#include "../optics_vectors.h"

namespace eye_render {
namespace {

using test::Json;

// "sphere cylinder axis add" or the error's code.
std::string outcome(std::string_view text)
{
    try {
        return format_prescription(parse_prescription(text));
    } catch (const PrescriptionError& error) {
        return std::string(to_string(error.code()));
    }
}

std::string sentence(std::string_view text)
{
    try {
        static_cast<void>(parse_prescription(text));
    } catch (const PrescriptionError& error) {
        return error.what();
    }
    return "";
}

EyeSide side_of(const Json& eye)
{
    return eye == "OD" ? EyeSide::Right : eye == "OS" ? EyeSide::Left : EyeSide::Unspecified;
}

TEST(PrescriptionText, reads_and_refuses_as_the_vectors)
{
    for (const Json& vector : test::vectors_of_kind("parse")) {
        EYE_TRACE_VECTOR(vector);
        const std::string text = vector["input"]["text"];
        const Json& expected = vector["expect"];
        if (expected.contains("error")) {
            EXPECT_EQ(outcome(text), expected["error"].get<std::string>());
            continue;
        }
        const Prescription rx = parse_prescription(text);
        EXPECT_EQ(rx.sphere_d, expected["S"].get<double>());
        EXPECT_EQ(rx.cylinder_d, expected["C"].get<double>());
        EXPECT_EQ(rx.axis_deg,
                  expected["axis"].is_null() ? 180.0 : expected["axis"].get<double>());
        EXPECT_EQ(rx.add_d, expected["add"].is_null() ? 0.0 : expected["add"].get<double>());
        EXPECT_EQ(rx.eye, side_of(expected["eye"]));
    }
}

TEST(PrescriptionText, reads_the_notations_in_use)
{
    const std::string same = "-2.00DS -0.75DC 160A";
    for (const std::string_view text : {
             "-2.00 -0.75 160",
             "-2.00/-0.75/160",
             "-2,00 / -0,75 x 160",
             "-2,00, -0,75, 160",
             "- 2.00 - 0.75 @ 160",
             "sph -2 cyl -0.75 axis 160",
             "Sph: -2.00  Cyl: -0.75  Axis: 160\u00b0",
             "-2.00 DS / -0.75 DC AX 160",
             "\uff0d2.00\u2009\uff0d0.75 \u00d7 160\u00ba",
             "-2.00-0.75*160deg",
             "-2 -.75 x160a",
             "\t-2.00DS\n-0.75DC\r\n160A  ",
             "-2.00DS-0.75DCx160",
             "-2.00D-0.75Dax160",
             "-2,00 dpt -0,75 dpt ax. 160",
             "-2.00 sph. -0.75 cyl. axis 160",
             "sph. -2.00 cyl.-0.75cylx160",
             "Rx: -2.00 -0.75 x 160",
             "(-2.00 -0.75 x 160)",
             "[-2.00DS / -0.75DC x 160]",
             "Rx (-2.00 -0.75 x 160)",
             "\uff08-2.00 -0.75 x 160\uff09",
             "-2.00 (-0.75 x 160)",
             "-2.00DS (-0.75DC x 160)",
             "-2.00 / (-0.75 x 160)",
             "(-2.00 (-0.75 x 160))",
             "Rx [-2.00] [-0.75 x 160]",
         }) {
        EXPECT_EQ(outcome(text), same) << text;
    }
    EXPECT_EQ(outcome("od: -1.25 sph add +2.00"), "OD -1.25DS add +2.00");
    EXPECT_EQ(outcome("OU Plano / sph add 1.5"), "OU 0.00DS add +1.50");
    EXPECT_EQ(outcome("left +3.00 +1.50 x 0 ADD +2.25D"), "OS +3.00DS +1.50DC 180A add +2.25");
    EXPECT_EQ(outcome("OD (-1.25 -0.50 x 20) add +2.00 dpt"), "OD -1.25DS -0.50DC 20A add +2.00");
    EXPECT_EQ(outcome("(OS [-1.25D add +2.00D])"), "OS -1.25DS add +2.00");
    EXPECT_EQ(outcome("0.00/0.00x0"), "0.00DS");
    EXPECT_EQ(outcome("-3.00 +0.00"), "-3.00DS");
    EXPECT_EQ(outcome("1.25"), "+1.25DS");
}

TEST(PrescriptionText, never_guesses)
{
    EXPECT_EQ(outcome(""), "syntax");
    EXPECT_EQ(outcome("OD"), "syntax");
    EXPECT_EQ(outcome("-2.00 /"), "syntax");
    EXPECT_EQ(outcome("-2.00 0.75 x 160"), "syntax");
    EXPECT_EQ(outcome("-2.00 x 160"), "syntax");
    EXPECT_EQ(outcome("-2.00 -0.75 2.00"), "syntax");
    EXPECT_EQ(outcome("-2.00 -0.75 x 160 7"), "syntax");
    EXPECT_EQ(outcome("-2.00 -0.75 x"), "syntax");
    EXPECT_EQ(outcome("-2.0.0"), "syntax");
    EXPECT_EQ(outcome("OD -2.00 OS -1.00"), "syntax");
    EXPECT_EQ(outcome("-2.00 -0.75 x -20"), "axis_range");
    EXPECT_EQ(outcome("-2.00 -0.75 x 180.5"), "axis_range");
    EXPECT_EQ(outcome("-2.00 -075 x 160"), "power_range");
    EXPECT_EQ(outcome("-025"), "power_range");
    EXPECT_EQ(outcome("-30.25"), "power_range");
    EXPECT_EQ(outcome("-2.00 -15.25 x 20"), "power_range");
    EXPECT_EQ(outcome("-2.00 add +4.25"), "power_range");
    EXPECT_EQ(outcome("-2.00 add -1.00"), "power_range");
    EXPECT_EQ(outcome(std::string(400, '9') + ".0"), "power_range");
    EXPECT_EQ(outcome("\xff\xfe\x80"), "syntax");
    EXPECT_EQ(outcome("nan"), "syntax");
    EXPECT_EQ(outcome("(-2.00 -0.75 x 160"), "syntax");
    EXPECT_EQ(outcome("((OD -2.00)"), "syntax");
    EXPECT_EQ(outcome("OD (-2.00 add 1.00"), "syntax");
    EXPECT_EQ(outcome("-2.00 -0.75 x 160)"), "syntax");
    EXPECT_EQ(outcome("(OD (-2.00)"), "syntax");
    EXPECT_EQ(outcome("()"), "syntax");
    EXPECT_EQ(outcome("-2.00 ()"), "syntax");
    EXPECT_EQ(outcome("-2.00 (-0.75 x 160"), "syntax");
    EXPECT_EQ(outcome("-2.00 (-0.75) x 160"), "axis_missing");
    EXPECT_EQ(outcome("-2.00 (0.75 x 160)"), "syntax");
    EXPECT_EQ(outcome("-2.00 (2 BO"), "syntax");
    EXPECT_EQ(outcome("-2.00 prism BO"), "syntax");
    EXPECT_EQ(outcome("-2.00 prism 2"), "syntax");
    EXPECT_EQ(outcome("-2.00 (prism 2 BO 3)"), "syntax");
    EXPECT_EQ(outcome("Rx:"), "syntax");
    EXPECT_EQ(outcome("-2.00 0.00 x 160"), "syntax");
    EXPECT_EQ(outcome("-2.00 / 0.75 x 160"), "syntax");
    EXPECT_EQ(outcome("-2.00.-0.75 x 160"), "syntax");
    EXPECT_EQ(outcome("-2.00DSx"), "syntax");
}

TEST(PrescriptionText, errors_are_sentences_for_the_one_who_typed)
{
    EXPECT_EQ(sentence("-2.00 -0.75"), "the cylinder -0.75 needs its axis, 0 to 180; "
                                       "write for example -2.00DS -0.75DC 160A");
    EXPECT_EQ(sentence("-2.00 -0.75 x 190"), "axis_deg is 190; expected 0 to 180");
    EXPECT_EQ(sentence("-200 -075 x 160"),
              "sphere_d is -200 D; expected -30 to 30 D, with its decimal point, as in -2.00");
    EXPECT_EQ(sentence("-2.00 -0.75 x 160 -1.00"),
              "cannot read '-1.00' at the end of the prescription; write for example -2.00DS "
              "-0.75DC 160A");
    EXPECT_EQ(sentence("banana"),
              "cannot read 'banana' as a sphere; write for example -2.00DS -0.75DC 160A");
    EXPECT_EQ(sentence("(-2.00"),
              "a bracket is not closed; write for example -2.00DS -0.75DC 160A");
    EXPECT_EQ(sentence("-2.00 2\u0394"), "a prism needs its base: BU, BD, BI or BO; write for "
                                         "example -2.00DS -0.75DC 160A");
    EXPECT_EQ(sentence("-2.00 -2\u0394 BU"), "a prism has a base, not a sign: -2; write for "
                                             "example -2.00DS -0.75DC 160A");
}

TEST(PrescriptionText, prisms_are_read_with_their_bases)
{
    const Prescription rx = parse_prescription("OD -2.00 -0.75 x 160 2\u0394 BU 1.5^ BO add 2.00");
    EXPECT_EQ(rx.base_up_pd, 2.0);
    EXPECT_EQ(rx.base_in_pd, -1.5);
    EXPECT_EQ(rx.add_d, 2.0);
    EXPECT_EQ(rx.axis_deg, 160.0);
    for (const char* text :
         {"-2.00 3 BI", "-2.00DS 3pd base in", "-2.00 add 1.00 3.00\u2206 BI", "-2.00 1^ BI 2^ BI",
          "(-2.00 3 prism in)", "-2.00 prism 3 BI", "-2.00 Prism: 3\u0394 BI", "-2.00 (3 BI)",
          "-2.00 (1 BI 2 BI)", "-2.00 (1 BI) prism 2 BI", "-2.00 add 1.00 (prism 3 base in)",
          "(-2.00 (3 BI))"}) {
        EXPECT_EQ(parse_prescription(text).base_in_pd, 3.0) << text;
        EXPECT_EQ(parse_prescription(text).cylinder_d, 0.0) << text;
    }
    for (const char* text : {"-2.00 (-0.75 x 160) (2 BO)", "-2.00 -0.75 x 160 prism 2 BO",
                             "(-2.00 (-0.75 x 160) 2 BO)", "-2.00 -0.75 x 160 (prism 2 BO)"}) {
        EXPECT_EQ(outcome(text), "-2.00DS -0.75DC 160A 2.00\u0394 BO") << text;
    }
    const Prescription both{.sphere_d = 1.0, .base_in_pd = -0.5, .base_up_pd = 2.25};
    EXPECT_EQ(format_prescription(both), "+1.00DS 0.50\u0394 BO 2.25\u0394 BU");
    EXPECT_EQ(parse_prescription(format_prescription(both)), both);
}

TEST(PrescriptionText, parsing_undoes_formatting)
{
    for (const double sphere_d : {-30.0, -2.125, -1.0 / 3.0, 0.0, 1e-9, 29.999}) {
        for (const double cylinder_d : {-15.0, -0.75, 0.0, 2.0 / 7.0}) {
            for (const double axis_deg : {1.0, 90.0, 160.125, 180.0}) {
                for (const EyeSide eye : {EyeSide::Unspecified, EyeSide::Right, EyeSide::Both}) {
                    const Prescription rx{.sphere_d = sphere_d,
                                          .cylinder_d = cylinder_d,
                                          .axis_deg = cylinder_d == 0.0 ? 180.0 : axis_deg,
                                          .add_d = cylinder_d == 0.0 ? 2.25 : 0.0,
                                          .eye = eye};
                    const std::string text = format_prescription(rx);
                    EXPECT_EQ(parse_prescription(text), rx) << text;
                }
            }
        }
    }
}

TEST(PrescriptionText, formats_in_the_papers_notation)
{
    EXPECT_EQ(format_prescription({.sphere_d = -2.0, .cylinder_d = -0.75, .axis_deg = 160.0}),
              "-2.00DS -0.75DC 160A");
    EXPECT_EQ(format_prescription({}), "0.00DS");
    EXPECT_EQ(format_prescription({.sphere_d = -0.0}), "0.00DS");
    EXPECT_EQ(format_prescription({.sphere_d = 1.125, .add_d = 2.0, .eye = EyeSide::Left}),
              "OS +1.125DS add +2.00");
}

}  // namespace
}  // namespace eye_render
