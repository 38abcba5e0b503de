#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "boxbeam/mechanism/recorded/derivatives.hpp"
#include "boxbeam/mechanism/recorded/motion_columns.hpp"
#include "boxbeam/project/limits.hpp"
#include "recorded_reader.hpp"

namespace boxbeam::readers {
namespace {

using Eigen::Vector3d;
using recorded::SixForces;

/// A part of the loads: what does not change, or what one of a channel's unit does.
struct Term {
  std::optional<std::size_t> channel;
  std::size_t place = 0;  ///< of the load, or the station
  Vector3d force = Vector3d::Zero(), moment = Vector3d::Zero();
  std::string what = {};
  double shown = 1e-3;  ///< by which the channel's values are multiplied for people
  std::string unit = {};
};

constexpr std::array force_words{"F_x", "F_y", "F_z", "M_x", "M_y", "M_z"};
/// The columns of a motion, in the order in which their channels are kept.
constexpr std::array sensor_words{"a_x",     "a_y",     "a_z",     "omega_x", "omega_y",
                                  "omega_z", "alpha_x", "alpha_y", "alpha_z"};
constexpr std::array sensor_units{"m/s^2", "rad/s", "rad/s^2"};
constexpr std::array path_words{"x", "z", "angle"};
constexpr std::array path_units{"m", "m", "rad"};
constexpr std::array cut_words{"N", "V_y", "V_z", "T", "M_y", "M_z"};
constexpr std::array force_meanings{
    "column of the force along the beam",     "column of the force across it, in space",
    "column of the force across it, upwards", "column of the moment about x, in space",
    "column of the moment about y",           "column of the moment about z, in space"};
constexpr std::array cut_meanings{"column of the normal force, tension positive",
                                  "column of the shear force V_y, in space",
                                  "column of the shear force V_z",
                                  "column of the torque, in space",
                                  "column of the bending moment M_y",
                                  "column of the bending moment M_z, in space"};

/// Which of the six leave the plane of x and z.
constexpr bool leaves_plane(std::size_t k) { return k == 1 || k == 3 || k == 5; }

constexpr WantedDimension angular_acceleration{
    {0, 0, -2, 1}, "an angular acceleration", "\"0.5 rad/s^2\""};

const WantedDimension& dimension_of(std::size_t k) {
  return k < 3 ? wanted::force : wanted::moment;
}

double read_factor(TableReader& table) {
  const double factor =
      table.any_number({"factor", "on all columns; -1 turns what acts on another body"}, 1.0);
  if (factor == 0.0)
    table.problem("factor", "zero times its columns is no load", "remove the load instead");
  return factor;
}

class RecordedLoadsReader {
 public:
  RecordedLoadsReader(TableReader& root, const TaperedBeam& beam, TimeTables& tables)
      : root_(&root), beam_(&beam), tables_(&tables), files_(root, tables) {}

  recorded::Loads read(bool& in_space) {
    recorded::Loads loads;
    const bool one = root_->says_one_of({{{"loads"}}, {{"cut_forces"}}});
    if (!one) {
      root_->problem("loads",
                     "a case of kind = \"loads\" gives what acts on the beam, or its cut forces",
                     "write [loads.<name>] for forces and moments at places, or [[cut_forces]] for "
                     "N, V and M at stations");
      root_->has("loads");
    }
    loads.as_cuts = root_->has("cut_forces") && !root_->has("loads");
    if (root_->has("loads")) read_loads();
    if (root_->has("cut_forces")) read_stations();
    read_balance(loads);
    forces_ = files_.size();
    read_motion(loads);
    recorded::Channels channels = files_.read(*root_, *tables_);
    in_space = in_space_;
    if (channels.record && files_.size() > forces_) {
      root_->problem("motion",
                     fmt::format("the beam moves, and its files have {} instants; {} can be "
                                 "verified of a beam that moves",
                                 channels.record->instants(), limits::most_samples),
                     "give the part that matters, or fewer samples a second");
    }
    const recorded::MotionChannels motion = motion_in(channels);
    std::vector<recorded::ChannelSource> of_motion;
    if (root_->problems().empty()) of_motion = sources_of_motion(channels);
    channels.values.resize(forces_);
    if (!root_->problems().empty()) {
      loads.acting.constant = {{}, unloaded_lines(*beam_)};
      loads.acting.units.assign(forces_, loads.acting.constant);
    } else if (loads.as_cuts) {
      put_together_cuts(channels, loads);
    } else {
      put_together_loads(motion, channels, loads);
    }
    if (root_->problems().empty()) {
      note_sources(channels, loads);
      for (recorded::ChannelSource& of : of_motion) loads.sources.push_back(std::move(of));
    }
    loads.acting.channels = std::make_shared<const recorded::Channels>(std::move(channels));
    return loads;
  }

 private:
  struct Spot {
    std::string name;
    double s = 0.0;
    Vector3d off = Vector3d::Zero();  ///< from the axis there
  };

  void read_loads() {
    for (auto& [name, table] :
         root_->table({"loads", "what acts on the beam"}, false).named_tables()) {
      Spot spot{name, station_of(table, {"station", "station where it acts"}, *beam_).value(), {}};
      spot.off.setZero();
      spot.off.y() =
          table.quantity({"y", "of the place, off the axis, in space"}, wanted::length, 0.0);
      spot.off.z() = table.quantity({"z", "of the place, off the axis"}, wanted::length, 0.0);
      in_space_ = in_space_ || spot.off.y() != 0.0;
      spots_.push_back(spot);
      if (!table.says_one_of({{{"columns"}}, {{"force", "moment"}, false}})) {
        table.accept_all();
        table.problem(
            "", fmt::format("[{}] gives its columns, or what does not change", table.name()),
            "columns = { F_z = \"Fz\" } of a file, or force = [\"0 N\", \"0 N\", \"-1 kN\"] "
            "by itself or \"times\" a column");
        continue;
      }
      if (table.has("columns"))
        read_columns(table);
      else
        read_constant(table);
      table.finish();
    }
  }

  /// Forces whose components are columns.
  void read_columns(TableReader& table) {
    const std::optional<std::size_t> file = files_.file_of(table);
    const double factor = read_factor(table);
    TableReader columns = table.table({"columns", "of the file, by what they are; beam axes"});
    if (!file) {
      columns.accept_all();
      if (table.has("direction")) table.direction({"direction", "of \"F\", in beam axes"});
      return;
    }
    for (std::size_t k = 0; k < 6; ++k) {
      if (!columns.has({force_words[k], force_meanings[k]})) continue;
      Term term{channel(columns, {force_words[k], force_meanings[k]}, *file, k)};
      term.place = spots_.size() - 1;
      (k < 3 ? term.force : term.moment)[static_cast<Eigen::Index>(k % 3)] = factor;
      term.what = factor == 1.0 ? force_words[k] : fmt::format("{:g} {}", factor, force_words[k]);
      term.unit = k < 3 ? "kN" : "kN m";
      in_space_ = in_space_ || leaves_plane(k);
      terms_.push_back(std::move(term));
    }
    if (columns.has({"F", "column of a force in \"direction\""})) {
      Term term{channel(columns, {"F", "column of a force in \"direction\""}, *file, 0)};
      term.place = spots_.size() - 1;
      const Vector3d direction = table.direction({"direction", "of \"F\", in beam axes"});
      term.force = factor * direction;
      term.what = fmt::format("F along ({:.4g}, {:.4g}, {:.4g})", term.force.x(), term.force.y(),
                              term.force.z());
      term.unit = "kN";
      in_space_ = in_space_ || direction.y() != 0.0;
      terms_.push_back(std::move(term));
    }
    columns.finish();
  }

  std::size_t channel(TableReader& columns, const Key& key, std::size_t file, std::size_t k) {
    return files_.channel_of(columns, key, file, dimension_of(k));
  }

  /// A force that does not change, or a unit load times a channel.
  void read_constant(TableReader& table) {
    Term term;
    term.place = spots_.size() - 1;
    const Vector3d none = Vector3d::Zero();
    term.force = table.triple({"force", "in beam axes"}, wanted::force, none);
    term.moment = table.triple({"moment", "about the place, in beam axes"}, wanted::moment, none);
    in_space_ =
        in_space_ || term.force.y() != 0.0 || term.moment.x() != 0.0 || term.moment.z() != 0.0;
    if (table.has("times")) {
      const std::optional<std::size_t> file = files_.file_of(table);
      const double per = table.number(
          {"per", "value of the column at which the force acts, in its unit"}, 1.0, "100.0");
      const Key times{"times", "column by which the force changes"};
      if (file) {
        term.channel = files_.channel_of(table, times, *file, std::nullopt);
        const auto text = [](const Vector3d& v) {
          return fmt::format("({:.4g}, {:.4g}, {:.4g})", v.x() * 1e-3, v.y() * 1e-3, v.z() * 1e-3);
        };
        term.what = "times " + (term.force.isZero(0.0) ? text(term.moment) + " kN m"
                                                       : text(term.force) + " kN");
        if (per != 1.0) term.what += fmt::format(" per {:g}", per);
        term.shown = 1.0;
      } else {
        table.text(times);
      }
      term.force /= per;
      term.moment /= per;
    }
    terms_.push_back(std::move(term));
  }

  void read_stations() {
    for (TableReader& table :
         root_->tables({"cut_forces",
                        "at stations along the beam, linear between them; one that stands twice "
                        "has those before and behind a jump"})) {
      const double s = station_of(table, {"station", "station"}, *beam_).value();
      const bool twice = !stations_.empty() && s == stations_.back();
      const bool thrice = twice && stations_.size() > 1 && s == stations_[stations_.size() - 2];
      if (!stations_.empty() && (thrice || !(s >= stations_.back()))) {
        table.problem("station", "the stations of cut forces ascend along the beam",
                      "write them in order, each once, or twice where the cut forces jump: before "
                      "it and behind");
      }
      stations_.push_back(s);
      given_.emplace_back();
      if (!table.has("columns")) {  // a free end
        table.finish();
        continue;
      }
      const std::optional<std::size_t> file = files_.file_of(table);
      const double factor = read_factor(table);
      TableReader columns =
          table.table({"columns", "of the file, by what they are; none at a free end"});
      if (!file) {
        columns.accept_all();
        table.finish();
        continue;
      }
      for (std::size_t k = 0; k < 6; ++k) {
        if (!columns.has({cut_words[k], cut_meanings[k]})) continue;
        Term term{channel(columns, {cut_words[k], cut_meanings[k]}, *file, k)};
        term.place = stations_.size() - 1;
        (k < 3 ? term.force : term.moment)[static_cast<Eigen::Index>(k % 3)] = factor;
        term.what = factor == 1.0 ? cut_words[k] : fmt::format("{:g} {}", factor, cut_words[k]);
        term.unit = k < 3 ? "kN" : "kN m";
        in_space_ = in_space_ || leaves_plane(k);
        terms_.push_back(std::move(term));
        given_.back()[k] = true;
      }
      columns.finish();
      table.finish();
    }
    check_stations();
  }

  void check_stations() {
    if (!root_->problems().empty()) return;
    const double length = beam_->length().value();
    const bool ends = stations_.size() >= 2 && stations_.front() <= 1e-9 * length &&
                      stations_.back() >= (1.0 - 1e-9) * length;
    if (!ends) {
      root_->problem("cut_forces",
                     stations_.empty()
                         ? "no station has cut forces"
                         : fmt::format("cut forces are given from s = {:.6g} to {:.6g} m, and the "
                                       "beam goes from 0 to {:.6g} m",
                                       stations_.front(), stations_.back(), length),
                     "give a station at both ends of the beam; one without columns is a free end");
      return;
    }
    if (stations_[1] == stations_.front() || stations_[stations_.size() - 2] == stations_.back()) {
      root_->problem("cut_forces", "an end of the beam stands twice in the stations",
                     "give what is cut just within the beam; outside it nothing is cut");
      return;
    }
    stations_.front() = 0.0;
    stations_.back() = length;
    std::array<bool, 6> ever{};
    for (const std::array<bool, 6>& at : given_) {
      for (std::size_t k = 0; k < 6; ++k) ever[k] = ever[k] || at[k];
    }
    for (std::size_t j = 0; j < given_.size(); ++j) {
      const bool free_end =
          std::none_of(given_[j].begin(), given_[j].end(), [](bool is) { return is; });
      for (std::size_t k = 0; k < 6 && !free_end; ++k) {
        if (!ever[k] || given_[j][k]) continue;
        root_->problem("cut_forces",
                       fmt::format("{} is given at other stations and not at s = {:.6g} m",
                                   cut_words[k], stations_[j]),
                       "name its column, or leave out all columns where the beam is free");
      }
    }
    for (const auto& [moment, shear] : {std::pair{4, 2}, {5, 1}}) {
      const auto M = static_cast<std::size_t>(moment), V = static_cast<std::size_t>(shear);
      if (ever[M] == ever[V]) continue;
      root_->problem(
          "cut_forces",
          ever[M] ? fmt::format("{} is given without {}: its shear stresses would be missing",
                                cut_words[M], cut_words[V])
                  : fmt::format("{} is given without {}, which changes along the beam by it",
                                cut_words[V], cut_words[M]),
          ever[M] ? "name the column of the shear force as well"
                  : "name the column of the bending moment as well");
    }
  }

  void read_balance(recorded::Loads& loads) {
    if (!root_->has("balance")) return;
    TableReader table =
        root_->table({"balance", "what the files do not say of the beam's balance"}, false);
    if (table.has("station")) {
      recorded::Balance balance;
      balance.s =
          station_of(table, {"station", "where what the loads lack acts, as a clamp does"}, *beam_)
              .value();
      balance.name = table.text({"name", "of that support"}, "support");
      loads.balance = balance;
      if (loads.as_cuts) {
        table.problem("station", "cut forces are in balance by themselves",
                      "remove it; it belongs to forces at places");
      }
    }
    if (table.has("gravity")) {
      loads.gravity = table.triple(
          {"gravity", "in beam axes: the beam's own weight is added; without it it is contained"},
          wanted::acceleration);
      in_space_ = in_space_ || loads.gravity.y() != 0.0;
      if (loads.as_cuts) {
        table.problem("gravity", "cut forces contain the beam's weight",
                      "remove it; it belongs to forces at places");
      }
    }
    if (table.has("held")) {
      for (const double s :
           table.quantities({"held", "stations of the pins that hold the beam against buckling"},
                            wanted::length)) {
        if (s < 0.0 || s > beam_->length().value() * (1.0 + 1e-9)) {
          table.problem("held", fmt::format("the beam has no station s = {:.6g} m", s),
                        fmt::format("stations go from 0 to {:.6g} m", beam_->length().value()));
        }
        loads.held.push_back(s);
      }
    }
    table.finish();
  }

  /// How the beam moves: by what a sensor at its start reads, or by the path of it.
  void read_motion(recorded::Loads& loads) {
    if (!root_->has("motion")) return;
    TableReader table =
        root_->table({"motion", "of the beam, whose inertia it adds; without it it is contained"});
    loads.inertia = true;
    if (loads.as_cuts) {
      table.problem("", "cut forces contain the beam's inertia",
                    "remove [motion]; it belongs to forces at places");
    }
    if (!loads.gravity.isZero(0.0)) {
      table.problem("", "the weight would count twice: it is in the motion",
                    "remove \"gravity\" from [balance]");
    }
    const std::optional<std::size_t> file = files_.file_of(table);
    TableReader columns = table.table({"columns", "of the file, by what they are"});
    const double gravity =
        table.not_negative({"gravity", "downwards, beside a path; what a sensor reads contains it"},
                           wanted::acceleration, 9.81);
    table.finish();
    if (!file) {
      columns.accept_all();
      return;
    }
    const auto take = [&](const Key& key, const WantedDimension& wanted,
                          std::optional<std::size_t>& channel) {
      if (columns.has(key)) channel = files_.channel_of(columns, key, *file, wanted);
    };
    const bool path = columns.says_one_of(
        {{{"x", "z", "angle"}},
         {{"a_x", "a_y", "a_z", "omega_x", "omega_y", "omega_z", "alpha_x", "alpha_y", "alpha_z"},
          false}});
    if (!path) {
      columns.accept_all();
      columns.problem("", "the columns of a motion are a path or the readings of a sensor",
                      "write x, z and angle of the beam's start; or a_x, a_z, omega_y, alpha_y");
      return;
    }
    if (columns.has("x")) {
      take({"x", "of the beam's start, in the plane of motion"}, wanted::length, path_[0]);
      take({"z", "likewise, upwards"}, wanted::length, path_[1]);
      take({"angle", "of the beam, from x towards z"}, wanted::angle, path_[2]);
      for (const char* key : {"z", "angle"}) {
        if (!columns.has(key)) columns.text(key);  // says that it is missing
      }
      path_gravity_ = gravity;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      take({sensor_words[k], "acceleration of the beam's start less gravity, as a sensor reads it"},
           wanted::acceleration, sensor_[k]);
      take({sensor_words[3 + k], "angular velocity, about the beam's axes"},
           wanted::angular_velocity, sensor_[3 + k]);
      take({sensor_words[6 + k], "angular acceleration; without it that of the angular velocity"},
           angular_acceleration, sensor_[6 + k]);
    }
    in_space_ = in_space_ || sensor_[1] || sensor_[3] || sensor_[5] || sensor_[6] || sensor_[8];
    columns.finish();
  }

  recorded::MotionChannels motion_in(const recorded::Channels& channels) {
    const auto values_of = [&](const std::optional<std::size_t>& channel) {
      return channel ? channels.values[*channel] : std::vector<double>();
    };
    if (path_[0] && path_[1] && path_[2]) {
      if (channels.times.size() < 3) {
        if (root_->problems().empty() && root_->problems().recorder == nullptr) {
          root_->problem("motion", "a path of two instants has no acceleration",
                         "give three instants at least");
        }
        return {};
      }
      return recorded::motion_of_path(channels.times, values_of(path_[0]), values_of(path_[1]),
                                      values_of(path_[2]), path_gravity_);
    }
    recorded::MotionChannels motion;
    for (std::size_t k = 0; k < 3; ++k) {
      motion.acceleration[k] = values_of(sensor_[k]);
      motion.omega[k] = values_of(sensor_[3 + k]);
      motion.alpha[k] = values_of(sensor_[6 + k]);
      // A gyroscope reads the rate of turning alone.
      const std::size_t known = motion.omega[k].size();
      if (motion.alpha[k].empty() && known >= 2 && known == channels.times.size())
        motion.alpha[k] = recorded::derivatives_of(channels.times, motion.omega[k]).first;
    }
    return motion;
  }

  void put_together_loads(const recorded::MotionChannels& motion, recorded::Channels& channels,
                          recorded::Loads& loads) const {
    std::vector<std::string> names;
    for (const Spot& spot : spots_) names.push_back(spot.name);
    if (loads.balance) names.push_back(loads.balance->name);
    loads.names = std::make_shared<const std::vector<std::string>>(std::move(names));
    BeamLoads nothing{{}, unloaded_lines(*beam_)};
    for (std::size_t i = 0; i < spots_.size(); ++i) {
      PointLoad& point = nothing.points.emplace_back();
      point.s = place_near(places_of(*beam_), si<Length>(spots_[i].s));
      point.at = spots_[i].off.tail<2>();
      point.name = (*loads.names)[i];
    }
    recorded::ChannelLoads& acting = loads.acting;
    acting.constant = nothing;
    acting.units.assign(channels.values.size(), nothing);
    for (const Term& term : terms_) {
      BeamLoads& of = term.channel ? acting.units[*term.channel] : acting.constant;
      of.points[term.place].force += term.force;
      of.points[term.place].moment += term.moment + spots_[term.place].off.cross(term.force);
    }
    if (!loads.gravity.isZero(0.0)) {
      acting.constant.lines =
          weight_and_inertia(*beam_, mass_distribution_of(*beam_), loads.gravity, {});
    }
    add_inertia(*beam_, motion, channels, acting);
    if (!loads.balance) return;
    loads.balance->point = nothing.points.size();
    const Length s = place_near(places_of(*beam_), si<Length>(loads.balance->s));
    const auto close = [&](BeamLoads& of) {
      PointLoad closing = recorded::balance_at(s, of);
      closing.name = loads.names->back();
      of.points.push_back(closing);
    };
    close(acting.constant);
    for (BeamLoads& unit : acting.units) close(unit);
  }

  void put_together_cuts(const recorded::Channels& channels, recorded::Loads& loads) const {
    const std::vector<SixForces> none(stations_.size(), SixForces{});
    recorded::ChannelLoads& acting = loads.acting;
    acting.constant = recorded::loads_of_cuts(*beam_, stations_, none);
    for (std::size_t k = 0; k < channels.values.size(); ++k) {
      std::vector<SixForces> unit = none;
      for (const Term& term : terms_) {
        if (term.channel != k) continue;
        for (std::size_t c = 0; c < 3; ++c) {
          unit[term.place][c] += term.force[static_cast<Eigen::Index>(c)];
          unit[term.place][c + 3] += term.moment[static_cast<Eigen::Index>(c)];
        }
      }
      acting.units.push_back(recorded::loads_of_cuts(*beam_, stations_, unit));
    }
    find_shear_defect(channels, loads);
  }

  /// The given cut force of a station at an instant.
  double given_at(const recorded::Channels& channels, std::size_t station, std::size_t k,
                  std::size_t instant) const {
    double sum = 0.0;
    for (const Term& term : terms_) {
      if (term.place != station) continue;
      const double part = (k < 3 ? term.force : term.moment)[static_cast<Eigen::Index>(k % 3)];
      if (part != 0.0) sum += part * channels.values[*term.channel][instant];
    }
    return sum;
  }

  void find_shear_defect(const recorded::Channels& channels, recorded::Loads& loads) const {
    for (const auto& [shear, moment, sign] : {std::tuple{2, 4, 1.0}, {1, 5, -1.0}}) {
      const auto V = static_cast<std::size_t>(shear), M = static_cast<std::size_t>(moment);
      double largest = 0.0, worst = 0.0;
      std::size_t station = 0, when = 0;
      for (std::size_t j = 0; j + 1 < stations_.size(); ++j) {
        const double h = stations_[j + 1] - stations_[j];
        if (h == 0.0) continue;  // a jump
        for (std::size_t i = 0; i < channels.times.size(); ++i) {
          const double a = given_at(channels, j, V, i), b = given_at(channels, j + 1, V, i);
          const double slope =
              sign * (given_at(channels, j + 1, M, i) - given_at(channels, j, M, i)) / h;
          largest = std::max({largest, std::abs(a), std::abs(b), std::abs(slope)});
          const double apart = std::abs(0.5 * (a + b) - slope);
          if (apart <= worst) continue;
          worst = apart;
          station = j;
          when = i;
        }
      }
      if (largest == 0.0 || worst / largest <= loads.shear_defect) continue;
      loads.shear_defect = worst / largest;
      loads.shear_defect_at =
          fmt::format("{} between s = {:.6g} and {:.6g} m at t = {:.6g} s", cut_words[V],
                      stations_[station], stations_[station + 1], channels.times[when]);
    }
  }

  void note_sources(const recorded::Channels& channels, recorded::Loads& loads) const {
    for (const Term& term : terms_) {
      recorded::ChannelSource source;
      source.load = loads.as_cuts ? fmt::format("s = {:.6g} m", stations_[term.place])
                                  : spots_[term.place].name;
      source.what = term.what;
      source.has_moment = !term.moment.isZero(0.0);
      if (term.channel) add_column(channels, *term.channel, term.shown, term.unit, source);
      loads.sources.push_back(std::move(source));
    }
  }

  /// The column behind a channel, whose values count so many times for people.
  void add_column(const recorded::Channels& channels, std::size_t channel, double shown,
                  const std::string& unit, recorded::ChannelSource& source) const {
    const std::vector<double>& values = channels.values[channel];
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    source.column = files_.column(channel);
    source.file = files_.path(channel);
    source.low = *low * shown;
    source.high = *high * shown;
    source.unit = unit;
  }

  std::vector<recorded::ChannelSource> sources_of_motion(const recorded::Channels& channels) const {
    std::vector<recorded::ChannelSource> sources;
    const auto note = [&](const std::optional<std::size_t>& channel, const char* what,
                          const char* unit) {
      if (!channel || channels.values[*channel].empty()) return;
      recorded::ChannelSource& of = sources.emplace_back();
      of.load = recorded::motion_of_beam;
      of.what = what;
      add_column(channels, *channel, 1.0, unit, of);
    };
    for (std::size_t k = 0; k < path_.size(); ++k) note(path_[k], path_words[k], path_units[k]);
    for (std::size_t k = 0; k < sensor_.size(); ++k)
      note(sensor_[k], sensor_words[k], sensor_units[k / 3]);
    return sources;
  }

  TableReader* root_;
  const TaperedBeam* beam_;
  TimeTables* tables_;
  ChannelFiles files_;
  std::vector<Spot> spots_;
  std::vector<double> stations_;
  std::vector<std::array<bool, 6>> given_;  ///< which cut forces each station has
  std::vector<Term> terms_;
  std::size_t forces_ = 0;  ///< channels of forces; behind them those of motion
  std::array<std::optional<std::size_t>, 3> path_;    ///< x, z, angle
  std::array<std::optional<std::size_t>, 9> sensor_;  ///< acceleration, omega, alpha
  double path_gravity_ = 0.0;
  bool in_space_ = false;
};

}  // namespace

recorded::Loads read_recorded(TableReader& root, const TaperedBeam& beam, TimeTables& tables,
                              bool& in_space) {
  return RecordedLoadsReader(root, beam, tables).read(in_space);
}

}  // namespace boxbeam::readers
