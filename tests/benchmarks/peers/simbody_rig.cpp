// Compile as C++17: `==` of an index type of Simbody 3.7 is ambiguous in C++20. And without NDEBUG,
// as Debian's package is: classes of its headers have other members with it, and a program compiled
// so crashes against the package.

#include "peers/simbody_rig.hpp"

#include <Simbody.h>

namespace bench {
namespace {

SimTK::Vec3 in_space(const Point& p) { return SimTK::Vec3(p.x, p.y, 0.0); }
Point in_plane(const SimTK::Vec3& p) { return {p[0], p[1]}; }

constexpr std::array<Part, 4> moved{beam, upper_rod, lower_rod, sledge};  // all but the blade

}  // namespace

class SimbodyRig::Inside {
 public:
  Inside(const RigData& data, Model model, Start start_at, double accuracy)
      : data_(data),
        model_(model),
        start_at_(start_at),
        accuracy_(accuracy),
        matter_(system_),
        forces_(system_),
        gravity_(forces_, matter_, in_space(data.gravity)) {
    body(ground) = matter_.updGround();
    body(blade) =
        SimTK::MobilizedBody::Slider(body(ground), SimTK::Vec3(data.mean, data.blade_line, 0.0),
                                     content(blade), in_space(data.on_blade_line));
    motion_ = SimTK::Motion::Sinusoid(body(blade), SimTK::Motion::Position, data.amplitude,
                                      data.omega, data.phase);
    if (model == Model::compact_tree) {
      build_tree();
    } else {
      build_planar();
    }
    state_ = system_.realizeTopology();
  }

  void start(double time, const std::array<PartPosture, parts>& at) {
    set(time, at);
    solve();
  }

  void assemble(double time, const std::array<PartPosture, parts>& at) {
    set(time, at);
    system_.realize(state_, SimTK::Stage::Time);
    system_.prescribeQ(state_);
    SimTK::Assembler(system_).setAccuracy(accuracy_).assemble(state_);
    solve();
  }

  void advance(double time, std::array<Point, pins>& forces) {
    if (start_at_ == Start::predicted) {
      const double dt = time - state_.getTime();
      q_ = state_.getQ();
      const SimTK::Vector& rate = state_.getQDot();
      const SimTK::Vector& acceleration = state_.getQDotDot();
      for (int i = 0; i < q_.size(); ++i) q_[i] += dt * (rate[i] + 0.5 * dt * acceleration[i]);
      state_.updQ() = q_;
    }
    state_.setTime(time);
    solve();
    for (int pin = 0; pin < pins; ++pin) forces[pin] = force_of(pin);
  }

  Point place(PinName pin) const {
    const PinData& own = data_.pin[pin];
    return in_plane(body(own.on).findStationLocationInGround(state_, in_space(own.at_on)));
  }

 private:
  /// A pin by two constraints: its point on one body lies in two planes of the other.
  struct Closure {
    SimTK::Constraint::PointInPlane x, y;
    bool used = false;
  };

  SimTK::MobilizedBody& body(Part part) { return bodies_[part]; }
  const SimTK::MobilizedBody& body(Part part) const { return bodies_[part]; }

  /// Mass and inertia. The sledge, which does not turn, has no inertia: where it has an angle for a
  /// coordinate, some is needed for a regular matrix, and any is right.
  SimTK::Body::Rigid content(Part part) const {
    const RigData::Content& own = data_.content[part];
    const double inertia = part == sledge ? own.mass : own.inertia;
    return SimTK::Body::Rigid(
        SimTK::MassProperties(own.mass, SimTK::Vec3(0), SimTK::Inertia(inertia, inertia, inertia)));
  }

  void close(PinName pin) {
    const PinData& own = data_.pin[pin];
    Closure& closure = closures_[pin];
    const SimTK::Vec3 follower = in_space(own.at_on);
    closure.x = SimTK::Constraint::PointInPlane(body(own.from), SimTK::UnitVec3(SimTK::XAxis),
                                                own.at_from.x, body(own.on), follower);
    closure.y = SimTK::Constraint::PointInPlane(body(own.from), SimTK::UnitVec3(SimTK::YAxis),
                                                own.at_from.y, body(own.on), follower);
    closure.used = true;
  }

  void join(PinName pin) {
    const PinData& own = data_.pin[pin];
    body(own.on) = SimTK::MobilizedBody::Pin(body(own.from), in_space(own.at_from), content(own.on),
                                             in_space(own.at_on));
  }

  void build_tree() {
    join(pin_o);
    join(pin_a);
    join(pin_c);
    body(sledge) = SimTK::MobilizedBody::Slider(body(ground), SimTK::Vec3(0.0, data_.rail, 0.0),
                                                content(sledge), in_space(data_.on_rail));
    close(pin_b);
    close(pin_e);
  }

  void build_planar() {
    for (const Part part : moved) {
      body(part) = SimTK::MobilizedBody::Planar(body(ground), SimTK::Transform(), content(part),
                                                SimTK::Transform());
    }
    for (const PinName pin : {pin_o, pin_b, pin_a, pin_c, pin_e}) close(pin);
    SimTK::Constraint::PointInPlane(body(ground), SimTK::UnitVec3(SimTK::YAxis), data_.rail,
                                    body(sledge), in_space(data_.on_rail));
    SimTK::Constraint::ConstantCoordinate(body(sledge), SimTK::MobilizerQIndex(0), 0.0);
  }

  void set(double time, const std::array<PartPosture, parts>& at) {
    state_.setTime(time);
    if (model_ == Model::compact_tree) {
      body(upper_rod).setOneQ(state_, 0, at[upper_rod].angle);
      body(beam).setOneQ(state_, 0, at[beam].angle);
      body(lower_rod).setOneQ(state_, 0, at[lower_rod].angle - at[beam].angle);
      body(sledge).setOneQ(state_, 0, at[sledge].centre.x + data_.on_rail.x);
    } else {
      for (const Part part : moved) {
        const PartPosture& own = at[part];
        body(part).setQFromVector(
            state_, SimTK::Vector(SimTK::Vec3(own.angle, own.centre.x, own.centre.y)));
      }
    }
  }

  void solve() {
    system_.project(state_, accuracy_);
    system_.realize(state_, SimTK::Stage::Acceleration);
  }

  Point force_of(int pin) const {
    const PinData& own = data_.pin[pin];
    const Closure& closure = closures_[pin];
    if (!closure.used) {
      return in_plane(body(own.on).findMobilizerReactionOnBodyAtMInGround(state_)[1]);
    }
    // The force of a constraint is against its multiplier. (getForceOnFollowerPoint() is declared
    // in the header and defined nowhere.)
    const SimTK::Vec3 force(-closure.x.getMultiplier(state_), -closure.y.getMultiplier(state_),
                            0.0);
    return in_plane(body(own.from).getBodyRotation(state_) * force);
  }

  RigData data_;
  Model model_;
  Start start_at_;
  double accuracy_;
  SimTK::MultibodySystem system_;
  SimTK::SimbodyMatterSubsystem matter_;
  SimTK::GeneralForceSubsystem forces_;
  SimTK::Force::UniformGravity gravity_;
  SimTK::Motion::Sinusoid motion_;
  std::array<SimTK::MobilizedBody, parts> bodies_;
  std::array<Closure, pins> closures_;
  SimTK::State state_;
  SimTK::Vector q_;
};

SimbodyRig::SimbodyRig(const RigData& data, Model model, Start start, double accuracy)
    : inside_(std::make_unique<Inside>(data, model, start, accuracy)) {}
SimbodyRig::~SimbodyRig() = default;

void SimbodyRig::start(double time, const std::array<PartPosture, parts>& postures) {
  inside_->start(time, postures);
}
void SimbodyRig::assemble(double time, const std::array<PartPosture, parts>& postures) {
  inside_->assemble(time, postures);
}
void SimbodyRig::advance(double time, std::array<Point, pins>& forces) {
  inside_->advance(time, forces);
}
Point SimbodyRig::place(PinName pin) const { return inside_->place(pin); }

std::string simbody_version() {
  int major = 0, minor = 0, patch = 0;
  SimTK_version_simbody(&major, &minor, &patch);
  return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(patch);
}

}  // namespace bench
