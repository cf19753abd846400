// The measurements of a photometric file, and how they are laid out around the lamp: as a file of
// type C has them, vertical angles from the nadir and horizontal ones around the whole circle.

#pragma once

#include <vector>

namespace eye_render {

// Angles ascend; one row a horizontal angle, with a number for each vertical one.
struct IesTable {
    std::vector<double> horizontal_deg{};
    std::vector<double> vertical_deg{};
    std::vector<std::vector<double>> watts{};
};

// A quarter or a half of the circle is mirrored, one row holds all around.
void arrange_type_c(IesTable& table);
// Its pole is horizontal; with the angles exchanged it is laid out as the others are.
void arrange_type_b(IesTable& table);
// Its horizontal angles run the other way around, from the middle.
void arrange_type_a(IesTable& table);

}  // namespace eye_render
