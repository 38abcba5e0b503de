#include <fmt/format.h>

#include <algorithm>

#include "boxbeam/beam/tapered_beam.hpp"
#include "readers.hpp"

namespace boxbeam::readers {
namespace {

/// Where joints hold the beam across its axis, ascending, and whether they hold its angle there.
struct Support {
  Length s;
  std::string joint;
  bool clamps = false;
};

/// What a joint does to the beam where it holds it.
struct HoldOnBeam {
  bool place = false;  ///< it keeps the beam's place, across the axis at least
  bool angle = false;
};

HoldOnBeam held_by(const planar::Joint& joint) {
  const planar::Hold hold = planar::holds_of(joint).first;
  return {hold != planar::Hold::angle, hold == planar::Hold::angle || hold == planar::Hold::clamp};
}

/// The joint's point on the beam; nothing where another body slides along the beam, which loads it
/// at a place that changes.
std::optional<planar::Attachment> point_on_beam(const planar::Joint& joint, int beam_body) {
  const auto [a, b] = planar::ends_of(joint);
  if (planar::holds_of(joint).second == planar::Hold::guide && b.body == beam_body) {
    return std::nullopt;
  }
  if (a.body == beam_body) return a;
  if (b.body == beam_body) return b;
  return std::nullopt;
}

std::vector<Support> supports_of(const Project& project, const planar::Mechanism& mechanism) {
  // A beam whose segments could not be read has no centre; that is said already.
  if (project.beam_body == planar::ground || project.beam.segments.empty()) return {};
  const Length centre = mass_properties_of(project.beam).centre;
  const std::vector<Length> places = places_of(project.beam);
  struct Place : Support {
    HoldOnBeam hold;
  };
  std::vector<Place> found;
  for (const planar::Joint& joint : mechanism.joints) {
    const auto point = point_on_beam(joint, project.beam_body);
    if (!point) continue;
    const HoldOnBeam hold = held_by(joint);
    const Length s = place_near(places, centre + si<Length>(point->p.x()));
    const auto same =
        std::find_if(found.begin(), found.end(), [&](const Place& at) { return at.s == s; });
    if (same == found.end()) {
      found.push_back({{s, joint.name, false}, hold});
      continue;
    }
    same->hold.place = same->hold.place || hold.place;
    same->hold.angle = same->hold.angle || hold.angle;
    if (joint.name != same->joint && !planar::is_driver(joint)) same->joint += " and " + joint.name;
  }
  std::vector<Support> supports;
  for (const Place& at : found) {
    if (!at.hold.place) continue;
    supports.push_back({at.s, at.joint, at.hold.angle});
  }
  std::sort(supports.begin(), supports.end(),
            [](const Support& a, const Support& b) { return a.s < b.s; });
  return supports;
}

std::string metres(Length s) { return fmt::format("{:.6g}", s.value()); }

/// What the supports of the beam say of the line that it bends away from: the tangent where it is
/// clamped, or held at one place only, which can but be a clamp; the chord between two supports.
/// Nothing where they are more.
struct SupportedLine {
  MeasuredFrom line;
  std::string why;  ///< "where joint root clamps the beam"
};

std::optional<SupportedLine> line_of(const std::vector<Support>& supports) {
  const auto clamps = [](const Support& support) { return support.clamps; };
  const bool one = supports.size() == 1;
  if (one || std::count_if(supports.begin(), supports.end(), clamps) == 1) {
    const Support& clamp =
        one ? supports.front() : *std::find_if(supports.begin(), supports.end(), clamps);
    return SupportedLine{Tangent{clamp.s},
                         fmt::format("where joint {} clamps the beam", clamp.joint)};
  }
  if (supports.size() != 2) return std::nullopt;
  return SupportedLine{
      Chord{supports[0].s, supports[1].s},
      fmt::format("between its supports, joints {} and {}", supports[0].joint, supports[1].joint)};
}

std::string text_of(const MeasuredFrom& line) {
  if (std::holds_alternative<UnloadedAxis>(line)) return "the unloaded axis";
  if (const auto* chord = std::get_if<Chord>(&line)) {
    return fmt::format("the chord from s = {} to {} m", metres(chord->from), metres(chord->to));
  }
  return fmt::format("the tangent at s = {} m", metres(std::get<Tangent>(line).at));
}

/// The same of a case; nothing where its situations hold the beam unlike.
std::optional<SupportedLine> supported_line_of(const Project& project) {
  if (std::holds_alternative<frame::Structure>(project.mechanism))
    return SupportedLine{UnloadedAxis{}, "its supports' motion included"};
  // In space what holds the beam in one plane may let it turn in the other.
  if (!std::holds_alternative<planar::Mechanism>(project.mechanism)) return std::nullopt;
  auto line = line_of(supports_of(project, planar_of(project)));
  for (const Situation& situation : project.situations) {
    if (!line) break;
    const auto other = line_of(supports_of(project, planar_in(project, situation)));
    if (!other || text_of(other->line) != text_of(line->line)) line.reset();
  }
  return line;
}

/// "against", with "from" and "to" or "at"; without it what the supports say, and only where these
/// say nothing the chord from "from" to "to".
void read_against(TableReader& table, const Project& project, DeflectionInput& deflection) {
  const TaperedBeam& beam = project.beam;
  const auto supported = supported_line_of(project);
  const bool said = table.has("against");
  enum { chord, axis, tangent };
  const std::size_t unsaid = axis;
  const std::size_t word =
      said ? table.choice(
                 {"against",
                  "from which line it is measured: the chord between two stations, the undeformed "
                  "axis, the tangent at a station; where not said the supports decide"},
                 {"chord", "axis", "tangent"})
           : unsaid;
  const bool ends = table.has("from") || table.has("to");
  std::optional<Chord> between;
  if (ends) {
    between = {station_of(table, {"from", "start of the chord"}, beam),
               station_of(table, {"to", "end of the chord"}, beam)};
    if (table.problems().empty() && !(between->from < between->to)) {
      table.problem("to", "the line from which the deflection is measured has no length",
                    "write two stations, \"from\" before \"to\"");
    }
  }
  std::optional<Tangent> touching;
  if (table.has("at")) touching = {station_of(table, {"at", "where the tangent touches"}, beam)};
  if (said && between && word != chord) {
    table.problem("from", "\"from\" and \"to\" are the ends of a chord",
                  "remove them, or write against = \"chord\"");
  }
  if (touching && (!said || word != tangent)) {
    table.problem("at", "\"at\" is where a tangent touches the beam",
                  "write against = \"tangent\", or remove it");
  }
  if (!table.problems().empty()) return;

  const auto take = [&](const MeasuredFrom& line, const std::string& why) {
    deflection.against = line;
    deflection.measured_from = text_of(line) + (why.empty() ? "" : ", " + why);
  };
  const bool clamped = supported && std::holds_alternative<Tangent>(supported->line);
  const bool at_rest = supported && std::holds_alternative<UnloadedAxis>(supported->line);
  if (between && (said || !supported)) return take(*between, "");
  if (touching) return take(*touching, "");
  const bool fits = supported && (word == axis || (!at_rest && clamped == (word == tangent)));
  if (!fits) {
    const char* const hint =
        "write against = \"chord\" with \"from\" and \"to\", or against = \"tangent\" with "
        "\"at\"";
    table.problem(said ? "against" : "",
                  "where the beam is held does not say from which line its deflection is measured",
                  hint);
    return;
  }
  // Two stations that happen to be the supports say the same; others would hide how far the beam
  // bends between or behind its supports, so that they are to be asked for.
  const bool other = between && text_of(*between) != text_of(supported->line);
  take(supported->line,
       supported->why + (said && word == axis ? ", which is the undeformed axis" : "") +
           (other ? "; \"from\" and \"to\" are the ends of a chord, from which it is measured "
                    "only with against = \"chord\""
                  : ""));
}

}  // namespace

void read_deflection_of(TableReader& root, Project& project) {
  if (!root.has("deflection")) return;
  TableReader table = root.table({"deflection", "how far the beam may bend"});
  DeflectionInput& deflection = project.deflection.emplace();
  deflection.limit =
      si<Length>(table.positive({"limit", "largest deflection allowed"}, wanted::length));
  deflection.load_factor =
      table.boolean({"load_factor", "the situations' load factors multiply it"}, false);
  read_against(table, project, deflection);
  deflection.youngs_modulus = si<Stress>(table.positive(
      {"youngs_modulus", "of the beam"}, wanted::stress, project.model.youngs_modulus));
  deflection.shear_modulus = si<Stress>(table.positive(
      {"shear_modulus", "of the beam"}, wanted::stress, project.model.shear_modulus));
  table.finish();
}

}  // namespace boxbeam::readers
