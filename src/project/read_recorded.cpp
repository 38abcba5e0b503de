#include <fmt/format.h>

#include <Eigen/Geometry>

#include "boxbeam/project/limits.hpp"
#include "read_cut_stations.hpp"
#include "read_recorded_motion.hpp"
#include "recorded_reader.hpp"
#include "recorded_terms.hpp"

namespace boxbeam::readers {
namespace {

using Eigen::Vector3d;

constexpr SixColumns force_columns{
    {"F_x", "F_y", "F_z", "M_x", "M_y", "M_z"},
    {"column of the force along the beam", "column of the force across it, in space",
     "column of the force across it, upwards", "column of the moment about x, in space",
     "column of the moment about y", "column of the moment about z, in space"}};

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
    if (root_->has("cut_forces")) cuts_.read(*root_, *beam_, files_, terms_);
    read_balance(loads);
    forces_ = files_.size();
    if (motion_.read(*root_, files_, loads)) terms_.in_space = true;
    recorded::Channels channels = files_.read(*root_, *tables_);
    in_space = terms_.in_space;
    if (channels.record && files_.size() > forces_) {
      root_->problem("motion",
                     fmt::format("the beam moves, and its files have {} instants; {} can be "
                                 "verified of a beam that moves",
                                 channels.record->instants(), limits::most_samples),
                     "give the part that matters, or fewer samples a second");
    }
    const recorded::MotionChannels motion = motion_.motion_in(*root_, channels);
    std::vector<recorded::ChannelSource> of_motion;
    if (root_->problems().empty()) of_motion = motion_.sources_in(files_, channels);
    channels.values.resize(forces_);
    if (!root_->problems().empty()) {
      loads.acting.constant = {{}, unloaded_lines(*beam_)};
      loads.acting.units.assign(forces_, loads.acting.constant);
    } else if (loads.as_cuts) {
      cuts_.put_together(*beam_, terms_.terms, channels, loads);
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
      terms_.in_space = terms_.in_space || spot.off.y() != 0.0;
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
    read_six(columns, force_columns, *file, factor, spots_.size() - 1, files_, terms_);
    if (columns.has({"F", "column of a force in \"direction\""})) {
      Term term{files_.channel_of(columns, {"F", "column of a force in \"direction\""}, *file,
                                  dimension_of(0))};
      term.place = spots_.size() - 1;
      const Vector3d direction = table.direction({"direction", "of \"F\", in beam axes"});
      term.force = factor * direction;
      term.what = fmt::format("F along ({:.4g}, {:.4g}, {:.4g})", term.force.x(), term.force.y(),
                              term.force.z());
      term.unit = "kN";
      terms_.in_space = terms_.in_space || direction.y() != 0.0;
      terms_.terms.push_back(std::move(term));
    }
    columns.finish();
  }

  /// A force that does not change, or a unit load times a channel.
  void read_constant(TableReader& table) {
    Term term;
    term.place = spots_.size() - 1;
    const Vector3d none = Vector3d::Zero();
    term.force = table.triple({"force", "in beam axes"}, wanted::force, none);
    term.moment = table.triple({"moment", "about the place, in beam axes"}, wanted::moment, none);
    terms_.in_space = terms_.in_space || term.force.y() != 0.0 || term.moment.x() != 0.0 ||
                      term.moment.z() != 0.0;
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
    terms_.terms.push_back(std::move(term));
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
      terms_.in_space = terms_.in_space || loads.gravity.y() != 0.0;
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
    for (const Term& term : terms_.terms) {
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

  void note_sources(const recorded::Channels& channels, recorded::Loads& loads) const {
    for (const Term& term : terms_.terms) {
      recorded::ChannelSource source;
      source.load = loads.as_cuts ? fmt::format("s = {:.6g} m", cuts_.station(term.place))
                                  : spots_[term.place].name;
      source.what = term.what;
      source.has_moment = !term.moment.isZero(0.0);
      if (term.channel) add_column(files_, channels, *term.channel, term.shown, term.unit, source);
      loads.sources.push_back(std::move(source));
    }
  }

  TableReader* root_;
  const TaperedBeam* beam_;
  TimeTables* tables_;
  ChannelFiles files_;
  std::vector<Spot> spots_;
  CutStations cuts_;
  RecordedMotion motion_;
  RecordedTerms terms_;
  std::size_t forces_ = 0;  ///< channels of forces; behind them those of motion
};

}  // namespace

recorded::Loads read_recorded(TableReader& root, const TaperedBeam& beam, TimeTables& tables,
                              bool& in_space) {
  return RecordedLoadsReader(root, beam, tables).read(in_space);
}

}  // namespace boxbeam::readers
