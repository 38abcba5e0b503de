// Closed loops in space in a row, solved at the same instants by boxbeam, Simbody and Pinocchio by
// turns in one process: positions, rates, accelerations of all bodies and what all joints bear.
// closed_chain.sh builds and runs it.
//
// A loop is a crank and a rocker on skew axes of the ground and a coupler between them, on a
// universal joint on the crank and a spherical one on the rocker (RUSR: one degree of freedom, no
// redundant equation). The rocker of one loop is the crank of the next; the first crank is driven.
//
// boxbeam: `Chain::at` and `joint_wrenches`. Simbody: a tree of the same joints, each loop closed
// by a ball constraint, the crank by a prescribed motion; assembled, projected, realized to
// accelerations, then the reactions of all mobilizers. Pinocchio has no kinematically driven loops:
// written here on its Jacobians and rnea are Newton's method on the closing equations, rates and
// accelerations, multipliers and a second rnea, with Eigen's sparse LU (columns ordered once).
// Simbody is compiled with its assertions, as Debian has it; the others without.

#include <Eigen/SparseLU>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <pinocchio/algorithm/frames.hpp>
#include <pinocchio/algorithm/jacobian.hpp>
#include <pinocchio/algorithm/kinematics.hpp>
#include <pinocchio/algorithm/rnea.hpp>
#include <pinocchio/multibody.hpp>
#include <vector>

#include "boxbeam/mechanism/spatial/chain.hpp"
#include "closed_chain_simbody.hpp"
#include "support/random_tree.hpp"

namespace {

using namespace bench;
using namespace boxbeam;
using namespace boxbeam::spatial;
using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double swing = 0.3, frequency = 2.0;  // of the first crank [rad, rad/s]

/// In order: crank, then for every loop a rocker, a massless frame of the universal joint, a
/// coupler. Joint i carries body i.
Mechanism row_of(int loops) {
  test::Chance chance(7);
  Mechanism row;
  row.gravity = {1.0, -2.0, -9.81};
  const auto add_body = [&](double mass) {
    const int index = static_cast<int>(row.bodies.size());
    Body body{"b" + std::to_string(index), mass};
    if (mass > 0.0) {
      body.centre = Vector3d(0.0, 0.0, 0.5) + chance.vector(0.1);
      body.inertia = chance.inertia(mass, 0.3);
    }
    row.bodies.push_back(body);
    return index;
  };
  const auto add_crank = [&](double x) {
    const int index = add_body(3.0);
    Joint joint{"crank", JointKind::revolute, ground, {x, 0.0, 0.0}};
    joint.axis = (Vector3d::UnitY() + chance.vector(0.15)).normalized();
    joint.moved_by = MovedBy::loops;
    row.joints.push_back(joint);
    return index;
  };
  int last = add_crank(0.0);
  row.joints[0].driver = HarmonicDriver{0.0, swing, frequency, 0.0, {}};
  row.joints[0].driver_name = "motor";
  row.joints[0].moved_by = MovedBy::driver;
  for (int i = 1; i <= loops; ++i) {
    const int rocker = add_crank(i);
    const int frame = add_body(0.0);
    Joint first{"universal.1", JointKind::revolute, last, {0.0, 0.0, 1.0}};
    first.axis = Vector3d::UnitY();
    first.moved_by = MovedBy::loops;
    row.joints.push_back(first);
    const int coupler = add_body(2.0);
    Joint second{"universal.2", JointKind::revolute, frame};
    second.axis = Vector3d::UnitZ();
    second.moved_by = MovedBy::loops;
    row.joints.push_back(second);
    row.bodies[static_cast<std::size_t>(coupler)].centre = {0.5, 0.0, 0.0};
    ClosingJoint closing;
    closing.name = "ball" + std::to_string(i);
    closing.kind = ClosingKind::spherical;
    closing.a = {coupler, {1.0, 0.0, 0.0}};
    closing.b = {rocker, {0.0, 0.0, 1.0}};
    row.closing.push_back(closing);
    last = rocker;
  }
  row.duration = {};
  return row;
}

/// All that is compared of an instant.
struct Answer {
  std::vector<double> coordinates, rates, accelerations;
  std::vector<Vector3d> forces;  ///< of the joints on the bodies that they carry, then of the loops
  double drive = 0.0;
};

class ByBoxbeam {
 public:
  explicit ByBoxbeam(const Mechanism& row) : row_(row), chain_(row) {}
  void solve(double time) {
    chain_.at(time, state_);
    chain_.joint_wrenches(state_, wrenches_);
  }
  Answer answer() const {
    Answer of;
    for (const DriverState& q : state_.coordinates) {
      of.coordinates.push_back(q.value);
      of.rates.push_back(q.rate);
      of.accelerations.push_back(q.acceleration);
    }
    for (const Wrench& wrench : wrenches_) of.forces.push_back(wrench.force);
    of.drive = chain_.along_axis(state_, 0, wrenches_[0]);
    return of;
  }

 private:
  const Mechanism& row_;
  Chain chain_;
  State state_;
  std::vector<Wrench> wrenches_;
};

/// The same row as Simbody wants it.
ClosedRow plain(const Mechanism& row) {
  const auto vector = [](const Vector3d& of) { return std::array{of.x(), of.y(), of.z()}; };
  ClosedRow plain;
  plain.gravity = vector(row.gravity);
  plain.swing = swing;
  plain.frequency = frequency;
  for (std::size_t i = 0; i < row.joints.size(); ++i) {
    const Joint& joint = row.joints[i];
    const Body& body = row.bodies[i];
    const Matrix3d& I = body.inertia;
    plain.bodies.push_back({joint.parent,
                            vector(joint.at),
                            vector(joint.axis),
                            body.mass,
                            vector(body.centre),
                            {I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2)}});
  }
  for (const ClosingJoint& closing : row.closing)
    plain.balls.push_back(
        {closing.a.body, closing.b.body, vector(closing.a.p), vector(closing.b.p)});
  return plain;
}

Answer answer_of(const SimbodyRow& simbody) {
  const SimbodyAnswer of = simbody.answer();
  Answer answer{of.coordinates, of.rates, of.accelerations, {}, of.drive};
  for (const auto& force : of.forces) answer.forces.emplace_back(force[0], force[1], force[2]);
  return answer;
}

class ByPinocchio {
 public:
  explicit ByPinocchio(const Mechanism& row) : row_(row) {
    model_.gravity.linear() = row.gravity;
    // It wants what a body carries right behind it.
    index_.resize(row.joints.size());
    add_carried_by(ground, 0);
    data_ = pinocchio::Data(model_);
    const auto n = static_cast<Eigen::Index>(row.joints.size());
    q_ = v_ = a_ = Eigen::VectorXd::Zero(n);
    external_.assign(model_.njoints, pinocchio::Force::Zero());
    // Which coordinates move an end of a loop.
    for (const ClosingJoint& closing : row.closing) {
      std::vector<std::pair<std::size_t, int>> ways;
      for (const auto& [end, sign] : {std::pair{closing.a, -1}, std::pair{closing.b, 1}})
        for (int at = end.body; at >= 0; at = row.joints[static_cast<std::size_t>(at)].parent)
          ways.push_back({static_cast<std::size_t>(at), sign});
      ways_.push_back(ways);
    }
  }
  void start(const Answer& at) {
    for (std::size_t i = 0; i < index_.size(); ++i) q_[v_at(i)] = at.coordinates[i];
  }
  void solve(double time) {
    const DriverState crank = driver_at(row_.joints[0].driver, time);
    q_[v_at(0)] = crank.value;
    const auto count = static_cast<Eigen::Index>(3 * ways_.size());
    Eigen::VectorXd gap(count);
    for (int step = 0; step < 12; ++step) {
      pinocchio::forwardKinematics(model_, data_, q_);
      factorise();
      for (std::size_t k = 0; k < ways_.size(); ++k)
        gap.segment<3>(static_cast<Eigen::Index>(3 * k)) =
            place(row_.closing[k].b) - place(row_.closing[k].a);
      const Eigen::VectorXd correction = lu_.solve(-gap);
      spread(correction, q_);
      if (correction.cwiseAbs().maxCoeff() < 1e-11) break;  // squared by this step
    }
    v_.setZero();
    v_[v_at(0)] = crank.rate;
    a_.setZero();
    a_[v_at(0)] = crank.acceleration;
    pinocchio::forwardKinematics(model_, data_, q_, v_);
    factorise();
    each_gap(gap, [&](const Attachment& at) { return velocity(at); });
    spread(lu_.solve(-gap), v_);
    pinocchio::forwardKinematics(model_, data_, q_, v_, a_);
    each_gap(gap, [&](const Attachment& at) { return acceleration(at); });
    spread(lu_.solve(-gap), a_);
    std::fill(external_.begin(), external_.end(), pinocchio::Force::Zero());
    pinocchio::rnea(model_, data_, q_, v_, a_);
    Eigen::VectorXd needed(count);
    for (std::size_t i = 1; i < index_.size(); ++i)
      needed[static_cast<Eigen::Index>(i - 1)] = data_.tau[v_at(i)];
    multipliers_ = lu_.transpose().solve(needed);
    for (std::size_t k = 0; k < ways_.size(); ++k) {
      const Vector3d force = multipliers_.segment<3>(static_cast<Eigen::Index>(3 * k));
      press(row_.closing[k].a, -force);
      press(row_.closing[k].b, force);
    }
    pinocchio::rnea(model_, data_, q_, v_, a_, external_);
  }
  Answer answer() const {
    Answer of;
    for (std::size_t i = 0; i < index_.size(); ++i) {
      of.coordinates.push_back(q_[v_at(i)]);
      of.rates.push_back(v_[v_at(i)]);
      of.accelerations.push_back(a_[v_at(i)]);
      of.forces.push_back(data_.oMi[index_[i]].rotation() * data_.f[index_[i]].linear());
    }
    for (std::size_t k = 0; k < ways_.size(); ++k)
      of.forces.push_back(multipliers_.segment<3>(static_cast<Eigen::Index>(3 * k)));
    of.drive = data_.tau[v_at(0)];
    return of;
  }

 private:
  void add_carried_by(int body, pinocchio::JointIndex parent) {
    for (std::size_t i = 0; i < row_.joints.size(); ++i) {
      const Joint& joint = row_.joints[i];
      if (joint.parent != body) continue;
      index_[i] =
          model_.addJoint(parent, pinocchio::JointModelRevoluteUnaligned(joint.axis),
                          pinocchio::SE3(Matrix3d::Identity(), joint.at), "j" + std::to_string(i));
      const Body& of = row_.bodies[i];
      model_.appendBodyToJoint(index_[i], pinocchio::Inertia(of.mass, of.centre, of.inertia));
      add_carried_by(static_cast<int>(i), index_[i]);
    }
  }
  Eigen::Index v_at(std::size_t joint) const { return model_.idx_vs[index_[joint]]; }
  const pinocchio::SE3& pose(int body) const {
    return data_.oMi[index_[static_cast<std::size_t>(body)]];
  }
  Vector3d place(const Attachment& at) const { return pose(at.body).act(at.p); }
  Vector3d velocity(const Attachment& at) const {
    const pinocchio::Motion& v = data_.v[index_[static_cast<std::size_t>(at.body)]];
    return pose(at.body).rotation() * (v.linear() + v.angular().cross(at.p));
  }
  Vector3d acceleration(const Attachment& at) const {
    const auto i = index_[static_cast<std::size_t>(at.body)];
    const pinocchio::Motion &v = data_.v[i], &a = data_.a[i];
    const Vector3d w = v.angular();
    return pose(at.body).rotation() *
           (a.linear() + w.cross(v.linear()) + a.angular().cross(at.p) + w.cross(w.cross(at.p)));
  }
  void each_gap(Eigen::VectorXd& gap, const auto& of) const {
    for (std::size_t k = 0; k < ways_.size(); ++k)
      gap.segment<3>(static_cast<Eigen::Index>(3 * k)) =
          of(row_.closing[k].b) - of(row_.closing[k].a);
  }
  void spread(const Eigen::VectorXd& of_free, Eigen::VectorXd& to) const {
    for (std::size_t i = 1; i < index_.size(); ++i)
      to[v_at(i)] += of_free[static_cast<Eigen::Index>(i - 1)];
  }
  /// The gradient of the gaps by all coordinates but the driven one.
  void factorise() {
    entries_.clear();
    for (std::size_t k = 0; k < ways_.size(); ++k) {
      for (const auto& [joint, sign] : ways_[k]) {
        if (joint == 0) continue;
        const Attachment& end = sign > 0 ? row_.closing[k].b : row_.closing[k].a;
        const pinocchio::SE3& frame = data_.oMi[index_[joint]];
        const Vector3d axis = frame.rotation() * row_.joints[joint].axis;
        const Vector3d column = sign * axis.cross(place(end) - frame.translation());
        for (int row = 0; row < 3; ++row)
          entries_.emplace_back(static_cast<int>(3 * k) + row, static_cast<int>(joint - 1),
                                column[row]);
      }
    }
    const auto count = static_cast<Eigen::Index>(3 * ways_.size());
    J_.resize(count, count);
    J_.setFromTriplets(entries_.begin(), entries_.end());
    if (!ordered_) lu_.analyzePattern(J_);
    ordered_ = true;
    lu_.factorize(J_);
  }
  void press(const Attachment& at, const Vector3d& force) {
    const Vector3d local = pose(at.body).rotation().transpose() * force;
    external_[index_[static_cast<std::size_t>(at.body)]] +=
        pinocchio::Force(local, at.p.cross(local));
  }

  const Mechanism& row_;
  pinocchio::Model model_;
  pinocchio::Data data_;
  std::vector<pinocchio::JointIndex> index_;  ///< of every body
  std::vector<std::vector<std::pair<std::size_t, int>>> ways_;
  Eigen::VectorXd q_, v_, a_, multipliers_;
  std::vector<Eigen::Triplet<double>> entries_;
  Eigen::SparseMatrix<double> J_;
  Eigen::SparseLU<Eigen::SparseMatrix<double>> lu_;
  bool ordered_ = false;
  pinocchio::container::aligned_vector<pinocchio::Force> external_;
};

/// The largest difference over the largest value, of rates and accelerations and forces likewise.
struct Deviation {
  double motion = 0.0, forces = 0.0;
};

Deviation between(const Answer& ours, const Answer& other) {
  Deviation of;
  for (const auto part : {&Answer::coordinates, &Answer::rates, &Answer::accelerations}) {
    double difference = 0.0, size = 0.0;
    for (std::size_t i = 0; i < (ours.*part).size(); ++i) {
      difference = std::max(difference, std::abs((ours.*part)[i] - (other.*part)[i]));
      size = std::max(size, std::abs((ours.*part)[i]));
    }
    of.motion = std::max(of.motion, difference / size);
  }
  double difference = std::abs(ours.drive - other.drive), size = std::abs(ours.drive);
  for (std::size_t i = 0; i < ours.forces.size(); ++i) {
    difference = std::max(difference, (ours.forces[i] - other.forces[i]).cwiseAbs().maxCoeff());
    size = std::max(size, ours.forces[i].cwiseAbs().maxCoeff());
  }
  of.forces = difference / size;
  return of;
}

using Clock = std::chrono::steady_clock;

double median_of(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

void compare(int loops) {
  const Mechanism row = row_of(loops);
  const auto before = Clock::now();
  ByBoxbeam ours(row);
  const std::chrono::duration<double> prepared = Clock::now() - before;
  bench::SimbodyRow simbody(plain(row), 1e-12);
  ByPinocchio pinocchio(row);
  ours.solve(0.0);
  const Answer first = ours.answer();
  simbody.start(first.coordinates, first.rates);
  pinocchio.start(first);
  // A small step ahead of the one before, as all three use it to begin with. All times of a round
  // are those of one instant by turns.
  std::vector<double> us, by_simbody, by_pinocchio;
  Deviation worst_simbody, worst_pinocchio;
  const int rounds = loops > 30 ? 40 : loops > 3 ? 200 : 1000;
  for (int i = 1; i <= rounds; ++i) {
    const double time = 1e-3 * i;
    const auto timed = [&](auto& of, std::vector<double>& times) {
      const auto start = Clock::now();
      of.solve(time);
      times.push_back(std::chrono::duration<double, std::micro>(Clock::now() - start).count());
    };
    timed(ours, us);
    timed(simbody, by_simbody);
    timed(pinocchio, by_pinocchio);
    const auto keep = [](Deviation& worst, const Deviation& of) {
      worst = {std::max(worst.motion, of.motion), std::max(worst.forces, of.forces)};
    };
    const Answer answer = ours.answer();
    keep(worst_simbody, between(answer, answer_of(simbody)));
    keep(worst_pinocchio, between(answer, pinocchio.answer()));
  }
  const double one = median_of(us), two = median_of(by_simbody), three = median_of(by_pinocchio);
  std::printf("%5d %9.3f %11.1f %11.1f %11.1f %8.2f %8.2f %9.0e %9.0e %9.0e %9.0e\n", loops,
              prepared.count(), one, two, three, two / one, three / one, worst_simbody.motion,
              worst_simbody.forces, worst_pinocchio.motion, worst_pinocchio.forces);
  std::fflush(stdout);
}

}  // namespace

int main(int count, char** words) {
  std::printf("%5s %9s %11s %11s %11s %8s %8s %19s %19s\n", "loops", "prepared", "boxbeam",
              "Simbody", "Pinocchio", "Simbody", "Pinocch.", "Simbody differs in", "Pinocchio in");
  std::printf("%5s %9s %11s %11s %11s %17s %9s %9s %9s %9s\n", "", "s", "us/instant", "us/instant",
              "us/instant", "over boxbeam", "motion", "forces", "motion", "forces");
  std::vector<int> sizes{1, 3, 10, 30, 100};
  if (count > 1) sizes.clear();
  for (int i = 1; i < count; ++i) sizes.push_back(std::atoi(words[i]));
  for (const int loops : sizes) compare(loops);
}
