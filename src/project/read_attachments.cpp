#include <fmt/format.h>

#include <algorithm>

#include "readers.hpp"

namespace boxbeam::readers {
namespace {

using planar::Attachment;
using planar::Mechanism;

/// A reference "body.point", to a body in the plane or in space.
template <class Place, class AnyMechanism>
Place attachment_in(TableReader& table, std::string_view key, const std::string& reference,
                    const AnyMechanism& mechanism) {
  Place attachment;
  const std::size_t dot = reference.rfind('.');
  if (dot == std::string::npos) {
    table.problem(key, fmt::format("\"{}\" is not a point of a body", reference),
                  "write \"body.point\", for example \"beam.B\"");
    return attachment;
  }
  const std::string body_name = reference.substr(0, dot);
  const std::string point_name = reference.substr(dot + 1);
  attachment.body = body_index(mechanism, body_name);
  if (attachment.body < 0) {
    table.problem(key, fmt::format("there is no body \"{}\"", body_name),
                  unknown_hint(body_name, names_of(mechanism.bodies)));
    return attachment;
  }
  const auto& body = mechanism.bodies[static_cast<std::size_t>(attachment.body)];
  const auto point = std::find_if(body.points.begin(), body.points.end(),
                                  [&](const auto& p) { return p.name == point_name; });
  if (point == body.points.end()) {
    table.problem(key, fmt::format("body \"{}\" has no point \"{}\"", body_name, point_name),
                  unknown_hint(point_name, names_of(body.points)));
    return attachment;
  }
  attachment.p = point->p;
  return attachment;
}

Attachment ground_at(TableReader& table) {
  return {planar::ground, table.pair({"at", "the place on the ground"}, wanted::length)};
}

}  // namespace

Attachment attachment_of(TableReader& table, const Key& of, const Mechanism& mechanism) {
  const std::string_view key = of.name;
  const std::string reference = table.text(of);
  if (reference.empty()) return {};
  return attachment_in<Attachment>(table, key, reference, mechanism);
}

spatial::Attachment point_named(TableReader& table, std::string_view key,
                                const std::string& reference, const spatial::Mechanism& mechanism) {
  return attachment_in<spatial::Attachment>(table, key, reference, mechanism);
}

spatial::Attachment attachment_of(TableReader& table, const Key& of,
                                  const spatial::Mechanism& mechanism) {
  const std::string_view key = of.name;
  const std::string reference = table.text(of);
  return reference.empty() ? spatial::Attachment{} : point_named(table, key, reference, mechanism);
}

std::vector<Attachment> attachments_of(TableReader& table, const Key& of, std::size_t count,
                                       const Mechanism& mechanism) {
  const std::string_view key = of.name;
  std::vector<Attachment> attachments;
  const std::vector<std::string> references = table.texts(of, true);
  if (references.size() != count && table.has(key)) {
    table.problem(key, fmt::format("\"{}\" wants {} points", key, count),
                  "each as \"body.point\", for example \"beam.B\"");
  }
  for (const std::string& reference : references) {
    attachments.push_back(attachment_in<Attachment>(table, key, reference, mechanism));
  }
  attachments.resize(count);
  return attachments;
}

Attachment place_of(TableReader& table, const Key& of, const Mechanism& mechanism) {
  const std::string_view key = of.name;
  const std::string reference = table.text(of);
  if (reference.empty()) return {};
  table.wants_with("at", key, "ground");
  if (reference == "ground") return ground_at(table);
  return attachment_in<Attachment>(table, key, reference, mechanism);
}

std::pair<Attachment, Attachment> ends_in(TableReader& table, const EndsKey& of,
                                          const Mechanism& mechanism) {
  const std::string hint =
      fmt::format("write {} = [\"beam.B\", \"rod.B\"], or \"ground\" for one of them", of.key.name);
  Attachment ends[2];
  const std::size_t before = table.problems().size();
  const std::vector<std::string> references = table.texts(of.key, true);
  if (table.problems().size() != before) return {};
  if (references.size() != 2) {
    table.problem(of.key.name, fmt::format("{} connects two points", of.what), hint);
    return {};
  }
  if (of.ground_point) table.wants_with("at", of.key.name, "ground");
  int grounds = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    if (references[i] != "ground") {
      ends[i] = attachment_in<Attachment>(table, of.key.name, references[i], mechanism);
    } else if (++grounds == 1 && of.ground_point) {
      ends[i] = ground_at(table);
    }
  }
  if (grounds == 2 || (grounds == 0 && ends[0].body == ends[1].body && ends[0].body >= 0)) {
    table.problem(
        of.key.name,
        fmt::format("{} connects two different bodies, or a body and the ground", of.what), hint);
  }
  return {ends[0], ends[1]};
}

}  // namespace boxbeam::readers
