#include <cmath>
#include <complex>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/flexible/beam_loads.hpp"
#include "boxbeam/verification/elastic_figures.hpp"
#include "boxbeam/verification/elastic_posture.hpp"
#include "boxbeam/verification/flexible_motion_result.hpp"
#include "boxbeam/verification/situation_run.hpp"
#include "boxbeam/verification/sudden_start.hpp"
#include "front_ends.hpp"

namespace boxbeam {
namespace {

/// A harmonic force or couple and the displacement along it.
DriverLine line_of(const flexible::Load& load, bool couple, const FlexibleMotion& motion) {
  constexpr int steps = 192;
  const flexible::Response& response = motion.response;
  const double omega = full_turn * response.frequency;
  Eigen::Vector3d along = load.amplitude;
  if (couple)
    along.head<2>().setZero();
  else
    along.z() = 0.0;
  const double size = along.norm();
  along /= size;
  const double still =
      along.dot(flexible::motion_at(*motion.structure, load.at, response.constant));
  // A real vector does not conjugate what it is multiplied with.
  const flexible::Complex moving = along.cast<flexible::Complex>().dot(
      flexible::motion_at(*motion.structure, load.at, response.harmonic));
  DriverLine line;
  line.name = couple && load.amplitude.head<2>().norm() > 0.0 ? load.name + ", couple" : load.name;
  line.turns = couple;
  for (int k = 0; k <= steps; ++k) {
    const double time = k / (steps * response.frequency);
    const flexible::Complex now = moving * std::polar(1.0, omega * time);
    const DriverState state{still + now.imag(), omega * now.real(), -omega * omega * now.imag()};
    add_sample(line, time, state,
               along.dot(load.constant) + size * std::sin(omega * time + load.phase));
  }
  return line;
}

class VibratingLinks : public SolvedMotion {
 public:
  VibratingLinks(const Project& project, const Situation& situation, const ElasticModel& model)
      : motion(flexible_motion_of(flexible_in(project, situation), model)),
        project_(&project),
        situation_(&situation),
        model_(model) {}

  LoadHistory loads() const override {
    if (situation_->sudden_start) return loads_after_start(*project_, *situation_, model_);
    // Statics alone hold for any time: a second is looked at.
    constexpr std::size_t instants = 96;
    const double frequency = motion.response.frequency;
    const LoadSpan span{Time{}, si<Time>(frequency > 0.0 ? 1.0 / frequency : 1.0), instants, true};
    auto of = std::make_shared<const flexible::BeamResponse>(flexible::beam_response_of(
        *motion.structure, project_->beam_body, project_->beam, motion.response, motion.inertial));
    return {span, staying_on(project_->beam, [of](Time time) {
              return flexible::beam_loads_at(*of, time.value());
            })};
  }

  double gravity() const override { return motion.mechanism->gravity.norm(); }

  bool stands_still() const override { return motion.response.frequency == 0.0; }

  /// With displacements magnified, by the same factor at all times.
  PostureAt postures(const LoadHistory& loads) const override {
    constexpr double part = 0.06;
    const double magnified =
        magnification_of(*motion.structure, largest_displacement(motion.response), part);
    return [this, &loads, magnified](Time time, const std::string& why) {
      const DeformedPosture deformed{motion.structure.get(),
                                     flexible::at(motion.response, time.value()), magnified};
      PostureFigure posture = posture_figure(*project_, deformed, why);
      posture.time = time;
      posture.loads = load_rows(*project_, deformed, loads.loads_at(time));
      return posture;
    };
  }

  /// The harmonic loads with the motion of their points.
  std::vector<DriverLine> driver_lines(const LoadHistory&) const override {
    std::vector<DriverLine> lines;
    if (motion.response.frequency == 0.0) return lines;
    for (const flexible::Load& load : flexible_in(*project_, *situation_).loads) {
      if (load.amplitude.head<2>().norm() > 0.0) lines.push_back(line_of(load, false, motion));
      if (load.amplitude.z() != 0.0) lines.push_back(line_of(load, true, motion));
    }
    return lines;
  }

  std::vector<double> supports(const BeamLoads&) const override {
    std::vector<double> places;
    for (const flexible::Joint& joint : flexible_in(*project_, *situation_).joints) {
      if (joint.a.link == project_->beam_body) places.push_back(joint.a.p.x());
      if (joint.b.link == project_->beam_body) places.push_back(joint.b.p.x());
    }
    return places;
  }

  const FlexibleMotion motion;

 private:
  const Project* project_;
  const Situation* situation_;
  ElasticModel model_;
};

class FlexibleFrontEnd : public FrontEnd {
 public:
  using FrontEnd::FrontEnd;

  std::unique_ptr<const SolvedMotion> solve(const Situation& situation, const ElasticModel& model,
                                            const SharedMotions&) const override {
    return std::make_unique<VibratingLinks>(*project_, situation, model);
  }

  std::optional<ModelChoice> own_model() const override {
    ModelChoice choice = choose_for_links(*project_);
    choice.reason += ", which is the error of this model of the links alone";
    return choice;
  }

  std::string obstacle_to_vibration(const std::deque<SituationRun>&) const override {
    return "the vibration of elastic links is in their loads";
  }

  std::optional<ElasticFigures> elastic_figures(const SituationRun& run,
                                                const ElasticModel& model) const override {
    return elastic_figures_of(*project_, run, model);
  }

  AnyMotionResult motion(const std::vector<double>& times, const std::string& axes) const override {
    if (!times.empty()) throw InputError(obstacle_to_instants(), "leave out --at");
    if (!axes.empty()) {
      throw InputError("the motion of elastic links is given in world axes only",
                       "leave out --axes");
    }
    return flexible_motion_of(*project_);
  }

  std::string obstacle_to_instants() const override {
    return "elastic links vibrate about one posture: there are no instants to choose";
  }

  std::vector<AssemblyResult> assemblies(double) const override {
    throw InputError("elastic links are placed by the case, which is their only assembly",
                     "leave out --assemblies");
  }
};

}  // namespace

std::unique_ptr<const FrontEnd> front_end_for(const flexible::Mechanism&, const Project& project) {
  return std::make_unique<FlexibleFrontEnd>(project);
}

const FlexibleMotion& flexible_motion_of(const SituationRun& run) {
  return dynamic_cast<const VibratingLinks&>(*run.motion).motion;
}

}  // namespace boxbeam
