// Prints the distortion of a box beam by the library, for distortion.py: held in shape at both ends
// and, where asked for, by diaphragms at the thirds; d acts in the middle.
//
//   distortion_figures WIDTH HEIGHT WIDTH_END HEIGHT_END TOP BOTTOM LEFT RIGHT LENGTH DIAPHRAGM
//     OPENING D TORQUE
//
// by mid-lines [m]; DIAPHRAGM is their thickness, 0: none; OPENING their hole's width. A line of
// each node: s, gamma, M_D, lambda, stresses along the beam at the four corners, m at the four
// corners.

#include <cstdio>
#include <cstdlib>
#include <limits>
#include <vector>

#include "boxbeam/strength/box_distortion.hpp"

int main(int argc, char** argv) {
  using namespace boxbeam;
  constexpr int arguments = 13;
  if (argc != arguments + 1) return 2;
  std::vector<double> of;
  for (int i = 1; i <= arguments; ++i) of.push_back(std::atof(argv[i]));
  const double E = 210e9, nu = 0.3, L = of[8], thickness = of[9], opening = of[10], d = of[11],
               torque = of[12];
  const auto cell_at = [&](double s) {
    const double x = s / L;
    return BoxCell{si<Length>(of[0] + x * (of[2] - of[0])),
                   si<Length>(of[1] + x * (of[3] - of[1])),
                   {si<Length>(of[4]), si<Length>(of[5]), si<Length>(of[6]), si<Length>(of[7])}};
  };
  const auto distortion_at = [&](double s) { return cell_distortion_of(cell_at(s), E, nu); };
  DistortedBeam beam =
      distorted_beam({0.0, L / 3.0, 0.5 * L, 2.0 * L / 3.0, L}, cell_at, E, nu, 0.02);
  const double rigid = std::numeric_limits<double>::infinity();
  beam.diaphragms.front() = beam.diaphragms.back() = rigid;
  if (thickness > 0.0) {
    for (const double s : {L / 3.0, 2.0 * L / 3.0})
      beam.diaphragms[beam.nearest(s)] =
          diaphragm_stiffness(cell_at(s), si<Length>(thickness), si<Length>(opening), E, nu);
  }
  std::vector<double> loads(beam.nodes.size(), 0.0);
  loads[beam.nearest(0.5 * L)] = d;
  std::vector<DistortedBeam::AtGauss> lines = beam.of_torque;
  for (std::size_t e = 0; e < lines.size(); ++e)
    for (double& line : lines[e]) line *= beam.nodes[e + 1] <= 0.5 * L ? torque : 0.0;
  const Distortion found = DistortionSolver(beam).solve(loads, lines);
  for (std::size_t i = 0; i < beam.nodes.size(); ++i) {
    const CellDistortion cell = distortion_at(beam.nodes[i]);
    std::printf("%.9g %.9g %.9g %.9g", beam.nodes[i], found.angle[i], found.moment[i], cell.decay);
    for (const CellCorner corner : {CellCorner::top_left, CellCorner::bottom_left,
                                    CellCorner::bottom_right, CellCorner::top_right})
      std::printf(" %.9g", found.warping_stress(i, cell, corner));
    for (const double m : cell.corner_moments) std::printf(" %.9g", m * found.angle[i]);
    std::printf("\n");
  }
  return 0;
}
