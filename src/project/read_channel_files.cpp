#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <future>
#include <utility>

#include "boxbeam/project/limits.hpp"
#include "recorded_reader.hpp"
#include "signals/file_unit.hpp"
#include "text_file.hpp"

namespace boxbeam::readers {
namespace {

std::vector<std::string> format_words() {
  std::vector<std::string> words;
  for (const SignalFormat format : all_signal_formats) words.emplace_back(word_of(format));
  return words;
}

bool same(const std::optional<WantedDimension>& a, const std::optional<WantedDimension>& b) {
  return a.has_value() == b.has_value() && (!a || a->exponents == b->exponents);
}

}  // namespace

ChannelFiles::ChannelFiles(TableReader& root, const TimeTables& tables) {
  for (auto& [name, table] :
       root.table({"files", "of measurements or other programs, by a name"}, false)
           .named_tables()) {
    File file{name, {}, {}, {}, {}, {}, Beyond::unsaid, table};
    TableReader& of = file.table;
    file.written = of.text({"path", "from the folder of the case"});
    file.source.path = tables.resolved(file.written);
    if (of.has_choice({"format", "of the file; by its content where not said"}, format_words())) {
      file.source.format = all_signal_formats[of.choice(
          {"format", "of the file; by its content where not said"}, format_words())];
    }
    if (of.has_quantity({"time_step", "of a file without time"}, wanted::time))
      file.source.time_step = of.positive({"time_step", "of a file without time"}, wanted::time);
    if (of.has_quantity({"time_unit", "of a time without unit, \"1 ms\""}, wanted::time))
      file.source.time_unit =
          of.positive({"time_unit", "of a time without unit, \"1 ms\""}, wanted::time);
    if (of.has_quantity({"force_unit", "of forces without unit, \"1 kN\""}, wanted::force))
      file.force_unit =
          of.positive({"force_unit", "of forces without unit, \"1 kN\""}, wanted::force);
    if (of.has_quantity({"moment_unit", "of moments without unit, \"1 kN m\""}, wanted::moment))
      file.moment_unit =
          of.positive({"moment_unit", "of moments without unit, \"1 kN m\""}, wanted::moment);
    const Key units{"units",
                    "what one of a column is, by its name, where the file gives no unit or one "
                    "that is not known: { Fz = \"9.81 kN\" }"};
    if (of.has(units)) read_units(of.table(units), file);
    const Key beyond{"beyond",
                     "what its columns are before its first and after its last instant, where "
                     "another file is longer: their first and last values, or nothing; where not "
                     "said, files that differ by more than a step are refused"};
    const std::vector<std::string> words{"held", "zero"};
    if (of.has_choice(beyond, words))
      file.beyond = of.choice(beyond, words) == 0 ? Beyond::held : Beyond::zero;
    of.finish();
    files_.push_back(std::move(file));
  }
}

void ChannelFiles::read_units(TableReader units, File& file) const {
  units.accept_all();
  for (const Node::Member& member : units.members("one of a column, \"9.81 kN\"")) {
    const auto one = member.value.kind == Node::Kind::text
                         ? parse_quantity(member.value.text)
                         : std::variant<ParsedQuantity, std::string>("it is no text");
    const auto* const quantity = std::get_if<ParsedQuantity>(&one);
    if (quantity != nullptr && quantity->value > 0.0) {
      file.units.emplace(member.key, *quantity);
      continue;
    }
    units.problem(
        member.key,
        fmt::format("what one of \"{}\" is cannot be read: {}", member.key,
                    quantity != nullptr ? "it is not above zero" : std::get<std::string>(one)),
        fmt::format("write for example {} = \"1 kN\"", member.key));
  }
}

std::optional<std::size_t> ChannelFiles::file_of(TableReader& table) {
  if (!table.has("file") && files_.size() == 1) return 0;
  const std::string name =
      table.text({"file", "the name of one of [files]; not needed where there is one only"});
  for (std::size_t i = 0; i < files_.size(); ++i) {
    if (files_[i].name == name) return i;
  }
  if (!name.empty()) {
    table.problem("file", fmt::format("there is no [files.{}]", name),
                  files_.empty() ? "write [files.measured] with path = \"measured.csv\""
                                 : unknown_hint(name, names_of(files_)));
  }
  return std::nullopt;
}

std::size_t ChannelFiles::channel_of(TableReader& table, const Key& key, std::size_t file,
                                     std::optional<WantedDimension> dimension) {
  const std::string name = table.text(key);
  for (std::size_t i = 0; i < wanted_.size(); ++i) {
    const Wanted& of = wanted_[i];
    if (of.file == file && of.signal.name == name && same(of.signal.dimension, dimension)) return i;
  }
  wanted_.push_back({file, {name, dimension, {}}, table, std::string(key.name)});
  return wanted_.size() - 1;
}

std::string ChannelFiles::description() const {
  std::string text;
  const auto add = [&](const auto& optional) {
    text += optional ? fmt::format("{} ", *optional) : "- ";
  };
  for (const File& file : files_) {
    const auto& format = file.source.format;
    add(format ? std::optional(word_of(*format)) : std::nullopt);
    add(file.source.time_step);
    add(file.source.time_unit);
    add(file.force_unit);
    add(file.moment_unit);
    for (const auto& [name, one] : file.units) text += fmt::format("{} {} ", name, one.value);
    text += fmt::format("{} ", static_cast<int>(file.beyond));
    text += file.source.path + '\n';
  }
  for (const Wanted& of : wanted_) {
    text += fmt::format("{} ", of.file);
    add(of.signal.dimension ? std::optional(of.signal.dimension->name) : std::nullopt);
    text += of.signal.name + '\n';
  }
  return text;
}

recorded::Channels ChannelFiles::read(TableReader& root, TimeTables& tables) const {
  if (!root.problems().empty() || root.problems().recorder != nullptr) return without_values();
  std::string made_of = description();
  if (const auto known = tables.files().channels(made_of)) {
    for (std::size_t f = 0; f < files_.size(); ++f)
      if (is_wanted(f)) tables.add_signals(files_[f].written);
    return *known;
  }
  recorded::Channels channels = read_files(root, tables);
  if (root.problems().empty())
    tables.files().keep_channels(std::move(made_of),
                                 std::make_shared<const recorded::Channels>(channels));
  return channels;
}

bool ChannelFiles::is_wanted(std::size_t file) const {
  return std::any_of(wanted_.begin(), wanted_.end(),
                     [&](const Wanted& of) { return of.file == file; });
}

recorded::Channels ChannelFiles::read_files(TableReader& root, TimeTables& tables) const {
  std::vector<Read> all;
  for (std::size_t f = 0; f < files_.size(); ++f) {
    if (!is_wanted(f)) continue;
    std::vector<WantedSignal> signals;
    for (const Wanted& of : wanted_)
      if (of.file == f) signals.push_back(of.signal);
    const FileText absent = look_for_regular_file(files_[f].source.path);
    if (absent.trouble != FileText::Trouble::none) {
      TableReader table = files_[f].table;
      table.problem("path",
                    absent.trouble == FileText::Trouble::missing
                        ? fmt::format("there is no file {}", files_[f].source.path)
                        : fmt::format("{}: {}", files_[f].source.path, absent.why),
                    "give the path of a file of signals, from the folder of the case");
      continue;
    }
    const SignalHead head = list_signals(files_[f].source);
    const bool compact = head.rows.value_or(0) > limits::most_samples;
    // The hash of a large file takes as long as reading it: beside that.
    std::future<void> hashed = std::async(compact ? std::launch::async : std::launch::deferred,
                                          [&, f] { tables.add_signals(files_[f].written); });
    if (!compact) hashed.get();
    const std::size_t before = root.problems().size();
    choose(f, head, signals);
    if (root.problems().size() != before) continue;
    if (head.rows.value_or(0) > limits::most_recorded) {
      root.problem("files",
                   fmt::format("{} has {} rows, {} can be verified", files_[f].written, *head.rows,
                               limits::most_recorded),
                   "give the part that matters, or fewer samples a second");
      continue;
    }
    all.push_back({f, read_signal_file(files_[f].source, signals, compact)});
    if (compact) hashed.get();
    if (all.back().table.time.count < 2) {
      TableReader table = files_[f].table;
      table.problem("path", fmt::format("{} has one instant only", files_[f].written),
                    "loads over time have two at least; what does not change is a constant load");
    }
  }
  if (!root.problems().empty()) return without_values();
  return on_one_time(root, std::move(all));
}

std::optional<double> ChannelFiles::unit_of(const Wanted& of, const SignalHead& head) const {
  const File& file = files_[of.file];
  if (!of.signal.dimension) return {};
  const auto own = file.units.find(of.signal.name);
  if (own != file.units.end()) {
    if (is_of(own->second.exponents, *of.signal.dimension)) return own->second.value;
    TableReader table = file.table;
    table.problem("units",
                  fmt::format("one of \"{}\" is {}, but it is to be {}", of.signal.name,
                              name_of(own->second.exponents), of.signal.dimension->name),
                  fmt::format("write {} = {}", of.signal.name, of.signal.dimension->example));
    return {};
  }
  // The unit that holds for all columns is for those to which the file gives none: what it calls
  // by another is something else.
  for (const SignalChannel& channel : head.channels)
    if (channel.name == of.signal.name && !channel.unit.empty()) return {};
  const bool couple = of.signal.dimension->exponents == wanted::moment.exponents;
  return couple ? file.moment_unit : file.force_unit;
}

void ChannelFiles::check_unit_of_all(std::size_t file, const SignalHead& head,
                                     const WantedDimension& dimension, const char* key,
                                     const std::optional<double>& unit) const {
  if (!unit) return;
  const SignalChannel* other = nullptr;
  for (const Wanted& of : wanted_) {
    if (of.file != file || !of.signal.dimension ||
        of.signal.dimension->exponents != dimension.exponents)
      continue;
    const auto channel =
        std::find_if(head.channels.begin(), head.channels.end(),
                     [&](const SignalChannel& at) { return at.name == of.signal.name; });
    if (channel == head.channels.end() || channel->unit.empty()) return;
    const auto parsed = parse_file_unit(channel->unit);
    const auto* const its = std::get_if<ParsedQuantity>(&parsed);
    constexpr double alike = 1e-9;
    if (its != nullptr && std::abs(its->value - *unit) > alike * *unit) other = &*channel;
  }
  if (other == nullptr) return;
  TableReader table = files_[file].table;
  table.problem(key,
                fmt::format("no column that is read is without a unit, and \"{}\" has another, {}",
                            other->name, other->unit),
                "take it away, or out of the file what is wrong there");
}

void ChannelFiles::choose(std::size_t file, const SignalHead& head,
                          std::vector<WantedSignal>& signals) const {
  std::vector<const Wanted*> of_file;
  for (const Wanted& of : wanted_)
    if (of.file == file) of_file.push_back(&of);
  for (std::size_t i = 0; i < signals.size(); ++i) signals[i].scale = unit_of(*of_file[i], head);
  check_unit_of_all(file, head, wanted::force, "force_unit", files_[file].force_unit);
  check_unit_of_all(file, head, wanted::moment, "moment_unit", files_[file].moment_unit);
  for (const ChosenSignals::Trouble& trouble : choose_signals(head, signals).troubles) {
    const Wanted& of = *of_file[trouble.wanted];
    const auto channel =
        std::find_if(head.channels.begin(), head.channels.end(),
                     [&](const SignalChannel& at) { return at.name == of.signal.name; });
    const bool unknown = of.signal.dimension && channel != head.channels.end() &&
                         !of.signal.scale && !channel->unit.empty() &&
                         std::holds_alternative<std::string>(parse_file_unit(channel->unit));
    TableReader table = of.table;
    table.problem(of.key, trouble.message,
                  unknown
                      ? fmt::format("say what one of it is, in [files.{}]: units = {{ {} = {} }}",
                                    files_[file].name, of.signal.name, of.signal.dimension->example)
                      : trouble.hint);
  }
}

}  // namespace boxbeam::readers
