// Linear least squares by Householder's QR decomposition (Golub & Van Loan 2013, section 5.3).

#pragma once

#include <cstddef>
#include <vector>

namespace eye_render {

// The equations, one a row: `rows` has rhs.size() x columns coefficients, row by row. At least as
// many rows as columns. Returns the `columns` unknowns that leave the least sum of squares; an
// unknown that the rows do not determine (to rounding) is 0.
[[nodiscard]] std::vector<double> least_squares(std::size_t columns,
                                                std::vector<double> rows,
                                                std::vector<double> rhs);

}  // namespace eye_render
