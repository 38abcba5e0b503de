#pragma once

#include <deque>
#include <map>
#include <optional>
#include <vector>

#include "boxbeam/strength/box_distortion.hpp"
#include "boxbeam/verification/situation_run.hpp"
#include "boxbeam/verification/torques_in.hpp"

namespace boxbeam {

/// Segments of boxes and rectangular tubes in a row, by their indices.
struct BoxStretch {
  std::size_t first = 0, last = 0;
};

/// A stretch of boxes in a row under the torques of a case.
///
/// How a torque comes into a box, nobody knows: by its webs alone or by its flanges alone, d =
/// +-T/2 each, what forces beside the axis put into the webs at a place, F_z y, what they put into
/// the flanges, F_y z, every couple by itself, what passes an end of the stretch, and of given cut
/// forces their jumps; all of them so that their effects add up, for torques that cancel rack the
/// box all the same. Where the case says how (`torque_by`), so, with their signs, but forces in the
/// other plates as if nothing were said; "flow" of couples alone: forces beside the axis come by
/// their own plates, d = (F_z y + F_y z)/2.
/// What comes along the beam, dT/ds, comes alike everywhere, likewise; the part of a taper and of a
/// jump of b/h is known, d = T/2 d(ln(h/b)). Forces at the beam axis are taken to come evenly by
/// both webs or both flanges and do not distort. Ends and joints of the beam hold nothing in shape;
/// diaphragms do, and what comes where one stands is taken by it. Stiffeners and inner profiles are
/// left out, on the safe side.
class DistortedStretch {
 public:
  /// Looks at what is given, which stays. `torques`: of the beam, of each run at its instants;
  /// `stations`: places that are to be among its own.
  DistortedStretch(const Project& project, const std::deque<SituationRun>& runs,
                   const std::vector<std::vector<TorquesIn>>& torques, const BoxStretch& stretch,
                   const std::vector<Station>& stations);

  /// A place is an end of an element; where nothing jumps, of both the one.
  struct Place {
    Station station;
    std::size_t element = 0, end = 0;
  };
  const std::vector<Place>& places() const { return places_; }
  Length from() const { return si<Length>(from_); }
  Length to() const { return si<Length>(to_); }
  /// Where torque comes, ascending: at most 64 of them, for wheels move.
  const std::vector<Length>& introduced() const { return introduced_; }
  /// Whether any torque comes at any instant.
  bool is_distorted() const { return distorted_; }
  /// The cell at a place, and what it resists with.
  const BoxCell& cell(std::size_t place) const { return cells_[place]; }
  const CellDistortion& stiffness(std::size_t place) const { return stiffness_[place]; }

  /// Of an instant of a run, and of any loads.
  DistortionSize size_at(std::size_t place, std::size_t run, std::size_t instant) const;
  DistortionSize size_at(std::size_t place, const BeamLoads& beam_loads) const;

  /// What comes at one place.
  struct Torque {
    Length s;
    Moment torque;
  };
  /// The largest couple that is said to come by "flow" with no diaphragm as near as the box is wide
  /// or high; zero of none.
  const Torque& spread_by_nothing() const { return spread_by_nothing_; }
  /// What comes in, between its ends and at these, of an instant of a run and of any loads.
  TorquesIn torques_at(std::size_t run, std::size_t instant) const;
  TorquesIn torques_of(const BeamLoads& beam_loads) const;
  /// The place whose torques, those that cancel as well, do most of a sum of effects, of M_D = 1
  /// and of gamma = 1, at a place.
  Torque most_at(std::size_t place, const TorquesIn& torques, double of_moment,
                 double of_angle) const;

  /// Of each place, in situations that run one after the other: each part is that of one torque,
  /// whose sign stays; never above twice the most that all do.
  std::vector<DistortionTravel> travels(const std::vector<std::size_t>& runs) const;

 private:
  using Effects = std::vector<DistortionSize>;  ///< of each place, with signs

  struct NodeLoad {
    std::size_t node = 0;
    TorqueSource from = {};
    double d = 0.0;
  };
  struct Loads {
    std::vector<NodeLoad> nodes;           ///< whose signs are not known
    std::optional<Effects> lines, tapers;  ///< what comes along the beam; what is known of sign
  };

  DistortedBeam beam_under(const std::vector<Station>& stations);
  void find_introduced();
  void add_places();
  const LoadIntroduction* introduction_at(double s) const;
  bool comes_by_flow(double s) const;
  bool any_comes_by_flow() const;
  Loads loads_of(const CutForceDiagram& diagram, const TorquesIn& torques, double least) const;
  /// One torque: among the nodes' where its sign is not known, else in what is `known` [N m].
  void add_torque(const TorqueIn& of, std::vector<double>& known, Loads& loads) const;
  void note_flow(const BeamLoads& beam_loads, double least);
  static void add_node(const NodeLoad& at, Loads& loads);
  std::optional<Effects> line_effects(const CutForceDiagram& diagram, double least) const;
  std::optional<Effects> known_effects(const CutForceDiagram& diagram,
                                       std::vector<double> known) const;
  /// `load` shared by the nodes beside s.
  std::vector<NodeLoad> shared(double s, double load, const TorqueSource& from) const;
  Effects effects_of(const Distortion& of) const;
  const Effects& of_node(std::size_t node) const;
  DistortionSize size_at(std::size_t place, const Loads& loads) const;

  const Project* project_;
  const std::deque<SituationRun>* runs_;
  const std::vector<std::vector<TorquesIn>>* torques_;
  BoxStretch stretch_;
  double from_, to_, near_;
  bool slides_ = false;  ///< so many places of torque that something slides along
  std::vector<Length> introduced_;
  std::vector<double> jumps_;  ///< places where something may jump
  DistortionSolver solver_;
  std::vector<Place> places_;
  std::vector<BoxCell> cells_;
  std::vector<CellDistortion> stiffness_;
  std::vector<std::vector<Loads>> loads_;           ///< of each run at its instants
  mutable std::map<std::size_t, Effects> of_node_;  ///< of d = 1 at a node
  bool distorted_ = false;
  Torque spread_by_nothing_;
};

}  // namespace boxbeam
