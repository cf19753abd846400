// How fast the slope of a trial's ray can change with each input: a Lipschitz constant from first
// principles, not from the code under test.
//
// To first order, behind a lens F at the distance d, the eye K sends from the pupil point p
//     slope = (I - d F) (u - K p - grad W(p)) - F p,   K = A I - P' - dRx(wavelength) I
// with the prescription P' = P (I - d' P)^-1 referred over the distance d'. All bounds are the
// derivatives of this, by norms.

#pragma once

#include "trial.h"

namespace eye_render::test {

// Of one thin-lens eye (not a schematic one). In slopes per unit of the input.
class Steepness {
public:
    explicit Steepness(const Trial& trial);

    [[nodiscard]] double of(const Input& input) const;

    // The largest vergence that the bounds reckon with, lens and referral included, in dioptres.
    [[nodiscard]] double strongest_d() const { return strongest_d_; }

private:
    [[nodiscard]] double of_lens(const Input& input) const;
    [[nodiscard]] double of_pupil_point() const;

    Trial trial_;
    double strongest_d_ = 0.0;
    double referral_ = 1.0;       // |(I - d' P)^-1|^2: what a change of P becomes at the pupil
    double referred_d_ = 0.0;     // |P'|
    double interpolation_ = 0.0;  // of the paper's astigmatism, dioptres per radian
    double lens_d_ = 0.0;         // |F|
    double lens_m_ = 0.0;         // d
    double gain_ = 1.0;           // |I - d F|
    double point_m_ = 0.0;        // |p|
    double inner_slope_ = 0.0;    // |u - K p - grad W|
};

}  // namespace eye_render::test
