// The sledge rig in Simbody (https://github.com/simbody/simbody), beside boxbeam: the same instants
// by each, times and reactions. Built where Simbody is found; scripts/bench_simbody.sh does it all.
//
//   boxbeam_simbody [INSTANTS PER PERIOD ...]     (24 96 384 where none is given)

#include <fmt/format.h>
#include <time.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "boxbeam/mechanism/planar/constraints.hpp"
#include "boxbeam/mechanism/planar/instant_solver.hpp"
#include "boxbeam/mechanism/planar/reactions.hpp"
#include "boxbeam/project/project.hpp"
#include "simbody_rig.hpp"
#include "version.hpp"

namespace {

using namespace boxbeam;
using Eigen::Vector2d;
using planar::Mechanism;

// ---- the rig, as it is read ---------------------------------------------------------------------

constexpr std::array<const char*, bench::parts> part_names{"ground", "beam",      "upper_rod",
                                                           "blade",  "lower_rod", "sledge"};

/// The pins whose forces are compared, in the order of bench::PinName.
struct Pinned {
  const char* joint;
  bench::Part on;    ///< the body that feels the force
  bench::Part from;  ///< the other
};
constexpr std::array<Pinned, bench::pins> pins{{{"O", bench::beam, bench::ground},
                                                {"B", bench::upper_rod, bench::beam},
                                                {"A", bench::upper_rod, bench::blade},
                                                {"C", bench::lower_rod, bench::beam},
                                                {"E", bench::lower_rod, bench::sledge}}};
using Forces = std::array<Vector2d, pins.size()>;

/// The parts of the sledge rig by name. Throws where the mechanism is another.
class Rig {
 public:
  explicit Rig(Mechanism mechanism) : mechanism_(std::move(mechanism)) {
    const planar::Slider& blade_line = slider("blade_line");
    const planar::Slider& rail = slider("rail");
    if (blade_line.direction != 0.0 || rail.direction != 0.0 || !driver().further.empty()) {
      throw std::runtime_error("this is not the mechanism that the benchmark knows");
    }
  }

  const Mechanism& mechanism() const { return mechanism_; }
  const Body& body(const std::string& name) const {
    return mechanism_.bodies.at(static_cast<std::size_t>(planar::body_index(mechanism_, name)));
  }
  const planar::Slider& slider(const std::string& name) const {
    return std::get<planar::Slider>(joint(name).kind);
  }
  const HarmonicDriver& driver() const {
    return std::get<HarmonicDriver>(std::get<planar::Driven>(joint("exciter").kind).driver);
  }
  /// The point of a pin on one of its two bodies.
  planar::Attachment at(const std::string& pin, const std::string& body_name) const {
    const auto& kind = std::get<planar::Pin>(joint(pin).kind);
    return kind.a.body == planar::body_index(mechanism_, body_name) ? kind.a : kind.b;
  }
  double distance(const char* body_name, const char* pin, const char* other_pin) const {
    return (at(pin, body_name).p - at(other_pin, body_name).p).norm();
  }

  /// The same with another upper rod, still uniform.
  Rig with_upper_rod(double length) const {
    Mechanism changed = mechanism_;
    const double share = length / distance("upper_rod", "B", "A");
    const int rod = planar::body_index(changed, "upper_rod");
    changed.bodies[static_cast<std::size_t>(rod)].inertia *= share * share;
    for (planar::Joint& one : changed.joints) {
      if (auto* pin = std::get_if<planar::Pin>(&one.kind)) {
        if (pin->a.body == rod) pin->a.p *= share;
        if (pin->b.body == rod) pin->b.p *= share;
      }
    }
    return Rig(std::move(changed));
  }

  /// The same with another stroke.
  Rig with_amplitude(double amplitude) const {
    Mechanism changed = mechanism_;
    auto& joint = changed.joints[static_cast<std::size_t>(joint_index(changed, "exciter"))];
    std::get<HarmonicDriver>(std::get<planar::Driven>(joint.kind).driver).amplitude = amplitude;
    return Rig(std::move(changed));
  }

  /// All coordinates in closed form, by the intersection of circles; nothing where these do not
  /// meet.
  std::optional<Eigen::VectorXd> position(double time) const {
    const Vector2d o = at("O", "ground").p;
    const Vector2d a(driver_at(driver(), time).value, slider("blade_line").guide.p.y());
    const double r = distance("beam", "O", "B");
    const double rod = distance("upper_rod", "B", "A");
    const double d = (a - o).norm();
    const double along = (d * d + (r - rod) * (r + rod)) / (2.0 * d);
    const double square = (r - along) * (r + along);
    if (square < 0.0) return {};
    // O, A, B turn counter-clockwise: B to the left of the line from O to A.
    const Vector2d u = (a - o) / d;
    const Vector2d b = o + along * u + std::sqrt(square) * Vector2d(-u.y(), u.x());

    Eigen::VectorXd q(mechanism_.coordinates());
    place(q, "beam", "O", o, "B", b);
    place(q, "upper_rod", "B", b, "A", a);
    const Vector2d c = planar::position_of(at("C", "beam"), q);
    const double y = slider("rail").guide.p.y();
    const double rod_below = distance("lower_rod", "C", "E");
    const double reach = (rod_below - (c.y() - y)) * (rod_below + (c.y() - y));
    if (reach < 0.0) return {};
    const Vector2d e(c.x() + std::sqrt(reach), y);
    place(q, "lower_rod", "C", c, "E", e);
    put(q, "blade", "A", a, 0.0);
    put(q, "sledge", "E", e, 0.0);
    return q;
  }

 private:
  const planar::Joint& joint(const std::string& name) const {
    return mechanism_.joints.at(static_cast<std::size_t>(joint_index(mechanism_, name)));
  }
  void put(Eigen::VectorXd& q, const char* name, const char* pin, const Vector2d& p,
           double angle) const {
    const planar::Attachment on = at(pin, name);
    q.segment<2>(3 * on.body) = p - Eigen::Rotation2Dd(angle) * on.p;
    q[3 * on.body + 2] = angle;
  }
  void place(Eigen::VectorXd& q, const char* name, const char* pin, const Vector2d& p,
             const char* other_pin, const Vector2d& other) const {
    const Vector2d own = at(other_pin, name).p - at(pin, name).p;
    const Vector2d seen = other - p;
    put(q, name, pin, p, std::atan2(seen.y(), seen.x()) - std::atan2(own.y(), own.x()));
  }

  Mechanism mechanism_;
};

// ---- the alternatives ---------------------------------------------------------------------------

/// One way to find instants of the rig, each from the one before.
class Alternative {
 public:
  virtual ~Alternative() = default;
  /// The instant t = 0.
  virtual void start() = 0;
  /// Positions, velocities, accelerations and the forces of the pins. Throws where it refuses.
  virtual void advance(double time, Forces& forces) = 0;
  /// Where B and E are now.
  virtual std::array<Vector2d, 2> places() const = 0;
};

class Boxbeam final : public Alternative {
 public:
  Boxbeam(const Rig& rig, planar::Elimination elimination)
      : rig_(&rig), solver_(rig.mechanism(), elimination) {
    for (const Pinned& pin : pins) {
      wanted_.emplace_back(planar::joint_index(rig.mechanism(), pin.joint),
                           planar::body_index(rig.mechanism(), part_names[pin.on]));
    }
  }

  void start() override {
    state_ = solver_.solve_from_sketch(0.0, planar::sketch_of(rig_->mechanism()));
  }

  void advance(double time, Forces& forces) override {
    solver_.solve_near(time, state_, next_);
    std::swap(state_, next_);
    for (const planar::Reaction& reaction : planar::reactions_of(rig_->mechanism(), state_)) {
      for (std::size_t i = 0; i < wanted_.size(); ++i) {
        if (wanted_[i] == std::pair(reaction.joint, reaction.on)) forces[i] = reaction.force;
      }
    }
  }

  std::array<Vector2d, 2> places() const override {
    return {planar::position_of(rig_->at("B", "upper_rod"), state_.q),
            planar::position_of(rig_->at("E", "lower_rod"), state_.q)};
  }

 private:
  const Rig* rig_;
  planar::InstantSolver solver_;
  std::vector<std::pair<int, int>> wanted_;
  planar::State state_, next_;
};

/// What Simbody needs to know of the rig.
bench::RigData data_of(const Rig& rig) {
  bench::RigData data;
  const auto plain = [](const Vector2d& p) { return bench::Point{p.x(), p.y()}; };
  for (std::size_t part = bench::beam; part < bench::parts; ++part) {
    const Body& body = rig.body(part_names[part]);
    data.content[part] = {body.mass, body.inertia};
  }
  for (std::size_t i = 0; i < data.pin.size(); ++i) {
    const Pinned& pin = pins[i];
    data.pin[i] = {pin.on, pin.from, plain(rig.at(pin.joint, part_names[pin.on]).p),
                   plain(rig.at(pin.joint, part_names[pin.from]).p)};
  }
  data.on_blade_line = plain(rig.slider("blade_line").point.p);
  data.on_rail = plain(rig.slider("rail").point.p);
  data.blade_line = rig.slider("blade_line").guide.p.y();
  data.rail = rig.slider("rail").guide.p.y();
  data.mean = rig.driver().mean;
  data.amplitude = rig.driver().amplitude;
  data.omega = rig.driver().omega;
  data.phase = rig.driver().phase;
  data.gravity = plain(rig.mechanism().gravity);
  return data;
}

class Simbody final : public Alternative {
 public:
  Simbody(const Rig& rig, bench::Model model, bench::Start start_at, double accuracy)
      : rig_(&rig), inside_(data_of(rig), model, start_at, accuracy) {}

  void start() override {
    const Eigen::VectorXd q = rig_->position(0.0).value();
    std::array<bench::PartPosture, bench::parts> postures;
    for (std::size_t part = bench::beam; part < bench::parts; ++part) {
      const Eigen::Index i = 3 * planar::body_index(rig_->mechanism(), part_names[part]);
      postures[part] = {{q[i], q[i + 1]}, q[i + 2]};
    }
    inside_.start(postures);
  }

  void advance(double time, Forces& forces) override {
    inside_.advance(time, plain_);
    for (std::size_t i = 0; i < plain_.size(); ++i) forces[i] = {plain_[i].x, plain_[i].y};
  }

  std::array<Vector2d, 2> places() const override {
    const bench::Point b = inside_.place(bench::pin_b);
    const bench::Point e = inside_.place(bench::pin_e);
    return {Vector2d(b.x, b.y), Vector2d(e.x, e.y)};
  }

 private:
  const Rig* rig_;
  bench::SimbodyRig inside_;
  std::array<bench::Point, bench::pins> plain_;
};

// ---- times and agreement ------------------------------------------------------------------------

/// Processor time of this thread: what others do on the machine counts least here [s].
double processor_time() {
  timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

struct Entrant {
  std::string name;
  double accuracy;  ///< of positions [m]; 0: to round-off
  std::unique_ptr<Alternative> way;
};

std::vector<Entrant> entrants(const Rig& rig) {
  std::vector<Entrant> all;
  const auto simbody = [&](const char* name, bench::Model model, bench::Start start,
                           double accuracy) {
    all.push_back({fmt::format("Simbody, {}, {:.0e}", name, accuracy), accuracy,
                   std::make_unique<Simbody>(rig, model, start, accuracy)});
  };
  all.push_back(
      {"boxbeam, sparse", 0.0, std::make_unique<Boxbeam>(rig, planar::Elimination::sparse)});
  all.push_back(
      {"boxbeam, dense", 0.0, std::make_unique<Boxbeam>(rig, planar::Elimination::dense)});
  simbody("compact tree, predicted", bench::Model::compact_tree, bench::Start::predicted, 1e-10);
  simbody("compact tree, from the last", bench::Model::compact_tree, bench::Start::last, 1e-10);
  simbody("compact tree, predicted", bench::Model::compact_tree, bench::Start::predicted, 1e-6);
  simbody("planar joints, predicted", bench::Model::planar_joints, bench::Start::predicted, 1e-10);
  simbody("planar joints, from the last", bench::Model::planar_joints, bench::Start::last, 1e-10);
  return all;
}

void compare(const Rig& rig, int count) {
  constexpr int repetitions = 9;
  constexpr int instants = 2400;  // of one repetition, at least
  const double period = planar::time_span_of(rig.mechanism()).length;
  const int turns = (instants + count - 1) / count;
  std::vector<Entrant> all = entrants(rig);

  // One turn for the agreement, against the first; positions against the closed form.
  std::vector<Forces> reference(static_cast<std::size_t>(count));
  std::array<double, pins.size()> largest{};
  std::vector<std::array<double, pins.size()>> differences(all.size());
  std::vector<double> off(all.size(), 0.0);
  for (std::size_t k = 0; k < all.size(); ++k) {
    all[k].way->start();
    for (int i = 1; i <= count; ++i) {
      const double time = period * i / count;
      Forces forces;
      all[k].way->advance(time, forces);
      const Eigen::VectorXd right = rig.position(time).value();
      const std::array<Vector2d, 2> places = all[k].way->places();
      const Vector2d b = planar::position_of(rig.at("B", "upper_rod"), right);
      const Vector2d e = planar::position_of(rig.at("E", "lower_rod"), right);
      off[k] = std::max({off[k], (places[0] - b).norm(), (places[1] - e).norm()});
      Forces& known = reference[static_cast<std::size_t>(i - 1)];
      if (k == 0) known = forces;
      for (std::size_t j = 0; j < pins.size(); ++j) {
        largest[j] = std::max(largest[j], known[j].norm());
        differences[k][j] = std::max(differences[k][j], (forces[j] - known[j]).norm());
      }
    }
  }

  std::vector<std::vector<double>> times(all.size());
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    for (std::size_t turn = 0; turn < all.size(); ++turn) {
      const std::size_t k = (turn + static_cast<std::size_t>(repetition)) % all.size();
      Forces forces;
      all[k].way->start();
      const double begin = processor_time();
      for (int i = 1; i <= turns * count; ++i) all[k].way->advance(period * i / count, forces);
      times[k].push_back(1e6 * (processor_time() - begin) / (turns * count));
    }
  }

  fmt::print("\n{} instants per period\n", count);
  fmt::print("{:<44} {:>8} {:>6} {:>9} {:>9} {:>9} {:>3}\n", "", "us each", "ratio", "B, E off",
             "force off", "relative", "at");
  for (std::size_t k = 0; k < all.size(); ++k) {
    std::size_t worst = 0;
    double relative = 0.0;
    for (std::size_t j = 0; j < pins.size(); ++j) {
      if (differences[k][j] > differences[k][worst]) worst = j;
      relative = std::max(relative, differences[k][j] / largest[j]);
    }
    const double time = median(times[k]);
    fmt::print("{:<44} {:>8.2f} {:>6.1f} {:>7.0e} m ", all[k].name, time, time / median(times[0]),
               off[k]);
    if (k == 0) {
      fmt::print("{:>9} {:>9} {:>3}\n", "-", "-", "-");
    } else {
      fmt::print("{:>7.0e} N {:>9.0e} {:>3}\n", differences[k][worst], relative, pins[worst].joint);
    }
  }
  fmt::print("largest forces:");
  for (std::size_t j = 0; j < pins.size(); ++j) {
    fmt::print(" {} {:.0f} N{}", pins[j].joint, largest[j], j + 1 < pins.size() ? "," : "\n");
  }
}

// ---- near the toggle ----------------------------------------------------------------------------

/// Instants by what became of them.
struct Outcomes {
  int right = 0;    ///< the position is that of the closed form, or there is none and it refuses
  int wrong = 0;    ///< another position without a word
  int refused = 0;  ///< refused although there is a position, or after a refusal
  int flipped = 0;  ///< of the wrong ones, those with B on the other branch
};

/// Whether B and E are where the closed form says, and else whether B is its mirror image.
void judge(const Rig& rig, double time, const std::array<Vector2d, 2>& places, Outcomes& outcomes) {
  constexpr double enough = 1e-6;  // [m]; the two branches are 8e-4 m apart at the least
  const std::optional<Eigen::VectorXd> right = rig.position(time);
  if (!right) {
    ++outcomes.wrong;
    return;
  }
  const auto place = [&](const char* pin, const char* body) -> Vector2d {
    return planar::position_of(rig.at(pin, body), *right);
  };
  const Vector2d b = place("B", "upper_rod");
  if ((places[0] - b).norm() < enough && (places[1] - place("E", "lower_rod")).norm() < enough) {
    ++outcomes.right;
    return;
  }
  ++outcomes.wrong;
  const Vector2d o = rig.at("O", "ground").p;
  const Vector2d u = (place("A", "upper_rod") - o).normalized();
  const Vector2d mirrored = o + 2.0 * u.dot(b - o) * u - (b - o);
  if ((places[0] - mirrored).norm() < enough) ++outcomes.flipped;
}

Outcomes follow(const Rig& rig, Alternative& way, int count) {
  const double period = planar::time_span_of(rig.mechanism()).length;
  Outcomes outcomes;
  for (int i = 0; i <= count; ++i) {
    const double time = period * i / count;
    try {
      Forces forces;
      if (i == 0) {
        way.start();
      } else {
        way.advance(time, forces);
      }
    } catch (const std::exception&) {
      const bool rightly = !rig.position(time);
      outcomes.right += rightly ? 1 : 0;
      outcomes.refused = count + 1 - outcomes.right - outcomes.wrong;
      return outcomes;
    }
    judge(rig, time, way.places(), outcomes);
  }
  return outcomes;
}

void near_toggle(const Rig& rig) {
  constexpr int count = 24;
  const HarmonicDriver& driver = rig.driver();
  const Vector2d o = rig.at("O", "ground").p;
  const double y = rig.slider("blade_line").guide.p.y() - o.y();
  const double r = rig.distance("beam", "O", "B");
  const double rod = rig.distance("upper_rod", "B", "A");
  const double shortest = std::hypot(driver.mean + driver.amplitude - o.x(), y) - r;
  const double longest = std::sqrt((r + rod - y) * (r + rod + y)) - driver.mean + o.x();
  constexpr double margin = 1e-6;  // [m]
  const std::array<std::pair<std::string, Rig>, 4> cases{
      {{"rod longer by 1e-6 m than just reaches", rig.with_upper_rod(shortest + margin)},
       {"stroke shorter by 1e-6 m", rig.with_amplitude(longest - margin)},
       {"rod too short by 1e-6 m: no position", rig.with_upper_rod(shortest - margin)},
       {"stroke too long by 1e-6 m: no position", rig.with_amplitude(longest + margin)}}};

  fmt::print("\nNear the toggle of the upper rod, {} instants per period and the end:\n", count);
  fmt::print(
      "right / silently wrong / refused or not reached after a refusal (a right one where there is "
      "no "
      "position)\n");
  fmt::print("{:<44}", "");
  for (std::size_t i = 0; i < cases.size(); ++i) fmt::print(" {:>12}", fmt::format("({})", i + 1));
  fmt::print("\n");
  std::array<std::vector<Entrant>, 4> of_case;
  for (std::size_t i = 0; i < cases.size(); ++i) of_case[i] = entrants(cases[i].second);
  int wrong = 0;
  int flipped = 0;
  for (std::size_t k = 0; k < of_case[0].size(); ++k) {
    if (of_case[0][k].accuracy > 0.01 * margin) continue;  // which would call the margin zero
    fmt::print("{:<44}", of_case[0][k].name);
    for (std::size_t i = 0; i < cases.size(); ++i) {
      const Outcomes outcomes = follow(cases[i].second, *of_case[i][k].way, count);
      wrong += outcomes.wrong;
      flipped += outcomes.flipped;
      fmt::print(" {:>12}",
                 fmt::format("{} / {} / {}", outcomes.right, outcomes.wrong, outcomes.refused));
    }
    fmt::print("\n");
  }
  for (std::size_t i = 0; i < cases.size(); ++i) fmt::print("({}) {}\n", i + 1, cases[i].first);
  fmt::print("Of the {} wrong positions {} are those of the other branch.\n", wrong, flipped);
}

void print_versions() {
  fmt::print("boxbeam {}, Simbody {}, Eigen {}.{}.{}, compiler {}\n", version,
             bench::simbody_version(), EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION,
             EIGEN_MINOR_VERSION, __VERSION__);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    std::vector<int> counts;
    for (int i = 1; i < argc; ++i) counts.push_back(std::atoi(argv[i]));
    if (counts.empty()) counts = {24, 96, 384};
    if (*std::min_element(counts.begin(), counts.end()) < 8) {
      throw std::runtime_error("at least 8 instants per period, please");
    }
    const Rig rig(
        planar_of(read_project(std::string(BOXBEAM_SOURCE_DIR) + "/sections/sledge-rig/rig.toml")));
    print_versions();
    fmt::print(
        "Sledge rig, each instant from the one before: positions, velocities, accelerations and "
        "the forces in O, B, A, C, E.\n"
        "us each: processor time per instant, median of 9 repetitions of 2400 or more instants, "
        "the alternatives in turn.\n"
        "1e-10: Simbody's accuracy, the tolerance of its projection. predicted: the projection "
        "starts from a Taylor series\n"
        "of second order, as boxbeam's Newton does; from the last: from the instant before.\n"
        "B, E off: from the closed form. force off: from boxbeam, sparse; relative: to the "
        "largest force of the same pin.\n");
    near_toggle(rig);
    for (const int count : counts) compare(rig, count);
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 3;
  }
}
