#pragma once

#include <array>

#include "boxbeam/section/plate_kind.hpp"
#include "boxbeam/strength/material.hpp"

namespace boxbeam {

/// What each kind of plate of a section is made of. Refers to the materials.
class PlateMaterials {
 public:
  /// All of one.
  PlateMaterials(const Material& material) { of_.fill(&material); }

  void give(PlateKind kind, const Material& material) {
    of_[static_cast<std::size_t>(kind)] = &material;
  }
  const Material& of(PlateKind kind) const { return *of_[static_cast<std::size_t>(kind)]; }

  friend bool operator==(const PlateMaterials&, const PlateMaterials&) = default;

 private:
  std::array<const Material*, plate_kinds> of_{};
};

}  // namespace boxbeam
