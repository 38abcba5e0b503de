#pragma once

#include <algorithm>
#include <cstddef>

#include "boxbeam/beam/cut_force_diagram.hpp"

/// Borders of pieces of a diagram, which loads that slide along the beam carry over stations.
namespace boxbeam {

/// How many borders of pieces lie before a station, seen from its side: changes where a load slides
/// over it.
inline std::size_t borders_before(const CutForceDiagram& diagram, const Station& station) {
  const auto beyond = std::partition_point(
      diagram.pieces.begin(), diagram.pieces.end(), [&](const CutForcePiece& piece) {
        return piece.end() < station.s ||
               (piece.end() == station.s && station.side != Side::before);
      });
  return static_cast<std::size_t>(beyond - diagram.pieces.begin());
}

/// Where a border of pieces lies. A load that comes or goes leaves fewer of them: the last one.
inline Length border_of(const CutForceDiagram& diagram, std::size_t border) {
  return diagram.pieces[std::min(border, diagram.pieces.size() - 1)].end();
}

}  // namespace boxbeam
