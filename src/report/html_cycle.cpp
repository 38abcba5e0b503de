#include "html_cycle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <span>
#include <vector>

#include "boxbeam/core/code_points.hpp"
#include "boxbeam/report/format.hpp"
#include "html_text.hpp"
#include "json_number.hpp"
#include "svg_posture.hpp"

namespace boxbeam::report::html {
namespace {

struct Quantity {
  cut_force::Index which;
  const char* plane_name;  ///< nullptr: only in space
  const char* space_name;
  const char* unit;
};

constexpr Quantity quantities[] = {
    {cut_force::N, "N", "N", "kN"},         {cut_force::V_z, "V", "V_z", "kN"},
    {cut_force::M_y, "M", "M_y", "kN m"},   {cut_force::T, nullptr, "T", "kN m"},
    {cut_force::V_y, nullptr, "V_y", "kN"}, {cut_force::M_z, nullptr, "M_z", "kN m"}};

double largest_of(const CycleFigure& cycle, cut_force::Index which) {
  double largest = 0.0;
  for (const auto* line : {&cycle.smallest, &cycle.largest}) {
    for (const CutForces& cut : *line) largest = std::max(largest, std::abs(value_of(cut, which)));
  }
  return largest;
}

/// Numbers as integer multiples of a power of ten, so that the largest has five digits.
class Digits {
 public:
  explicit Digits(double largest)
      : exponent_(largest > 0.0 ? static_cast<int>(std::floor(std::log10(largest))) - 4 : 0),
        unit_(std::pow(10.0, exponent_)) {}
  long of(double value) const { return std::lround(finite(value) / unit_); }
  /// As a JSON number.
  Json unit() const { return Json::parse(fmt::format("1e{}", exponent_)); }

 private:
  int exponent_;
  double unit_;
};

Json row_of(const std::vector<CutForces>& line, cut_force::Index which, const Digits& digits) {
  Json row = Json::array();
  for (const CutForces& cut : line) row.push_back(digits.of(1e-3 * value_of(cut, which)));
  return row;
}

/// The cut forces that are not zero everywhere; in the plane N, V and M in any case.
Json cut_forces_of(const CycleFigure& cycle, bool in_space) {
  double largest_force = 0.0;
  double largest_moment = 0.0;
  for (const Quantity& of : quantities) {
    double& largest = std::string_view(of.unit) == "kN" ? largest_force : largest_moment;
    largest = std::max(largest, largest_of(cycle, of.which));
  }
  Json all = Json::array();
  for (const Quantity& of : quantities) {
    const double largest = largest_of(cycle, of.which);
    const double group = std::string_view(of.unit) == "kN" ? largest_force : largest_moment;
    const bool zero = largest <= 1e-9 * group;
    if (in_space ? zero : of.plane_name == nullptr) continue;
    const Digits digits(zero ? 0.0 : 1e-3 * largest);
    Json frames = Json::array();
    for (const CycleFrame& frame : cycle.frames) {
      frames.push_back(row_of(frame.values, of.which, digits));
    }
    all.push_back({{"name", in_space ? of.space_name : of.plane_name},
                   {"unit", of.unit},
                   {"digit", digits.unit()},
                   {"low", row_of(cycle.smallest, of.which, digits)},
                   {"high", row_of(cycle.largest, of.which, digits)},
                   {"frames", std::move(frames)}});
  }
  return all;
}

/// The coordinates of a frame in the order in which the script reads them.
class Places {
 public:
  Places(bool in_space, double largest) : in_space_(in_space), digits_(largest) {}
  Json unit() const { return digits_.unit(); }

  Json of(const PostureFigure& posture) const {
    Json row = Json::array();
    for (const auto& body : posture.bodies) {
      for (const Eigen::Vector3d& point : body.points) add(point, digits_, row);
      for (const auto& stroke : body.strokes) add(stroke, digits_, row);
    }
    for (const auto& rod : posture.rods) add(rod, digits_, row);
    for (const auto& guide : posture.guides) {
      add(guide.from, digits_, row);
      add(guide.to, Digits(1.0), row);
    }
    for (const Eigen::Vector3d& ground : posture.grounds) add(ground, digits_, row);
    return row;
  }

  void add(const Eigen::Vector3d& p, const Digits& digits, Json& row) const {
    for (int i = 0; i < (in_space_ ? 3 : 2); ++i) row.push_back(digits.of(p[i]));
  }
  void add(const Eigen::Vector3d& p, Json& row) const { add(p, digits_, row); }

 private:
  void add(const PostureFigure::Stroke& stroke, const Digits& digits, Json& row) const {
    add(stroke.from, digits, row);
    add(stroke.to, digits, row);
  }

  bool in_space_;
  Digits digits_;
};

double largest_coordinate(const CycleFigure& cycle) {
  double largest = 0.0;
  const auto take = [&](const Eigen::Vector3d& p) {
    largest = std::max(largest, p.cwiseAbs().maxCoeff());
  };
  for (const CycleFrame& frame : cycle.frames) {
    for (const auto& body : frame.posture.bodies) {
      for (const Eigen::Vector3d& point : body.points) take(point);
    }
    for (const auto& guide : frame.posture.guides) take(guide.from);
    for (const Eigen::Vector3d& ground : frame.posture.grounds) take(ground);
    for (const BeamLoadRow& load : frame.posture.loads) take(load.place);
  }
  return largest;
}

Json mechanism_of(const CycleFigure& cycle, bool in_space) {
  const Places places(in_space, largest_coordinate(cycle));
  const PostureFigure& first = cycle.frames.front().posture;
  Json bodies = Json::array();
  for (const auto& body : first.bodies) {
    bodies.push_back(
        {{"beam", body.beam}, {"points", body.points.size()}, {"strokes", body.strokes.size()}});
  }
  Json frames = Json::array();
  for (const CycleFrame& frame : cycle.frames) frames.push_back(places.of(frame.posture));
  return {{"space", in_space},
          {"digit", places.unit()},
          {"guideDigit", Digits(1.0).unit()},
          {"bodies", std::move(bodies)},
          {"rods", first.rods.size()},
          {"guides", first.guides.size()},
          {"grounds", first.grounds.size()},
          {"magnified", finite(first.magnified)},
          {"frames", std::move(frames)}};
}

/// Of every load its name, place, force and couple, world axes; numbered where it has no name. In
/// the plane a couple has one component.
Json loads_of(const CycleFigure& cycle, bool in_space) {
  const Places places(in_space, largest_coordinate(cycle));
  double largest = 0.0;
  double largest_couple = 0.0;
  for (const CycleFrame& frame : cycle.frames) {
    for (const BeamLoadRow& load : frame.posture.loads) {
      largest = std::max(largest, 1e-3 * load.world.cwiseAbs().maxCoeff());
      largest_couple = std::max(largest_couple, 1e-3 * load.couple.cwiseAbs().maxCoeff());
    }
  }
  const Digits digits(largest);
  const Digits couple_digits(largest_couple);
  std::vector<std::string> names;
  Json frames = Json::array();
  for (const CycleFrame& frame : cycle.frames) {
    Json& of_frame = frames.emplace_back(Json::array());
    for (const BeamLoadRow& load : frame.posture.loads) {
      const std::string name = load.name.empty()
                                   ? fmt::format("s = {} m", text::significant(load.s.value(), 3))
                                   : visible(load.name);
      const auto known = std::find(names.begin(), names.end(), name);
      Json row = Json::array({known - names.begin()});
      if (known == names.end()) names.push_back(name);
      places.add(load.place, row);
      places.add(1e-3 * load.world, digits, row);
      if (in_space) {
        places.add(1e-3 * load.couple, couple_digits, row);
      } else {
        row.push_back(couple_digits.of(1e-3 * load.couple.z()));
      }
      of_frame.push_back(std::move(row));
    }
  }
  return {{"digit", digits.unit()},
          {"coupleDigit", couple_digits.unit()},
          {"names", names},
          {"frames", std::move(frames)}};
}

/// The frame and station of the largest bending moment, or where there is none of the normal force.
std::pair<std::size_t, std::size_t> critical_place(const CycleFigure& cycle) {
  for (const auto which : {cut_force::M_y, cut_force::N}) {
    double largest = 0.0;
    std::pair<std::size_t, std::size_t> place;
    for (std::size_t f = 0; f < cycle.frames.size(); ++f) {
      for (std::size_t i = 0; i < cycle.stations.size(); ++i) {
        const double size = std::abs(value_of(cycle.frames[f].values[i], which));
        if (size <= largest) continue;
        largest = size;
        place = {f, i};
      }
    }
    if (largest > 0.0) return place;
  }
  return {0, 0};
}

/// JSON that neither ends the element it stands in nor is markup to an XML reader.
std::string harmless(const std::string& json) {
  std::string out;
  out.reserve(json.size());
  for (const char c : json) {
    switch (c) {
      case '<': out += "\\u003c"; break;
      case '>': out += "\\u003e"; break;
      case '&': out += "\\u0026"; break;
      default: out += c;
    }
  }
  return out;
}

Json data_of(const CycleFigure& cycle) {
  const auto [frame, station] = critical_place(cycle);
  const bool in_space = is_in_space(cycle);
  Json times = Json::array();
  for (const CycleFrame& of : cycle.frames) {
    times.push_back(Json::parse(fmt::format("{:.6g}", finite(of.time.value()))));
  }
  Json stations = Json::array();
  std::string sides;
  for (const Station& at : cycle.stations) {
    stations.push_back(Json::parse(fmt::format("{:.6g}", finite(at.s.value()))));
    sides += to_text(at.side);
  }
  return {{"repeats", cycle.repeats},
          {"frame", frame},
          {"station", station},
          {"situation", visible(cycle.situation)},
          {"times", std::move(times)},
          {"stations", std::move(stations)},
          {"sides", sides},
          {"mechanism", mechanism_of(cycle, in_space)},
          {"loads", loads_of(cycle, in_space)},
          {"cut", cut_forces_of(cycle, in_space)}};
}

std::string data_of(const MovingPicture& picture) {
  Json situations = Json::array();
  for (const CycleFigure& cycle : picture.cycles) situations.push_back(data_of(cycle));
  const Json data = {{"first", picture.first}, {"situations", std::move(situations)}};
  return harmless(data.dump(-1, ' ', true, Json::error_handler_t::replace));
}

}  // namespace

std::string cycle_figure(const MovingPicture& picture) {
  const CycleFigure& cycle = picture.cycles[picture.first];
  assert(!cycle.frames.empty());
  const auto [frame, station] = critical_place(cycle);
  const std::string time = text::seconds(cycle.frames[frame].time.value());
  return fmt::format(
      "<figure class=\"cycle\" id=\"moving-figure\">\n<div class=\"pane\">\n{0}</div>\n"
      "<noscript><p>Shown at t = {1}, where the bending moment is largest; with scripts allowed "
      "the "
      "drawing moves over the cycle.</p></noscript>\n"
      "<script type=\"application/json\">{2}</script>\n"
      "<figcaption><b>Moving figure.</b> {3}</figcaption>\n</figure>\n",
      posture_svg(cycle, frame, "Mechanism at t = " + time), time, data_of(picture),
      escaped(picture.caption));
}

}  // namespace boxbeam::report::html
