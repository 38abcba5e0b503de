#pragma once

#include <Eigen/Core>
#include <string>
#include <utility>
#include <vector>

#include "boxbeam/mechanism/spatial/loops.hpp"
#include "boxbeam/mechanism/spatial/tree.hpp"

namespace boxbeam::spatial {

/// A joint that slides along its axis with friction: a prismatic one that carries a body, or one
/// that closes a loop.
struct FrictionContact {
  std::size_t joint = 0;  ///< index among those that carry bodies, behind them those that close
  Friction law;
};

std::vector<FrictionContact> friction_contacts_of(const Mechanism& mechanism);

/// The law of a contact's joint, to be changed.
Friction& friction_in(Mechanism& mechanism, std::size_t joint);

const std::string& name_of_contact(const Mechanism& mechanism, const FrictionContact& contact);

/// Its two bodies: the one that guides, and the one that slides.
std::pair<int, int> bodies_of_contact(const Mechanism& mechanism, const FrictionContact& contact);

/// Whether a drive moves what slides, along the guide: it takes the friction, and nothing else
/// does.
bool is_taken_by_drive(const Mechanism& mechanism, const FrictionContact& contact);

/// Direction of its guide in the world, a unit vector.
Eigen::Vector3d axis_of_contact(const Mechanism& mechanism, const FrictionContact& contact,
                                const State& state);

/// Velocity of what slides along the guide, relative to the guide's body [m/s].
double sliding_velocity_of(const Mechanism& mechanism, const FrictionContact& contact,
                           const State& state);

/// Rate of change of that velocity [m/s^2].
double sliding_acceleration_of(const Mechanism& mechanism, const FrictionContact& contact,
                               const State& state);

/// What a contact's guide carries, by the wrenches of all joints: what acts along the guide is none
/// of it, nor is a couple about the guide, whose arm is not known.
GuideLoad guide_load_of(const Mechanism& mechanism, const FrictionContact& contact,
                        const State& state, const std::vector<Wrench>& joints);

/// The couple about a contact's guide, which presses on it in ways that are not known [N m].
double couple_about_guide(const Mechanism& mechanism, const FrictionContact& contact,
                          const State& state, const std::vector<Wrench>& joints);

/// The wrenches of all joints, the closing ones behind the others, where friction forces act on
/// both bodies of every contact; `loops` may be nothing. The forces themselves are no part of them.
void wrenches_beside_friction(const Tree& tree, const Loops* loops, const State& state,
                              const std::vector<FrictionContact>& contacts,
                              const std::vector<double>& forces, std::vector<Wrench>& joints);

/// What a motion by drivers has of friction forces. Throws AnalysisError where friction locks the
/// mechanism.
std::vector<double> friction_forces_of(const Tree& tree, const Loops* loops, const State& state,
                                       const std::vector<FrictionContact>& contacts);

/// Throws the AnalysisError of contacts that lock.
[[noreturn]] void say_locked_contacts(const Mechanism& mechanism,
                                      const std::vector<FrictionContact>& contacts, double time);

/// Whether teeth push each other apart, by the size of the force along them.
bool has_pushing_teeth(const Mechanism& mechanism);

/// Throws AnalysisError where joints that repeat each other share what presses on a contact with
/// dry friction, or teeth push apart beside one in a motion by forces.
void require_known_pressure(const Mechanism& mechanism, const Loops& loops,
                            const std::vector<FrictionContact>& contacts);

/// Gives contacts with dry friction a creep velocity that suits how fast they slide
/// (`fitted_creep`); none where forces move a joint, but for those of joints that drivers move. All
/// stay as they are of a motion that cannot be followed, of which its verification says why.
/// `joints`: indices as a contact's.
void fit_creep(Mechanism& mechanism, const std::vector<std::size_t>& joints);

}  // namespace boxbeam::spatial
