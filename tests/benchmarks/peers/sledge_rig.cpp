#include "peers/sledge_rig.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <variant>

#include "boxbeam/mechanism/planar/constraints.hpp"

namespace peers {

using namespace boxbeam;
using Eigen::Vector2d;

SledgeRig::SledgeRig(planar::Mechanism mechanism) : mechanism_(std::move(mechanism)) {
  if (slider("blade_line").direction != 0.0 || slider("rail").direction != 0.0 ||
      !driver().further.empty()) {
    throw std::runtime_error("this is not the mechanism that the comparison knows");
  }
}

const planar::Joint& SledgeRig::joint(const std::string& name) const {
  return mechanism_.joints.at(static_cast<std::size_t>(joint_index(mechanism_, name)));
}

const planar::Slider& SledgeRig::slider(const std::string& name) const {
  return std::get<planar::Slider>(joint(name).kind);
}

const HarmonicDriver& SledgeRig::driver() const {
  return std::get<HarmonicDriver>(std::get<planar::Driven>(joint("exciter").kind).driver);
}

planar::Attachment SledgeRig::at(const std::string& pin, const std::string& body) const {
  const auto& kind = std::get<planar::Pin>(joint(pin).kind);
  return kind.a.body == planar::body_index(mechanism_, body) ? kind.a : kind.b;
}

double SledgeRig::distance(const char* body, const char* pin, const char* other_pin) const {
  return (at(pin, body).p - at(other_pin, body).p).norm();
}

void SledgeRig::set_upper_rod(double length) {
  const double share = length / distance("upper_rod", "B", "A");
  const int rod = planar::body_index(mechanism_, "upper_rod");
  mechanism_.bodies[static_cast<std::size_t>(rod)].inertia *= share * share;
  for (planar::Joint& one : mechanism_.joints) {
    if (auto* pin = std::get_if<planar::Pin>(&one.kind)) {
      if (pin->a.body == rod) pin->a.p *= share;
      if (pin->b.body == rod) pin->b.p *= share;
    }
  }
}

void SledgeRig::set_amplitude(double amplitude) {
  auto& exciter = mechanism_.joints[static_cast<std::size_t>(joint_index(mechanism_, "exciter"))];
  std::get<HarmonicDriver>(std::get<planar::Driven>(exciter.kind).driver).amplitude = amplitude;
}

std::optional<Eigen::VectorXd> SledgeRig::position(double time) const {
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

void SledgeRig::put(Eigen::VectorXd& q, const char* body, const char* pin, const Vector2d& p,
                    double angle) const {
  const planar::Attachment on = at(pin, body);
  q.segment<2>(3 * on.body) = p - Eigen::Rotation2Dd(angle) * on.p;
  q[3 * on.body + 2] = angle;
}

void SledgeRig::place(Eigen::VectorXd& q, const char* body, const char* pin, const Vector2d& p,
                      const char* other_pin, const Vector2d& other) const {
  const Vector2d own = at(other_pin, body).p - at(pin, body).p;
  const Vector2d seen = other - p;
  put(q, body, pin, p, std::atan2(seen.y(), seen.x()) - std::atan2(own.y(), own.x()));
}

bench::RigData SledgeRig::data() const {
  bench::RigData data;
  const auto plain = [](const Vector2d& p) { return bench::Point{p.x(), p.y()}; };
  for (std::size_t part = bench::beam; part < bench::parts; ++part) {
    const auto i = static_cast<std::size_t>(planar::body_index(mechanism_, part_names[part]));
    data.content[part] = {mechanism_.bodies[i].mass, mechanism_.bodies[i].inertia};
  }
  for (std::size_t i = 0; i < data.pin.size(); ++i) {
    const Pinned& pin = pins[i];
    data.pin[i] = {pin.on, pin.from, plain(at(pin.joint, part_names[pin.on]).p),
                   plain(at(pin.joint, part_names[pin.from]).p)};
  }
  data.on_blade_line = plain(slider("blade_line").point.p);
  data.on_rail = plain(slider("rail").point.p);
  data.blade_line = slider("blade_line").guide.p.y();
  data.rail = slider("rail").guide.p.y();
  data.mean = driver().mean;
  data.amplitude = driver().amplitude;
  data.omega = driver().omega;
  data.phase = driver().phase;
  data.gravity = plain(mechanism_.gravity);
  return data;
}

}  // namespace peers
