// C++17, without NDEBUG, as Debian's Simbody wants it.

#include "closed_chain_simbody.hpp"

#include <Simbody.h>

namespace bench {
namespace {

SimTK::Vec3 vec(const Triple& of) { return {of[0], of[1], of[2]}; }
Triple triple(const SimTK::Vec3& of) { return {of[0], of[1], of[2]}; }

}  // namespace

class SimbodyRow::Inside {
 public:
  Inside(const ClosedRow& row, double accuracy)
      : matter_(system_), forces_(system_), accuracy_(accuracy) {
    SimTK::Force::UniformGravity(forces_, matter_, vec(row.gravity));
    for (const ClosedRow::Body& body : row.bodies) {
      const SimTK::Vec3 centre = vec(body.centre);
      const auto& I = body.inertia;
      const SimTK::Inertia about_centre(I[0], I[1], I[2], I[3], I[4], I[5]);
      const SimTK::MassProperties mass(body.mass, centre,
                                       about_centre.shiftFromMassCenter(centre, body.mass));
      // A pin turns about z of its frames.
      const SimTK::Rotation R(SimTK::UnitVec3(vec(body.axis)), SimTK::ZAxis);
      SimTK::MobilizedBody& parent = body.parent < 0
                                         ? static_cast<SimTK::MobilizedBody&>(matter_.updGround())
                                         : bodies_[static_cast<std::size_t>(body.parent)];
      bodies_.push_back(SimTK::MobilizedBody::Pin(parent, SimTK::Transform(R, vec(body.at)),
                                                  SimTK::Body::Rigid(mass),
                                                  SimTK::Transform(R, SimTK::Vec3(0.0))));
    }
    for (const ClosedRow::Ball& ball : row.balls)
      balls_.push_back(
          SimTK::Constraint::Ball(bodies_[static_cast<std::size_t>(ball.a)], vec(ball.p_a),
                                  bodies_[static_cast<std::size_t>(ball.b)], vec(ball.p_b)));
    SimTK::Motion::Sinusoid(bodies_[0], SimTK::Motion::Position, row.swing, row.frequency, 0.0);
    state_ = system_.realizeTopology();
    system_.realizeModel(state_);
  }

  void start(const std::vector<double>& coordinates, const std::vector<double>& rates) {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      bodies_[i].setOneQ(state_, 0, coordinates[i]);
      bodies_[i].setOneU(state_, 0, rates[i]);
    }
  }

  void solve(double time) {
    SimTK::ProjectOptions options(accuracy_);
    options.setOption(SimTK::ProjectOptions::ForceProjection);
    SimTK::ProjectResults results;
    SimTK::Vector none;
    state_.setTime(time);
    system_.realize(state_, SimTK::Stage::Time);
    system_.prescribeQ(state_);
    system_.realize(state_, SimTK::Stage::Position);
    system_.projectQ(state_, none, options, results);
    system_.prescribeU(state_);
    system_.realize(state_, SimTK::Stage::Velocity);
    system_.projectU(state_, none, options, results);
    system_.realize(state_, SimTK::Stage::Acceleration);
    matter_.calcMobilizerReactionForces(state_, reactions_);
  }

  SimbodyAnswer answer() const {
    SimbodyAnswer of;
    for (const SimTK::MobilizedBody& body : bodies_) {
      of.coordinates.push_back(body.getOneQ(state_, 0));
      of.rates.push_back(body.getOneU(state_, 0));
      of.accelerations.push_back(body.getOneUDot(state_, 0));
      of.forces.push_back(triple(reactions_[body.getMobilizedBodyIndex()][1]));
    }
    for (const SimTK::Constraint& ball : balls_) {
      SimTK::Vector_<SimTK::SpatialVec> on_bodies;
      SimTK::Vector along;
      // In the axes of the ground, their common ancestor. As the drive below with the sign that it
      // has beside the inertia: M u' + ~G lambda + tau = f.
      ball.getConstraintForcesAsVectors(state_, on_bodies, along);
      of.forces.push_back(triple(-on_bodies[1][1]));
    }
    SimTK::Vector motion;
    matter_.findMotionForces(state_, motion);
    of.drive = -motion[0];
    return of;
  }

 private:
  SimTK::MultibodySystem system_;
  SimTK::SimbodyMatterSubsystem matter_;
  SimTK::GeneralForceSubsystem forces_;
  double accuracy_;
  std::vector<SimTK::MobilizedBody> bodies_;
  std::vector<SimTK::Constraint> balls_;
  SimTK::State state_;
  SimTK::Vector_<SimTK::SpatialVec> reactions_;
};

SimbodyRow::SimbodyRow(const ClosedRow& row, double accuracy)
    : inside_(std::make_unique<Inside>(row, accuracy)) {}
SimbodyRow::~SimbodyRow() = default;

void SimbodyRow::start(const std::vector<double>& coordinates, const std::vector<double>& rates) {
  inside_->start(coordinates, rates);
}
void SimbodyRow::solve(double time) { inside_->solve(time); }
SimbodyAnswer SimbodyRow::answer() const { return inside_->answer(); }

}  // namespace bench
