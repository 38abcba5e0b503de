#pragma once

#include <vector>

#include "boxbeam/mechanism/flexible/response.hpp"

namespace boxbeam::flexible {

/// A free undamped vibration, with mass one: motion^T M motion = 1 kg m^2. `shape.joints` are the
/// joint forces in it.
struct Mode {
  double frequency = 0.0;  ///< [Hz]; zero for a motion without strain
  Deformation<double> shape;
};

/// The `count` lowest modes, or all where there are fewer, ascending; of frequencies that agree,
/// any basis. Throws AnalysisError where they do not converge. Method: Lanczos, shifted and
/// inverted, with the solver of `DynamicStiffness` (Spectra).
std::vector<Mode> modes_of(const Structure& structure, std::size_t count);

/// How many natural frequencies lie below a square of omega, undamped, or up to a billionth above
/// it where that is too near one to tell.
std::size_t frequencies_below(const Structure& structure, double square);

}  // namespace boxbeam::flexible
