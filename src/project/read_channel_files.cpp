#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <future>
#include <utility>

#include "boxbeam/project/limits.hpp"
#include "recorded_reader.hpp"
#include "text_file.hpp"

namespace boxbeam::readers {
namespace {

std::vector<std::string> format_words() {
  std::vector<std::string> words;
  for (const SignalFormat format : all_signal_formats) words.emplace_back(word_of(format));
  return words;
}

/// What cannot be read further: two instants, so that the rest has something to look at.
recorded::Channels nothing(std::size_t channels) {
  return {{0.0, 1.0}, std::vector<std::vector<double>>(channels, {0.0, 0.0})};
}

bool same(const std::optional<WantedDimension>& a, const std::optional<WantedDimension>& b) {
  return a.has_value() == b.has_value() && (!a || a->exponents == b->exponents);
}

/// Whether all have the same instants.
bool of_one_time(const std::vector<SignalTable>& all) {
  const SignalTime& one = all.front().time;
  return std::all_of(all.begin(), all.end(), [&](const SignalTable& table) {
    const SignalTime& other = table.time;
    return other.count == one.count && other.instants == one.instants &&
           (!one.instants.empty() || (other.start == one.start && other.step == one.step));
  });
}

/// Of a long record instants evenly taken, its ends, and those at which a channel is largest or
/// smallest.
recorded::Channels some_instants_of(recorded::Record of) {
  constexpr std::size_t evenly = 1000;
  const auto record = std::make_shared<const recorded::Record>(std::move(of));
  const std::size_t n = record->instants();
  std::vector<std::size_t> instants{n - 1};
  for (std::size_t i = 0; i < evenly; ++i) instants.push_back(i * (n - 1) / evenly);
  for (std::size_t k = 0; k < record->channels(); ++k) {
    std::size_t low = 0, high = 0;
    double lowest = record->value(k, 0), highest = lowest;
    for (std::size_t i = 0; i < n; ++i) {
      const double value = record->value(k, i);
      if (value < lowest) {
        lowest = value;
        low = i;
      }
      if (value > highest) {
        highest = value;
        high = i;
      }
    }
    instants.push_back(low);
    instants.push_back(high);
  }
  recorded::Channels channels = recorded::at_instants(record, std::move(instants));
  channels.outer =
      std::make_shared<const recorded::OuterInstants>(recorded::outer_instants_of(*record));
  return channels;
}

}  // namespace

ChannelFiles::ChannelFiles(TableReader& root, const TimeTables& tables) {
  for (auto& [name, table] :
       root.table({"files", "of measurements or other programs, by a name"}, false)
           .named_tables()) {
    File file{name, {}, {}, {}, {}, table};
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
    of.finish();
    files_.push_back(std::move(file));
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
  std::optional<double> scale;
  if (dimension) {
    const bool couple = dimension->exponents == wanted::moment.exponents;
    scale = couple ? files_[file].moment_unit : files_[file].force_unit;
  }
  wanted_.push_back({file, {name, dimension, scale}, table, std::string(key.name)});
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
    text += file.source.path + '\n';
  }
  for (const Wanted& of : wanted_) {
    text += fmt::format("{} ", of.file);
    add(of.signal.dimension ? std::optional(of.signal.dimension->name) : std::nullopt);
    add(of.signal.scale);
    text += of.signal.name + '\n';
  }
  return text;
}

recorded::Channels ChannelFiles::read(TableReader& root, TimeTables& tables) const {
  if (!root.problems().empty() || root.problems().recorder != nullptr)
    return nothing(wanted_.size());
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
  std::vector<SignalTable> all;
  for (std::size_t f = 0; f < files_.size(); ++f) {
    std::vector<const Wanted*> of_file;
    std::vector<WantedSignal> signals;
    for (const Wanted& of : wanted_) {
      if (of.file != f) continue;
      of_file.push_back(&of);
      signals.push_back(of.signal);
    }
    all.emplace_back();
    if (signals.empty()) continue;
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
    // The unit that the case gives is for columns to which the file gives none that is known.
    for (WantedSignal& of : signals) {
      const std::optional<double> scale = std::exchange(of.scale, std::nullopt);
      if (!choose_signals(head, {of}).troubles.empty()) of.scale = scale;
    }
    const ChosenSignals chosen = choose_signals(head, signals);
    for (const ChosenSignals::Trouble& trouble : chosen.troubles) {
      TableReader table = of_file[trouble.wanted]->table;
      table.problem(of_file[trouble.wanted]->key, trouble.message, trouble.hint);
    }
    if (!chosen.troubles.empty()) continue;
    if (head.rows.value_or(0) > limits::most_recorded) {
      root.problem("files",
                   fmt::format("{} has {} rows, {} can be verified", files_[f].written, *head.rows,
                               limits::most_recorded),
                   "give the part that matters, or fewer samples a second");
      continue;
    }
    all.back() = read_signal_file(files_[f].source, signals, compact);
    if (compact) hashed.get();
    if (all.back().time.count < 2) {
      TableReader table = files_[f].table;
      table.problem("path", fmt::format("{} has one instant only", files_[f].written),
                    "loads over time have two at least; what does not change is a constant load");
    }
  }
  if (!root.problems().empty()) return nothing(wanted_.size());
  return on_one_time(root, std::move(all));
}

recorded::Channels ChannelFiles::on_one_time(TableReader& root,
                                             std::vector<SignalTable> all) const {
  std::erase_if(all, [](const SignalTable& table) { return table.columns.empty(); });
  if (all.empty()) return {{0.0, 1.0}, {}};
  recorded::Channels channels;
  const auto first = [](const SignalTable& of) { return of.time[0]; };
  const auto last = [](const SignalTable& of) { return of.time[of.time.count - 1]; };
  double from = first(all.front()), to = last(all.front());
  std::size_t samples = 0;
  for (const SignalTable& of : all) {
    from = std::max(from, first(of));
    to = std::min(to, last(of));
    samples += of.time.count;
  }
  if (!(from < to) || samples > limits::most_recorded) {
    root.problem("files",
                 from < to ? fmt::format("the files have {} instants in all, {} can be verified",
                                         samples, limits::most_recorded)
                           : fmt::format("the files have no time in common: one of them begins at "
                                         "{:.6g} s, one ends at {:.6g} s",
                                         from, to),
                 from < to ? "give the part that matters, or fewer samples a second"
                           : "shift the time of one of them");
    return nothing(wanted_.size());
  }
  if (samples > limits::most_samples && of_one_time(all)) return long_channels(std::move(all));
  channels.times.reserve(samples);
  for (const SignalTable& of : all) {
    for (std::size_t i = 0; i < of.time.count; ++i) {
      if (of.time[i] >= from && of.time[i] <= to) channels.times.push_back(of.time[i]);
    }
  }
  std::sort(channels.times.begin(), channels.times.end());
  // Clocks that agree but for rounding tell the same instants.
  const double close = 1e-9 * (to - from) / static_cast<double>(channels.times.size());
  const auto is_same = [&](double a, double b) { return b - a <= close; };
  channels.times.erase(std::unique(channels.times.begin(), channels.times.end(), is_same),
                       channels.times.end());
  std::size_t table = 0;
  std::vector<std::pair<const SignalTable*, std::size_t>> columns(wanted_.size());
  for (std::size_t f = 0; f < files_.size(); ++f) {
    std::size_t column = 0;
    for (std::size_t w = 0; w < wanted_.size(); ++w) {
      if (wanted_[w].file == f) columns[w] = {&all[table], column++};
    }
    if (column > 0) ++table;
  }
  const bool is_long = channels.times.size() > limits::most_samples;
  std::vector<recorded::RecordColumn> long_columns;
  std::vector<double> values;
  for (const auto& [of, index] : columns) {
    const SignalColumn& column = of->columns[index];
    values.clear();
    values.reserve(channels.times.size());
    std::size_t at = 0;
    for (const double time : channels.times) {
      while (at + 2 < of->time.count && of->time[at + 1] <= time) ++at;
      const double a = of->time[at], b = of->time[at + 1];
      const double part = std::clamp((time - a) / (b - a), 0.0, 1.0);
      values.push_back(std::lerp(column[at], column[at + 1], part));
    }
    if (!is_long) {
      channels.values.push_back(values);
      continue;
    }
    SignalColumn compact(true, true);
    compact.append(values);
    const double offset = compact.offset();
    long_columns.push_back({compact.release(), offset});
  }
  if (!is_long) return channels;
  return some_instants_of(
      recorded::Record(0.0, 0.0, std::move(channels.times), std::move(long_columns)));
}

recorded::Channels ChannelFiles::long_channels(std::vector<SignalTable> all) const {
  std::vector<recorded::RecordColumn> columns;
  std::size_t table = 0;
  std::vector<std::pair<std::size_t, std::size_t>> of(wanted_.size());
  for (std::size_t f = 0; f < files_.size(); ++f) {
    std::size_t column = 0;
    for (std::size_t w = 0; w < wanted_.size(); ++w) {
      if (wanted_[w].file == f) of[w] = {table, column++};
    }
    if (column > 0) ++table;
  }
  for (const auto& [in, index] : of) {
    SignalColumn& column = all[in].columns[index];
    const double offset = column.offset();
    columns.push_back({column.release(), offset});
  }
  SignalTime& time = all.front().time;
  return some_instants_of(
      recorded::Record(time.start, time.step, std::move(time.instants), std::move(columns)));
}

}  // namespace boxbeam::readers
