#include "boxbeam/report/motion_csv.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <utility>
#include <vector>

#include "boxbeam/core/error.hpp"
#include "csv_cells.hpp"

namespace boxbeam {
namespace {

/// The names of columns, from the first row, and the cells of one row after the other.
class MotionColumns {
 public:
  /// Cells of a row in its order; the first row names the columns.
  void add(const std::string& of, const char* quantity, const char* unit, double value) {
    name(of, quantity, unit);
    row_.push_back(report::csv_cell(value));
  }
  void add_unknown(const std::string& of, const char* quantity, const char* unit) {
    name(of, quantity, unit);
    row_.emplace_back();
  }
  void add(const std::string& of, std::initializer_list<const char*> quantities, const char* unit,
           const Eigen::Vector3d& value, bool known = true) {
    const double* component = value.data();
    for (const char* quantity : quantities) {
      if (known) {
        add(of, quantity, unit, *component);
      } else {
        add_unknown(of, quantity, unit);
      }
      ++component;
    }
  }
  void end_row() {
    if (text_.empty()) text_ = report::csv_row(names_);
    text_ += report::csv_row(row_);
    row_.clear();
  }
  std::string text() && { return std::move(text_); }

 private:
  void name(const std::string& of, const char* quantity, const char* unit) {
    if (!text_.empty()) return;
    names_.push_back(
        report::csv_cell(fmt::format("{}{}{} [{}]", of, of.empty() ? "" : " ", quantity, unit)));
  }

  std::vector<std::string> names_, row_;
  std::string text_;
};

std::string felt_by(const std::string& joint, const std::string& body) {
  return fmt::format("{} on {}", joint, body);
}

void put_instant(MotionColumns& to, const InstantResult& state) {
  for (const BodyMotion& body : state.bodies) {
    to.add(body.name, "x", "m", body.position.x());
    to.add(body.name, "y", "m", body.position.y());
    to.add(body.name, "angle", "rad", body.position.z());
  }
  for (const JointReaction& of : state.reactions) {
    const std::string on = felt_by(of.joint, of.on);
    to.add(on, {"Fx", "Fy"}, "N", {of.force.x(), of.force.y(), 0.0}, of.unique);
    to.add(on, {"M"}, "N m", {of.moment, 0.0, 0.0}, of.unique);
  }
}

void put_instant(MotionColumns& to, const ChainInstant& state) {
  for (const ChainBody& body : state.bodies) {
    to.add(body.name, {"x", "y", "z"}, "m", body.position);
    Eigen::Quaterniond turn(body.rotation);
    if (turn.w() < 0.0) turn.coeffs() = -turn.coeffs();
    to.add(body.name, "qw", "1", turn.w());
    to.add(body.name, {"qx", "qy", "qz"}, "1", turn.vec());
  }
  for (const ChainJoint& joint : state.joints) {
    if (joint.coordinate) {
      to.add(joint.name, "coordinate", joint.turns ? "rad" : "m", joint.coordinate->value);
    }
  }
  for (const ChainJoint& joint : state.joints) {
    const std::string on = felt_by(joint.name, joint.on);
    to.add(on, {"Fx", "Fy", "Fz"}, "N", joint.force, joint.unique);
    to.add(on, {"Mx", "My", "Mz"}, "N m", joint.moment, joint.unique);
  }
}

std::string csv_of(const auto& motion) {
  MotionColumns columns;
  for (const auto& state : motion.states) {
    columns.add("", "time", "s", state.time);
    put_instant(columns, state);
    columns.end_row();
  }
  return std::move(columns).text();
}

std::string csv_of(const FlexibleMotionResult&) {
  throw InputError("elastic links have no instants to be written as rows", "leave out --csv");
}

}  // namespace

std::string motion_csv(const AnyMotionResult& motion) {
  return std::visit([](const auto& of) { return csv_of(of); }, motion);
}

}  // namespace boxbeam
