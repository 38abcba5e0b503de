#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "readers.hpp"

namespace boxbeam::readers {
namespace {

using planar::ChainStep;
using planar::NewtonChain;

/// Pieces of the beam body that stand as a step of their own.
std::map<std::string, ChainStep> read_parts(TableReader table, const TaperedBeam& beam,
                                            int beam_body) {
  std::map<std::string, ChainStep> parts;
  for (auto& [name, part] : table.named_tables()) {
    const Length from = station_of(part, {"from", "along the beam"}, beam);
    const Length to = station_of(part, {"to", "along the beam"}, beam);
    part.finish();
    parts[name] = {name, beam_body, Eigen::Vector2d::Zero(), 0.0};
    if (beam_body == planar::ground) {
      part.problem("", "a part is a piece of the beam body, and this case names no [beam] body",
                   "write body = \"...\" in [beam], or remove the part");
    } else if (to <= from) {
      part.problem("to", "the part ends before it begins", "exchange \"from\" and \"to\"");
    } else if (table.problems().empty()) {
      const MassProperties piece = mass_properties_of(beam, from, to);
      const double offset = (piece.centre - mass_properties_of(beam).centre).value();
      parts[name] = {name, beam_body, {offset, 0.0}, piece.mass.value()};
    }
  }
  return parts;
}

std::string hint_for_step(const std::string& name, const planar::Mechanism& mechanism,
                          const std::map<std::string, ChainStep>& parts) {
  std::vector<std::string> known;
  for (const Body& body : mechanism.bodies) known.push_back(body.name);
  for (const auto& [part, step] : parts) known.push_back(part);
  return unknown_hint(name, known);
}

}  // namespace

NewtonChain read_newton_chain(TableReader table, const planar::Mechanism& mechanism,
                              const TaperedBeam& beam, int beam_body) {
  NewtonChain chain;
  const double driving_mass = table.positive({"driving_mass", "of the first step"}, wanted::mass);
  const auto parts = read_parts(
      table.table({"parts", "pieces of the beam body that are steps of their own"}, false), beam,
      beam_body);
  const std::vector<std::string> names =
      table.texts({"steps", "bodies or parts from the driven end to the far end"}, true);
  std::vector<ChainStep> steps;
  std::vector<std::string> unknown;
  for (const std::string& name : names) {
    if (const auto part = parts.find(name); part != parts.end()) {
      steps.push_back(part->second);
      continue;
    }
    const int body = body_index(mechanism, name);
    if (body < 0) {
      table.problem("steps", fmt::format("there is no body or part \"{}\"", name),
                    hint_for_step(name, mechanism, parts));
      unknown.push_back(name);
      continue;
    }
    steps.push_back({name, body, Eigen::Vector2d::Zero(),
                     mechanism.bodies[static_cast<std::size_t>(body)].mass});
  }
  if (steps.size() < 2) {
    if (table.has("steps") && unknown.empty()) {
      table.problem("steps", "a chain has at least two bodies",
                    "name them from the driven end to the far end");
    }
  } else {
    steps.front().mass = driving_mass;
    chain.last = steps.back();
    steps.pop_back();
    chain.steps = steps;
  }

  const auto read_end = [&](const Key& key, std::size_t& step, Length& station) {
    TableReader end = table.table(key);
    const std::string after = end.text({"after", "the step whose force acts there"});
    const auto found = std::find_if(chain.steps.begin(), chain.steps.end(),
                                    [&](const ChainStep& s) { return s.name == after; });
    if (found == chain.steps.end()) {
      const bool said = std::find(unknown.begin(), unknown.end(), after) != unknown.end();
      if (!after.empty() && !said) {
        std::vector<std::string> known;
        for (const ChainStep& s : chain.steps) known.push_back(s.name);
        end.problem("after", fmt::format("\"{}\" is no step of the chain before its last", after),
                    fmt::format("one of \"{}\"", fmt::join(known, "\", \"")));
      }
    } else {
      step = static_cast<std::size_t>(found - chain.steps.begin());
    }
    station = station_of(end, {"station", "along the beam"}, beam);
    end.finish();
  };
  read_end({"first_end", "first load on the beam"}, chain.first_end, chain.first_station);
  read_end({"second_end", "second load on the beam"}, chain.second_end, chain.second_station);
  chain.pivot = station_of(table, {"pivot", "where the beam is held"}, beam);
  chain.axis_body =
      beam_body != planar::ground
          ? beam_body
          : body_of(table, {"axis_of", "whose axis the beam has, where it is no body"}, mechanism);
  table.finish();
  return chain;
}

}  // namespace boxbeam::readers
