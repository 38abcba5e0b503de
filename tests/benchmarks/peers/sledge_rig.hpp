#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>

#include "boxbeam/mechanism/planar/mechanism.hpp"
#include "peers/simbody_rig.hpp"

namespace peers {

inline constexpr std::array<const char*, bench::parts> part_names{
    "ground", "beam", "upper_rod", "blade", "lower_rod", "sledge"};

/// The pins whose forces are compared, in the order of bench::PinName.
struct Pinned {
  const char* joint;
  bench::Part on;    ///< the body that feels the force
  bench::Part from;  ///< the other
};
inline constexpr std::array<Pinned, bench::pins> pins{{{"O", bench::beam, bench::ground},
                                                       {"B", bench::upper_rod, bench::beam},
                                                       {"A", bench::upper_rod, bench::blade},
                                                       {"C", bench::lower_rod, bench::beam},
                                                       {"E", bench::lower_rod, bench::sledge}}};

/// The sledge rig of a case file, its parts by name.
class SledgeRig {
 public:
  /// Throws where the mechanism is another.
  explicit SledgeRig(boxbeam::planar::Mechanism mechanism);

  const boxbeam::planar::Mechanism& mechanism() const { return mechanism_; }
  /// The same with another upper rod, still uniform.
  void set_upper_rod(double length);
  /// The same with another stroke.
  void set_amplitude(double amplitude);

  /// The point of a pin on one of its two bodies.
  boxbeam::planar::Attachment at(const std::string& pin, const std::string& body) const;
  /// All coordinates in closed form, by the intersection of circles; nothing where these do not
  /// meet.
  std::optional<Eigen::VectorXd> position(double time) const;
  /// What Simbody needs to know of it.
  bench::RigData data() const;

 private:
  const boxbeam::planar::Joint& joint(const std::string& name) const;
  const boxbeam::planar::Slider& slider(const std::string& name) const;
  const boxbeam::HarmonicDriver& driver() const;
  double distance(const char* body, const char* pin, const char* other_pin) const;
  void put(Eigen::VectorXd& q, const char* body, const char* pin, const Eigen::Vector2d& p,
           double angle) const;
  void place(Eigen::VectorXd& q, const char* body, const char* pin, const Eigen::Vector2d& p,
             const char* other_pin, const Eigen::Vector2d& other) const;

  boxbeam::planar::Mechanism mechanism_;
};

}  // namespace peers
