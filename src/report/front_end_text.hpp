#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "report_parts.hpp"

/// What a report says of a front end: the only place of the report where kinds are told apart.
namespace boxbeam::report {

/// Gravity and masses of a mechanism of rigid bodies.
struct RigidBodies {
  std::vector<double> gravity;
  struct Body {
    std::string name;
    double mass = 0.0;
    std::optional<double> inertia;  ///< of a body in the plane
  };
  std::vector<Body> bodies;
};

class FrontEndText {
 public:
  explicit FrontEndText(const Project& project) : project_(&project) {}
  FrontEndText(const FrontEndText&) = delete;
  FrontEndText& operator=(const FrontEndText&) = delete;
  virtual ~FrontEndText() = default;

  /// What it is called, and in headings.
  virtual std::string word() const { return "mechanism"; }
  virtual std::string heading() const { return "Mechanism"; }
  virtual std::string inputs_heading() const { return heading() + " and loads"; }

  virtual std::string gravity() const = 0;  ///< "(0, -9.81) m/s^2"

  /// Where the loads on the beam come from.
  virtual std::string source_of_loads() const {
    return "reactions of the mechanism, distributed weight and inertia";
  }

  /// How it is joined, driven and loaded: the inputs. Drivers are called "driver".
  virtual Entries entries() const = 0;

  /// What the chapter on the mechanism says of it.
  virtual std::vector<Block> blocks(const Verification& verification) const = 0;

  virtual std::optional<RigidBodies> rigid_bodies() const { return {}; }

  /// Remarks on the case.
  virtual void add_remarks(std::vector<std::string>&) const {}
  /// Remarks on the motion of a situation.
  virtual void add_remarks(const MotionSummary&, std::vector<std::string>&) const {}

 protected:
  const Project* project_;
};

std::unique_ptr<const FrontEndText> front_end_text_of(const Project& project);

/// The text for a kind of mechanism, each in its report_*.cpp; of the mechanism only the kind
/// counts.
std::unique_ptr<const FrontEndText> text_for(const planar::Mechanism&, const Project& project);
std::unique_ptr<const FrontEndText> text_for(const spatial::Mechanism&, const Project& project);
std::unique_ptr<const FrontEndText> text_for(const flexible::Mechanism&, const Project& project);
std::unique_ptr<const FrontEndText> text_for(const frame::Structure&, const Project& project);
std::unique_ptr<const FrontEndText> text_for(const recorded::Loads&, const Project& project);

/// The least and the largest of every support over all situations; `shown`: which of F_x to M_z.
Table reactions_table(std::string caption, const std::vector<std::size_t>& shown,
                      const std::vector<MotionSummary>& motions);

/// How long a motion that integrates is looked at.
void add_duration(const Duration& duration, Entries& entries);

/// Notes how far curves leave the points of their tables.
void add_overshoots(const std::vector<DriverUse>& functions,
                    std::string (*name_of)(const DriverUse&), std::vector<std::string>& remarks);

}  // namespace boxbeam::report
