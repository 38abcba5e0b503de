// As simbody_rig.cpp: C++17, without NDEBUG.

#include "peers/simbody_linkage.hpp"

#include <Simbody.h>

namespace bench {
namespace {

using SimTK::Vec3;

constexpr double g = 9.81;

}  // namespace

class SimbodyLinkage::Inside {
 public:
  explicit Inside(Linkage linkage)
      : matter_(system_), forces_(system_), gravity_(forces_, matter_, Vec3(0.0, -g, 0.0)) {
    if (linkage == Linkage::pendulum) {
      build_pendulum();
    } else {
      build_four_bars();
    }
    first_ = system_.realizeTopology();
    if (linkage == Linkage::four_bars) {
      // Cranks upright, couplers level; the cranks turn at 1 rad/s to the right.
      for (int i = 0; i <= N; ++i) bodies_[i].setOneQ(first_, 0, SimTK::Pi / 2.0);
      for (int i = 0; i <= N; ++i) bodies_[i].setOneU(first_, 0, -1.0);
      for (int i = 0; i < N; ++i) bodies_[N + 1 + i].setOneQ(first_, 0, -SimTK::Pi / 2.0);
      for (int i = 0; i < N; ++i) bodies_[N + 1 + i].setOneU(first_, 0, 1.0);
    }
  }

  LinkageResult run(double time, double accuracy) const {
    SimTK::RungeKuttaMersonIntegrator integrator(system_);
    integrator.setAccuracy(accuracy);
    SimTK::TimeStepper stepper(system_, integrator);
    const int before = system_.getNumRealizationsOfThisStage(SimTK::Stage::Acceleration);
    stepper.initialize(first_);
    stepper.stepTo(time);
    const Vec3 point = bodies_.front().findStationLocationInGround(stepper.getState(), looked_at_);
    return {point[0], point[1],
            system_.getNumRealizationsOfThisStage(SimTK::Stage::Acceleration) - before};
  }

 private:
  static constexpr int N = 2;

  /// A point of 1 kg at 1 m from the pin, to the left of it.
  void build_pendulum() {
    const SimTK::Body::Rigid point(
        SimTK::MassProperties(1.0, Vec3(0.0), SimTK::Inertia(0.0, 0.0, 0.0)));
    bodies_.push_back(SimTK::MobilizedBody::Pin(matter_.updGround(), SimTK::Transform(), point,
                                                SimTK::Transform(Vec3(1.0, 0.0, 0.0))));
  }

  /// Cranks and, behind them, couplers in a tree; two equations close each loop.
  void build_four_bars() {
    const SimTK::Body::Rigid rod(
        SimTK::MassProperties(1.0, Vec3(0.0), SimTK::Inertia(1.0 / 12.0, 1.0 / 12.0, 1.0 / 12.0)));
    const SimTK::Transform start(Vec3(-0.5, 0.0, 0.0));
    const Vec3 end(0.5, 0.0, 0.0);
    for (int i = 0; i <= N; ++i) {
      bodies_.push_back(SimTK::MobilizedBody::Pin(matter_.updGround(),
                                                  SimTK::Transform(Vec3(i, 0.0, 0.0)), rod, start));
    }
    for (int i = 0; i < N; ++i) {
      bodies_.push_back(SimTK::MobilizedBody::Pin(bodies_[i], SimTK::Transform(end), rod, start));
      for (const SimTK::CoordinateAxis& axis :
           {SimTK::CoordinateAxis(SimTK::XAxis), SimTK::CoordinateAxis(SimTK::YAxis)}) {
        SimTK::Constraint::PointInPlane(bodies_[N + 1 + i], SimTK::UnitVec3(axis), end[axis],
                                        bodies_[i + 1], end);
      }
    }
    looked_at_ = end;
  }

  SimTK::MultibodySystem system_;
  SimTK::SimbodyMatterSubsystem matter_;
  SimTK::GeneralForceSubsystem forces_;
  SimTK::Force::UniformGravity gravity_;
  std::vector<SimTK::MobilizedBody> bodies_;
  Vec3 looked_at_ = Vec3(0.0);
  SimTK::State first_;
};

SimbodyLinkage::SimbodyLinkage(Linkage linkage) : inside_(std::make_unique<Inside>(linkage)) {}
SimbodyLinkage::~SimbodyLinkage() = default;

LinkageResult SimbodyLinkage::run(double time, double accuracy) const {
  return inside_->run(time, accuracy);
}

}  // namespace bench
