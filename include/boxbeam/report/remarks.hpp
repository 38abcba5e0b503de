#pragma once

#include <string>
#include <vector>

#include "boxbeam/verification/verify.hpp"

namespace boxbeam {

/// Something that a reader must know beside the numbers.
struct Remark {
  enum class Kind {
    assumed,         ///< by the case
    not_applicable,  ///< why checks do not apply
    other,
  };
  Kind kind = Kind::other;
  std::string text;

  /// With its kind in front: "assumed: ..", "not applicable: ..".
  std::string whole() const;
};

/// Assumptions of the case, assumed categories, validity of formulas, values printed beside, what
/// is not checked.
std::vector<Remark> remarks_of(const Project& project, const Verification& verification);

}  // namespace boxbeam
