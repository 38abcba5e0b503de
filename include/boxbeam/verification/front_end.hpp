#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "boxbeam/beam/cut_force_diagram.hpp"
#include "boxbeam/project/project.hpp"
#include "boxbeam/verification/animation.hpp"
#include "boxbeam/verification/any_motion_result.hpp"
#include "boxbeam/verification/beam_shift.hpp"
#include "boxbeam/verification/load_history.hpp"
#include "boxbeam/verification/loaded_posture.hpp"
#include "boxbeam/verification/motion_summary.hpp"
#include "boxbeam/verification/posture.hpp"
#include "boxbeam/verification/situation_run.hpp"

namespace boxbeam {

struct DriverLine;
struct ElasticFigures;

/// The mechanism as it stands at a time, with the loads on the beam; the text says why it is shown.
using PostureAt = std::function<PostureFigure(Time, const std::string& why)>;

/// Makes a posture whose axial force counts so many times.
using MakePosture = std::function<LoadedPosture(double factor)>;

/// A situation as its front end has solved it: what a verification and its pictures ask of whatever
/// moves and loads the beam. It looks at the project and the situation, which stay.
class SolvedMotion {
 public:
  SolvedMotion() = default;
  SolvedMotion(const SolvedMotion&) = delete;
  SolvedMotion& operator=(const SolvedMotion&) = delete;
  virtual ~SolvedMotion() = default;

  /// The loads on the beam over the time that is looked at. Throws AnalysisError.
  virtual LoadHistory loads() const = 0;

  virtual double gravity() const = 0;  ///< its size [m/s^2]

  /// Whether nothing moves and the loads are always the same.
  virtual bool stands_still() const { return false; }

  /// What is drawn of it under its loads.
  virtual PostureAt postures(const LoadHistory& loads) const = 0;

  /// What moves it: a coordinate over time, with the force that it takes where that is known.
  virtual std::vector<DriverLine> driver_lines(const LoadHistory& loads) const = 0;

  /// Where what carries the beam takes hold of it, under its loads of an instant [m].
  virtual std::vector<double> supports(const BeamLoads& loads) const = 0;

  /// The whole mechanism stopped at a time and holding the beam, under its loads then; nothing
  /// where it cannot be stopped and hold it.
  virtual MakePosture stopped(Time, const BeamLoads&) const { return {}; }

  /// What bends and moves the beam beside its cut forces; nothing of rigid bodies.
  virtual BeamShift beam_shift(Time) const { return {}; }

  /// At so many times its loads the whole of it buckles, the least of all instants, at most `most`;
  /// nothing where that is not known.
  virtual std::optional<double> critical_factor(const LoadHistory&, double /*most*/) const {
    return {};
  }

  /// At so many times its loads the whole of it, stopped at a time, buckles, at most `most`;
  /// nothing where that is not known. `diagram`: of the beam then.
  virtual std::optional<double> critical_factor_at(Time, const CutForceDiagram& /*diagram*/,
                                                   double /*most*/) const {
    return {};
  }

  /// What the ground does to it; nothing where that is not asked of its kind.
  virtual std::vector<SupportReaction> reactions(const LoadHistory&) const { return {}; }

  /// How it closes; nothing where there is nothing to close.
  virtual std::optional<ClosureSummary> closure() const { return {}; }

  /// How it moves in space, or stands there, with one more instant; nothing of what is not drawn.
  virtual std::optional<Animation> scene(std::optional<Time> /*also*/) const { return {}; }
};

/// A kind of mechanism, or another source of loads, as the verification sees it: the only place
/// where kinds are told apart. It looks at the project, which stays.
class FrontEnd {
 public:
  explicit FrontEnd(const Project& project) : project_(&project) {}
  FrontEnd(const FrontEnd&) = delete;
  FrontEnd& operator=(const FrontEnd&) = delete;
  virtual ~FrontEnd() = default;

  /// Solves a situation by a model; what is the same for every beam of the case once. Throws
  /// AnalysisError where a step cannot be done or loads on the beam are not determined.
  virtual std::unique_ptr<const SolvedMotion> solve(const Situation& situation,
                                                    const ElasticModel& model,
                                                    const SharedMotions& shared) const = 0;

  /// The model of what is elastic itself, its second order not yet estimated; nothing of rigid
  /// bodies, whose beam may bend.
  virtual std::optional<ModelChoice> own_model() const { return {}; }

  /// Why the vibration of the beam is not estimated; "" where it is, in the plane.
  virtual std::string obstacle_to_vibration(const std::deque<SituationRun>& rigid) const = 0;

  /// Throws InputError where an elastic model cannot be asked for.
  virtual void require_elastic_model() const {}

  /// What is drawn of elastic links beside the beam; nothing of rigid bodies.
  virtual std::optional<ElasticFigures> elastic_figures(const SituationRun& run,
                                                        const ElasticModel& model) const;

  /// The motion alone at the given times [s], or where none is given at times of its own; vectors
  /// in the axes of a body, or with "" of the world. Throws InputError for what it cannot be asked
  /// for, AnalysisError where it cannot be had.
  virtual AnyMotionResult motion(const std::vector<double>& times,
                                 const std::string& axes) const = 0;

  /// Why there are no instants to choose; "" where there are.
  virtual std::string obstacle_to_instants() const { return ""; }

  /// The ways to assemble it at an instant [s]. Throws InputError where there is one only.
  virtual std::vector<AssemblyResult> assemblies(double time) const = 0;

 protected:
  const Project* project_;
};

std::unique_ptr<const FrontEnd> front_end_of(const Project& project);

/// Loads that stop where one of them has slid off the end of the beam, with an AnalysisError; what
/// stands at a border of segments but for rounding stands on it.
LoadsAt staying_on(const TaperedBeam& beam, LoadsAt loads);

}  // namespace boxbeam
