#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "boxbeam/project/limits.hpp"
#include "recorded_reader.hpp"

namespace boxbeam::readers {
namespace {

/// Whether all have the same instants.
bool of_one_time(const std::vector<const SignalTime*>& all) {
  const SignalTime& one = *all.front();
  return std::all_of(all.begin(), all.end(), [&](const SignalTime* time) {
    const SignalTime& other = *time;
    return other.count == one.count && other.instants == one.instants &&
           (!one.instants.empty() || (other.start == one.start && other.step == one.step));
  });
}

double first_of(const SignalTime& time) { return time[0]; }
double last_of(const SignalTime& time) { return time[time.count - 1]; }

/// A value between two instants of a column, linear; before its first and after its last those.
/// `at` is the instant before it, or one before that, and follows.
double value_at(double time, const SignalTime& times, const SignalColumn& column, std::size_t& at) {
  while (at + 2 < times.count && times[at + 1] <= time) ++at;
  const double a = times[at], b = times[at + 1];
  const double part = std::clamp((time - a) / (b - a), 0.0, 1.0);
  return std::lerp(column[at], column[at + 1], part);
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

void ChannelFiles::refuse_unlike_times(TableReader& root, const std::vector<Read>& all) const {
  const auto begins_first = std::min_element(
      all.begin(), all.end(),
      [](const Read& a, const Read& b) { return first_of(a.table.time) < first_of(b.table.time); });
  const auto ends_last = std::max_element(all.begin(), all.end(), [](const Read& a, const Read& b) {
    return last_of(a.table.time) < last_of(b.table.time);
  });
  const double from = first_of(begins_first->table.time), to = last_of(ends_last->table.time);
  for (const Read& of : all) {
    const File& file = files_[of.file];
    if (file.beyond != Beyond::unsaid) continue;
    // Between instants of its own nobody knows more of it.
    constexpr double a_step = 1.0 + 1e-6;
    const SignalTime& time = of.table.time;
    const std::size_t n = time.count;
    const double first = time[0], last = time[n - 1];
    const bool begins_late = first - from > a_step * (time[1] - first);
    const bool ends_soon = to - last > a_step * (last - time[n - 2]);
    if (!begins_late && !ends_soon) continue;
    const Read& longer = begins_late ? *begins_first : *ends_last;
    const SignalTime& other = longer.table.time;
    const bool apart = first > last_of(other) || last < first_of(other);
    root.problem(
        "files",
        fmt::format("{} goes from {:.6g} to {:.6g} s, {} from {:.6g} to {:.6g} s: {}", file.written,
                    first, last, files_[longer.file].written, first_of(other), last_of(other),
                    apart ? "they have no time in common"
                          : "what the one has in the rest of the other's time is not known"),
        fmt::format("give both over the same time, or say in [files.{}] what is beyond it: beyond "
                    "= \"held\" keeps its first and last values, \"zero\" takes nothing to act",
                    file.name));
    return;
  }
}

recorded::Channels ChannelFiles::on_one_time(TableReader& root, std::vector<Read> all) const {
  if (all.empty()) return {{0.0, 1.0}, {}};
  refuse_unlike_times(root, all);
  std::vector<const SignalTime*> times;
  std::size_t samples = 0;
  for (const Read& of : all) {
    times.push_back(&of.table.time);
    samples += of.table.time.count;
  }
  if (samples > limits::most_recorded) {
    root.problem("files",
                 fmt::format("the files have {} instants in all, {} can be verified", samples,
                             limits::most_recorded),
                 "give the part that matters, or fewer samples a second");
  }
  if (!root.problems().empty()) return without_values();
  if (samples > limits::most_samples && of_one_time(times)) return long_channels(std::move(all));
  recorded::Channels channels;
  channels.times.reserve(samples);
  for (const SignalTime* of : times)
    for (std::size_t i = 0; i < of->count; ++i) channels.times.push_back((*of)[i]);
  std::sort(channels.times.begin(), channels.times.end());
  // Clocks that agree but for rounding tell the same instants.
  const double close = 1e-9 * (channels.times.back() - channels.times.front()) /
                       static_cast<double>(channels.times.size());
  const auto is_same = [&](double a, double b) { return b - a <= close; };
  channels.times.erase(std::unique(channels.times.begin(), channels.times.end(), is_same),
                       channels.times.end());
  const bool is_long = channels.times.size() > limits::most_samples;
  std::vector<recorded::RecordColumn> long_columns;
  std::vector<double> values;
  for (const auto& [read, index] : columns_in(all)) {
    const SignalTable& of = all[read].table;
    const bool ends = files_[all[read].file].beyond == Beyond::zero;
    values.clear();
    values.reserve(channels.times.size());
    std::size_t at = 0;
    for (const double time : channels.times) {
      const bool beyond = time < first_of(of.time) - close || time > last_of(of.time) + close;
      values.push_back(ends && beyond ? 0.0 : value_at(time, of.time, of.columns[index], at));
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

std::vector<std::pair<std::size_t, std::size_t>> ChannelFiles::columns_in(
    const std::vector<Read>& all) const {
  std::vector<std::pair<std::size_t, std::size_t>> columns(wanted_.size());
  for (std::size_t r = 0; r < all.size(); ++r) {
    std::size_t column = 0;
    for (std::size_t w = 0; w < wanted_.size(); ++w)
      if (wanted_[w].file == all[r].file) columns[w] = {r, column++};
  }
  return columns;
}

recorded::Channels ChannelFiles::long_channels(std::vector<Read> all) const {
  std::vector<recorded::RecordColumn> columns;
  for (const auto& [read, index] : columns_in(all)) {
    SignalColumn& column = all[read].table.columns[index];
    const double offset = column.offset();
    columns.push_back({column.release(), offset});
  }
  SignalTime& time = all.front().table.time;
  return some_instants_of(
      recorded::Record(time.start, time.step, std::move(time.instants), std::move(columns)));
}

}  // namespace boxbeam::readers
