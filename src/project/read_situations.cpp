#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "boxbeam/project/limits.hpp"
#include "front_end_reader.hpp"
#include "readers.hpp"

namespace boxbeam::readers {
namespace {

/// The value of a key as the report shows it.
std::string text_of(const Node& value) {
  switch (value.kind) {
    case Node::Kind::text: return value.text;
    case Node::Kind::number: return fmt::format("{:.12g}", value.number);
    case Node::Kind::boolean: return value.boolean ? "true" : "false";
    case Node::Kind::array: {
      std::vector<std::string> items;
      for (const Node& item : value.items) items.push_back(text_of(item));
      return fmt::format("[{}]", fmt::join(items, ", "));
    }
    default: return "...";
  }
}

/// A value that differs, with its full key.
struct Change {
  std::vector<std::string> parts;
  const Node::Member* member;

  std::string key() const { return fmt::format("{}", fmt::join(parts, ".")); }
};

/// The values in a table, whether written "drivers.exciter.frequency" = ... or in tables within it.
void collect(const std::vector<Node::Member>& members, const std::vector<std::string>& above,
             std::vector<Change>& changes) {
  for (const Node::Member& member : members) {
    std::vector<std::string> parts = above;
    for (std::string& part : key_parts(member.key)) parts.push_back(std::move(part));
    if (member.value.kind == Node::Kind::table)
      collect(member.value.members, parts, changes);
    else
      changes.push_back({std::move(parts), &member});
  }
}

/// What a part of the case has under a key, nullptr where it has nothing there.
const Node* member_of(const Node* table, const std::string& key) {
  if (table == nullptr || table->kind != Node::Kind::table) return nullptr;
  const auto found = std::find_if(table->members.begin(), table->members.end(),
                                  [&](const Node::Member& member) { return member.key == key; });
  return found != table->members.end() ? &found->value : nullptr;
}

/// Notes a change of a body, joint, driver, force or loop that the case does not have, unless the
/// situation adds it with its kind.
bool is_there(ProblemList& problems, const Change& change, const std::vector<Change>& changes,
              const Node& root) {
  const std::vector<std::string>& parts = change.parts;
  const Node* part = member_of(&root, parts[0]);
  if (parts.size() < 3 || member_of(part, parts[1]) != nullptr) return true;
  const std::vector<std::string> kind{parts[0], parts[1], "kind"};
  if (std::any_of(changes.begin(), changes.end(),
                  [&](const Change& other) { return other.parts == kind; })) {
    return true;
  }
  std::vector<std::string> known;
  if (part != nullptr) {
    for (const Node::Member& member : part->members) known.push_back(member.key);
  }
  problems.add(change.member->key_place,
               fmt::format("the case has no [{}.{}] that could change", parts[0], parts[1]),
               unknown_hint(parts[1], known));
  return false;
}

/// Whether a value may differ in a situation; notes it where not.
bool may_change(ProblemList& problems, const Change& change, const Changeable& changes) {
  const std::vector<std::string>& parts = change.parts;
  const Place& place = change.member->key_place;
  const bool known =
      parts.size() > 1 && std::find(parts.begin(), parts.end(), "") == parts.end() &&
      std::find(changes.parts.begin(), changes.parts.end(), parts[0]) != changes.parts.end();
  if (!known) {
    problems.add(place, fmt::format("a situation cannot change \"{}\"", change.key()),
                 fmt::format("it changes how the mechanism runs, with the full key: "
                             "\"{}\"; one of {}",
                             changes.example, fmt::join(changes.parts, ", ")));
    return false;
  }
  // How the beam's link is modelled and placed may differ, not where its points are.
  const bool link =
      parts[0] == "links" && parts.size() > 2 && (parts[2] == "points" || parts[2] == "length");
  if ((parts[0] == "bodies" || link) && parts[1] == changes.beam) {
    problems.add(place, "a situation cannot change the beam itself",
                 "write a case of its own for another beam");
    return false;
  }
  return true;
}

/// The keys of functions of time. They mean something for their own kind only.
constexpr std::array function_keys{
    "mean",    "amplitude",     "phase",  "frequency",    "angular_frequency",
    "further", "start",         "rate",   "coefficients", "from",
    "to",      "begin",         "end",    "file",         "periodic",
    "value",   "interpolation", "beyond", "overshoot"};

/// Where a situation gives a function of time another kind, what the case says of the old kind
/// falls away.
void drop_old_kind(Node& root, const Change& change) {
  if (change.parts.back() != "kind") return;
  Node* table = &root;
  for (std::size_t i = 0; i + 1 < change.parts.size(); ++i) {
    const auto member = std::find_if(table->members.begin(), table->members.end(),
                                     [&](const auto& m) { return m.key == change.parts[i]; });
    if (member == table->members.end()) return;
    table = &member->value;
  }
  std::erase_if(table->members, [](const Node::Member& member) {
    return std::find(function_keys.begin(), function_keys.end(), member.key) != function_keys.end();
  });
}

/// The mechanism as it runs in a situation: the case once more with other values.
AnyMechanism changed_mechanism(TableReader& set, const Node& root, Situation& situation,
                               const Project& project, const FrontEndReader& front_end) {
  ProblemList& problems = set.problems();
  const Changeable changeable = front_end.changeable();
  std::vector<Change> changes;
  collect(set.members("another value of that key of the case"), {}, changes);
  // The case without its situations: each would copy all of them.
  Node changed;
  changed.place = root.place;
  for (const Node::Member& member : root.members) {
    if (member.key != "situations") changed.members.push_back(member);
  }
  for (const Change& change : changes) {
    // Of forces, "from" and "to" are places; their functions of time stand in "law".
    if (change.parts[0] == "drivers" || change.parts.size() > 3) drop_old_kind(changed, change);
  }
  for (const Change& change : changes) {
    if (!may_change(problems, change, changeable) || !is_there(problems, change, changes, root))
      continue;
    const Node::Member& member = *change.member;
    situation.set.push_back(fmt::format("{} = {}", change.key(), text_of(member.value)));
    if (const auto trouble = set_value(changed, change.parts, member.key_place, member.value)) {
      problems.add(member.key_place, *trouble, "write the key as it stands in the case");
    }
  }
  if (!problems.empty()) return project.mechanism;
  // Of a tree that does not last nothing is recorded; its keys are those of the case.
  KeyRecorder* const recorder = std::exchange(problems.recorder, nullptr);
  TableReader reader(problems, changed, "");
  AnyMechanism mechanism = front_end.changed_mechanism(reader);
  problems.recorder = recorder;
  return mechanism;
}

/// The situations of which one is made, which are read before; `key` is "between" or "sequence".
std::vector<std::size_t> read_parts(TableReader& table, const Key& of, bool in_order,
                                    const std::vector<Situation>& situations) {
  const std::string_view key = of.name;
  std::vector<std::size_t> parts;
  std::vector<std::string> running;
  for (const Situation& other : situations) {
    if (other.runs()) running.push_back(other.name);
  }
  for (const std::string& name : table.texts(of, true)) {
    const auto found =
        std::find_if(situations.begin(), situations.end(),
                     [&](const Situation& other) { return other.name == name && other.runs(); });
    if (found == situations.end()) {
      table.problem(key, fmt::format("no situation above is \"{}\"", name),
                    unknown_hint(name, running));
      continue;
    }
    const auto part = static_cast<std::size_t>(found - situations.begin());
    if (!in_order && std::find(parts.begin(), parts.end(), part) != parts.end())
      table.problem(key, fmt::format("\"{}\" stands there already", name),
                    "a change goes from one situation to others: write each once");
    parts.push_back(part);
  }
  if (table.problems().empty() && parts.empty()) {
    table.problem(key, fmt::format("\"{}\" names no situation", key),
                  fmt::format("write for example {} = [\"standstill\", \"normal running\"]", key));
  }
  return parts;
}

/// The levels of a change that is not always whole; `repetitions` of all of them.
std::vector<SpectrumLevel> read_spectrum(TableReader& table, double repetitions) {
  std::vector<SpectrumLevel> spectrum;
  double largest = 0.0, all = 0.0;
  for (TableReader& of :
       table.tables({"spectrum", "of \"between\": how often which share of the change happens"})) {
    SpectrumLevel& level = spectrum.emplace_back();
    level.share = of.number({"share", "of the whole change, at most 1"});
    level.cycles = repetitions * of.number({"cycles", "of this share"}, {}, "1e5");
    if (level.share > 1.0) {
      of.problem("share", fmt::format("{:g} of the change is more than the whole", level.share),
                 "let the situations be the largest change, which strength knows, and write shares "
                 "of that");
    }
    largest = std::max(largest, level.share);
    all += level.cycles;
    of.finish();
  }
  if (!table.problems().empty()) return spectrum;
  if (spectrum.empty()) {
    table.problem("spectrum", "the spectrum has no level",
                  "write for example spectrum = [{ share = 1.0, cycles = 5000 }]");
  } else if (largest < 1.0) {
    table.problem("spectrum", fmt::format("the largest share is {:g}", largest),
                  fmt::format("let the situations be the largest change and divide the shares by "
                              "{0:g}, so that it has the share 1",
                              largest));
  }
  if (all > limits::most_cycles) {
    table.problem("spectrum", fmt::format("{:g} cycles are too many to be meant", all),
                  fmt::format("at most {:g} in all", limits::most_cycles));
  }
  return spectrum;
}

/// A situation made of others: a change between them, or one after the other.
void read_made_of(TableReader& table, const std::vector<Situation>& others, Situation& situation) {
  situation.in_order = table.has("sequence");
  const Key of =
      situation.in_order
          ? Key("sequence", "situations one after the other, counted as one history")
          : Key("between", "situations: one cycle from extreme to extreme of all of them");
  const std::string_view key = of.name;
  if (situation.in_order && table.has("between")) {
    table.problem("between", "a situation is either a change between others or their sequence",
                  "write one of \"between\" and \"sequence\"");
    return;
  }
  situation.between = read_parts(table, of, situation.in_order, others);
  const bool levels = table.has("spectrum");
  if (levels && situation.in_order) {
    table.problem("spectrum", "a sequence of situations is counted, it has no levels",
                  "write the levels in a change: between = [...]");
  } else if (levels) {
    situation.spectrum = read_spectrum(table, table.has("cycles") ? situation.cycles : 1.0);
    situation.cycles = 0.0;
    for (const SpectrumLevel& level : situation.spectrum) situation.cycles += level.cycles;
  }
  if (situation.cycles == 0.0 && !levels && table.problems().empty()) {
    table.problem(key,
                  fmt::format("{} counts for fatigue only, and this one never happens",
                              situation.in_order ? "a sequence of situations"
                                                 : "a change between situations"),
                  situation.in_order ? "write how often: cycles = 5000"
                                     : "write how often: cycles = 5000; or the shares of the "
                                       "change and their cycles: spectrum = [{ share = 1.0, "
                                       "cycles = 5000 }, ...]");
  }
  if (table.has("set") || table.has("load_factor") || table.has("sudden_start")) {
    table.problem(key,
                  fmt::format("{} has no loads of its own", situation.in_order
                                                                ? "a sequence of situations"
                                                                : "a change between situations"),
                  "write \"set\" and \"load_factor\" in the situations that it is made of");
    if (table.has("set")) table.table("set").accept_all();
  }
}

/// "cycles": repetitions in the wanted life.
double read_cycles(TableReader& table) {
  const double cycles = table.number(
      {"cycles", "repetitions of the motion, or spectrum, in the wanted life"}, {}, "1e7");
  if (cycles > limits::most_cycles) {
    table.problem("cycles", fmt::format("{:g} cycles are too many to be meant", cycles),
                  fmt::format("at most {:g}: a thousand in every second of thirty thousand years",
                              limits::most_cycles));
  }
  return cycles;
}

/// Whether the vibrating loads of a situation begin at once.
bool read_sudden_start(TableReader& table, const FrontEndReader& front_end,
                       const Project& project) {
  const bool sudden_start = table.boolean(
      {"sudden_start",
       "elastic links: the vibrating loads are switched on at once on the structure at rest"},
      false);
  if (!sudden_start) return false;
  if (!front_end.vibrates()) {
    table.problem("sudden_start", "a sudden start is known for elastic links only",
                  "leave it out, or write the start as a driver or a force over time");
  }
  const auto* links = std::get_if<flexible::Mechanism>(&project.mechanism);
  if (links != nullptr) {
    for (const flexible::Link& link : links->links) {
      if (link.parts <= limits::most_parts_at_start) continue;
      table.problem("sudden_start",
                    fmt::format("the link {} has {} parts, of which the whole history after a "
                                "start is kept: at most {}",
                                link.name, link.parts, limits::most_parts_at_start),
                    "give it fewer parts");
    }
  }
  return true;
}

}  // namespace

void read_situations(TableReader& root, const Node& tree, const FrontEndReader& front_end,
                     Project& project) {
  std::vector<TableReader> listed = root.tables({"situations", "ways in which the beam is used"});
  const bool asked = root.has("fatigue");
  TableReader fatigue = root.table("fatigue", false);
  std::vector<Situation> combined = front_end.read_combinations(root);
  if (listed.empty() && combined.empty()) {
    Situation& only = project.situations.emplace_back();
    if (asked) only.cycles = read_cycles(fatigue);
    return;
  }
  if (fatigue.has("cycles")) {
    fatigue.problem("cycles", "the cycles of a case with situations belong to each of them",
                    "move \"cycles\" to [[situations]]");
  }
  for (TableReader& table : listed) {
    Situation situation;
    situation.name = table.text({"name", "of the situation"});
    if (std::any_of(project.situations.begin(), project.situations.end(),
                    [&](const Situation& other) { return other.name == situation.name; })) {
      table.problem("name", fmt::format("there is already a situation \"{}\"", situation.name),
                    "give every situation a name of its own");
    }
    situation.cycles = table.has("cycles") ? read_cycles(table) : 0.0;
    if (table.has("between") || table.has("sequence")) {
      read_made_of(table, project.situations, situation);
    } else {
      if (table.has_misplaced("spectrum")) {
        table.problem("spectrum", "only a change between situations has levels",
                      "write a situation for it: between = [\"empty\", \"lifting\"]");
      }
      situation.load_factor = table.number({"load_factor", "on all its loads, for strength"}, 1.0);
      situation.sudden_start = read_sudden_start(table, front_end, project);
      if (table.has("set")) {
        TableReader set =
            table.table({"set", "what differs: \"drivers.exciter.frequency\" = \"0.8 Hz\""});
        set.accept_all();
        situation.changed = changed_mechanism(set, tree, situation, project, front_end);
      }
      front_end.read_loads(table, situation);
    }
    table.finish();
    project.situations.push_back(std::move(situation));
  }
  std::move(combined.begin(), combined.end(), std::back_inserter(project.situations));
  if (!root.problems().empty()) return;
  if (project.dynamics == Dynamics::newton_chain && project.situations.size() > 1) {
    root.problem("situations", "the published Newton chain knows one situation only",
                 "use rigorous dynamics, or remove [[situations]]");
  }
  // Without [fatigue] nothing is counted; what only counts falls away.
  if (!asked) {
    for (Situation& situation : project.situations) situation.cycles = 0.0;
    return;
  }
  if (std::none_of(project.situations.begin(), project.situations.end(),
                   [](const Situation& situation) { return situation.cycles > 0.0; })) {
    root.problem("situations", "no situation ever happens",
                 "write \"cycles\", its repetitions in the wanted life, in at least one");
  }
}

}  // namespace boxbeam::readers
