#pragma once

#include <array>
#include <memory>
#include <string>

/// The sledge rig in Simbody. An interface of plain numbers: the headers of Simbody 3.7 cannot be
/// compiled as C++20 and those of boxbeam cannot be without.
namespace bench {

struct Point {
  double x = 0.0;
  double y = 0.0;
};

enum Part { ground, beam, upper_rod, blade, lower_rod, sledge, parts };
enum PinName { pin_o, pin_b, pin_a, pin_c, pin_e, pins };

/// A pin: the body whose force is looked at and the one that it comes from.
struct PinData {
  Part on = ground;
  Part from = ground;
  Point at_on, at_from;  ///< in the axes of the bodies, from their centres of mass
};

/// All that Simbody needs to know of the case. SI units.
struct RigData {
  struct Content {
    double mass = 0.0;
    double inertia = 0.0;
  };
  std::array<Content, parts> content;
  std::array<PinData, pins> pin;
  Point on_blade_line, on_rail;  ///< points of blade and sledge that slide
  double blade_line = 0.0;       ///< y of the horizontal line
  double rail = 0.0;             ///< the same
  double mean = 0.0, amplitude = 0.0, omega = 0.0, phase = 0.0;  ///< of the blade
  Point gravity;
};

struct PartPosture {
  Point centre;
  double angle = 0.0;
};

/// How the rig is put into Simbody.
enum class Model {
  planar_joints,  ///< three coordinates to a body, every pin a pair of constraints
  compact_tree,   ///< pins O, A, C and the rail are joints of the tree, B and E close it
};

/// Where the search of positions begins.
enum class Start {
  last,       ///< at the positions of the instant before
  predicted,  ///< at their Taylor series of second order, as boxbeam's does
};

/// The blade's motion is prescribed, constraints are met by projection to `accuracy`.
class SimbodyRig {
 public:
  SimbodyRig(const RigData& data, Model model, Start start, double accuracy);
  ~SimbodyRig();
  SimbodyRig(const SimbodyRig&) = delete;
  SimbodyRig& operator=(const SimbodyRig&) = delete;

  /// The first instant, where the parts are known.
  void start(double time, const std::array<PartPosture, parts>& postures);
  /// The same from rough postures, by Simbody's assembler.
  void assemble(double time, const std::array<PartPosture, parts>& postures);
  /// Positions, velocities, accelerations and the forces of the pins from the instant before.
  /// Throws where the projection does not converge.
  void advance(double time, std::array<Point, pins>& forces);
  /// Where a pin is now, as a point of the body that feels its force.
  Point place(PinName pin) const;

 private:
  class Inside;
  std::unique_ptr<Inside> inside_;
};

std::string simbody_version();

}  // namespace bench
