#pragma once

#include "boxbeam/beam/tapered_beam.hpp"

namespace boxbeam {

/// What the four seams between flanges and webs of a beam's boxes come to: what they cost hangs on
/// their length and their throat.
struct SeamSum {
  Length fillets;  ///< length of those whose throat is said
  Length full;     ///< of the others, which penetrate fully
  /// Weld metal of the fillets, each with legs of equal length,
  ///
  ///     V = integral of a^2 along the seam,
  ///
  /// a the throat of the whole seam. Where a seam is of two fillets it is half of that.
  Volume deposit;
};

/// Along the plates, where a box tapers. Of other profiles nothing.
SeamSum seams_of(const TaperedBeam& beam);

}  // namespace boxbeam
