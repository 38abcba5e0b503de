#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/core/error.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/verification/model_choice.hpp"
#include "front_ends.hpp"
#include "working_instants.hpp"

namespace boxbeam {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// The beam's axes in the picture: in the plane x to the right and z upwards.
Matrix3d drawn_axes(const Project& project) {
  Matrix3d axes = Matrix3d::Identity();
  if (!project.in_space) axes << 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, -1.0, 0.0;
  return axes;
}

/// What the loads leave over, linear in the channels.
struct OpenBalance {
  Vector3d force, moment;  ///< about s = 0

  static OpenBalance of(const BeamLoads& loads) {
    const Imbalance open = imbalance_of(loads);
    return {open.force, open.moment};
  }
};

/// Throws where given forces are not in balance at an instant: what is left would be cut forces
/// that depend on the end from which they are summed.
void require_balance(const recorded::Loads& loads, double length) {
  constexpr double rounded = 5e-7;
  const recorded::ChannelLoads& of = loads.acting;
  const OpenBalance constant = OpenBalance::of(of.constant);
  std::vector<OpenBalance> units;
  for (const BeamLoads& unit : of.units) units.push_back(OpenBalance::of(unit));
  double worst = 0.0, largest = 0.0;
  std::size_t when = 0;
  OpenBalance most = constant;
  for (std::size_t i = 0; i < of.channels->times.size(); ++i) {
    OpenBalance at = constant;
    for (std::size_t k = 0; k < units.size(); ++k) {
      at.force += of.channels->values[k][i] * units[k].force;
      at.moment += of.channels->values[k][i] * units[k].moment;
    }
    for (std::size_t p = 0; p < of.constant.points.size(); ++p) {
      Vector3d force = of.constant.points[p].force, moment = of.constant.points[p].moment;
      for (std::size_t k = 0; k < units.size(); ++k) {
        force += of.channels->values[k][i] * of.units[k].points[p].force;
        moment += of.channels->values[k][i] * of.units[k].points[p].moment;
      }
      largest = std::max({largest, force.norm(), moment.norm() / length});
    }
    const double left = at.force.norm() + at.moment.norm() / length;
    if (left <= worst) continue;
    worst = left;
    when = i;
    most = at;
  }
  if (worst <= rounded * largest) return;
  const auto three = [](const Vector3d& v) {
    return fmt::format("({:.4g}, {:.4g}, {:.4g})", v.x() * 1e-3, v.y() * 1e-3, v.z() * 1e-3);
  };
  throw AnalysisError(
      {fmt::format(
           "the forces given are not in balance: the sum of what acts on the beam is {} kN "
           "and {} kN m about its start, beam axes, {:.3g} % of the largest load; what is "
           "missing may be a support, the beam's weight ([balance] gravity) or its inertia. "
           "Where one support is not in the files, write [balance] station = its place",
           three(most.force), three(most.moment), 100.0 * worst / largest),
       "beam", of.channels->times[when]});
}

class RecordedMotion : public SolvedMotion {
 public:
  RecordedMotion(const Project& project, const Situation& situation)
      : project_(&project), recorded_(&recorded_in(project, situation)) {}

  LoadHistory loads() const override {
    require_balance(*recorded_, project_->beam.length().value());
    recorded::ChannelLoads loads = recorded_->acting;
    if (loads.channels->record) loads.channels = working_instants(*project_, loads);
    return LoadHistory(std::move(loads));
  }

  double gravity() const override { return recorded_->gravity.norm(); }

  bool stands_still() const override { return recorded_->acting.units.empty(); }

  PostureAt postures(const LoadHistory& loads) const override {
    return [this, &loads](Time time, const std::string& why) {
      const Matrix3d axes = drawn_axes(*project_);
      PostureFigure figure;
      figure.time = time;
      figure.why = why;
      PostureFigure::Line line;
      line.beam = true;
      const Vector3d end = axes.col(0) * project_->beam.length().value();
      line.strokes.push_back({Vector3d::Zero(), end});
      line.points = {Vector3d::Zero(), end};
      figure.bodies.push_back(std::move(line));
      if (recorded_->balance) figure.grounds.push_back(axes.col(0) * recorded_->balance->s);
      figure.loads = load_rows(loads.loads_at(time), time, axes);
      for (BeamLoadRow& row : figure.loads) row.place = axes.col(0) * row.s.value();
      return figure;
    };
  }

  std::vector<DriverLine> driver_lines(const LoadHistory&) const override { return {}; }

  std::vector<SupportReaction> reactions(const LoadHistory& loads) const override {
    if (!recorded_->balance) return {};
    const std::size_t point = recorded_->balance->point;
    const recorded::ChannelLoads& of = loads.recorded_loads();
    SupportReaction reaction{recorded_->balance->name, {}, {}};
    for (std::size_t i = 0; i < loads.instants(); ++i) {
      PointLoad sum = of.constant.points[point];
      for (std::size_t k = 0; k < of.units.size(); ++k) {
        sum.force += of.channels->values[k][i] * of.units[k].points[point].force;
        sum.moment += of.channels->values[k][i] * of.units[k].points[point].moment;
      }
      for (std::size_t c = 0; c < 6; ++c) {
        const auto axis = static_cast<Eigen::Index>(c % 3);
        const double value = c < 3 ? sum.force[axis] : sum.moment[axis];
        reaction.low[c] = i == 0 ? value : std::min(reaction.low[c], value);
        reaction.high[c] = i == 0 ? value : std::max(reaction.high[c], value);
      }
    }
    return {reaction};
  }

  std::vector<double> supports(const BeamLoads&) const override {
    if (!recorded_->held.empty()) return recorded_->held;
    if (recorded_->balance) return {recorded_->balance->s};
    // Nobody has said how it is held: as a cantilever, clamped where it is softer.
    const TaperedBeam& beam = project_->beam;
    const auto stiffness = [](const Section& section) {
      const SectionProperties of = properties_of(section);
      return std::min(of.I_y, of.I_z);
    };
    const bool softer_start =
        stiffness(beam.segments.front().from) <= stiffness(beam.segments.back().to);
    return {softer_start ? 0.0 : beam.length().value()};
  }

 private:
  const Project* project_;
  const recorded::Loads* recorded_;
};

class RecordedFrontEnd : public FrontEnd {
 public:
  using FrontEnd::FrontEnd;

  std::unique_ptr<const SolvedMotion> solve(const Situation& situation, const ElasticModel&,
                                            const SharedMotions&) const override {
    return std::make_unique<RecordedMotion>(*project_, situation);
  }

  std::optional<ModelChoice> own_model() const override {
    ModelChoice choice;
    choice.tolerance = project_->model.tolerance;
    choice.reason = "the loads are given: what moves and vibrates is in them";
    return choice;
  }

  std::string obstacle_to_vibration(const std::deque<SituationRun>&) const override {
    return "the loads are given: what vibrates is in them";
  }

  AnyMotionResult motion(const std::vector<double>&, const std::string&) const override {
    throw InputError("loads that are given have no motion",
                     "boxbeam verify gives what they do to the beam");
  }

  std::string obstacle_to_instants() const override {
    return "the instants of given loads are those of their files";
  }

  std::vector<AssemblyResult> assemblies(double) const override {
    throw InputError("loads that are given have no mechanism to assemble",
                     "leave out --assemblies");
  }
};

}  // namespace

std::unique_ptr<const FrontEnd> front_end_for(const recorded::Loads&, const Project& project) {
  return std::make_unique<RecordedFrontEnd>(project);
}

}  // namespace boxbeam
