#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

#include "number_rows.hpp"
#include "signal_reader.hpp"
#include "text_lines.hpp"

namespace boxbeam {
namespace {

constexpr const char* mbdyn_hint =
    "give a .jnt, .frc or .act file of MBDyn: for each step a row for each label, label and "
    "numbers";

/// The instants at which MBDyn wrote its results, from its .out file: the lines
///
///     # Step Time TStep NIter ResErr SolErr SolConv Out
///     Step 0 0 0.001 0 0 0 0 1
///
/// without those whose Out is 0 (older versions have no such column and write each step).
/// Source: MBDyn, mbdyn/base/solver.cc.
class MbdynInstants {
 public:
  explicit MbdynInstants(const std::string& path) : lines_(std::make_unique<FileBytes>(path)) {}

  /// The next one [s]; none behind the last.
  std::optional<double> next() {
    while (lines_.next()) {
      const std::string_view line = lines_.line();
      if (line.starts_with("# Step ")) has_out_ = trimmed(line).ends_with(" Out");
      if (!line.starts_with("Step ")) continue;
      const std::vector<Field> words = signal_fields(line, ' ');
      if (words.size() < 4 || (has_out_ && words.size() < 9)) {
        lines_.fail(1, "this line of a step is not complete", "let MBDyn write the file once more");
      }
      if (has_out_ && words.back().text == "0") continue;
      double time = 0.0;
      read_numbers(lines_, words[2].text, 1, &time, "let MBDyn write the file once more");
      ++count_;
      return time;
    }
    return std::nullopt;
  }

  const TextLines& lines() const { return lines_; }
  std::uint64_t count() const { return count_; }

 private:
  TextLines lines_;
  bool has_out_ = false;
  std::uint64_t count_ = 0;
};

class MbdynReader : public SignalReader {
 public:
  MbdynReader(SignalBytes bytes, const SignalSource& source) {
    head_.path = source.path;
    head_.format = SignalFormat::mbdyn;
    head_.time_step = source.time_step;
    find_instants(source);
    TextLines lines(std::move(bytes));
    // The first step ends where its first label comes again.
    while (lines.next()) {
      if (trimmed(lines.line()).empty()) continue;
      const std::vector<Field> words = signal_fields(lines.line(), ' ');
      const std::string label(words.front().text);
      if (!labels_.empty() && label == labels_.front().label) break;
      take_label(lines, label, words.size() - 1);
    }
    if (labels_.empty()) lines.bytes().fail("the file is empty", mbdyn_hint);
  }

  void read(const std::vector<std::size_t>& columns, RowBlock& block) override {
    const std::vector<std::vector<Wanted>> wanted = wanted_by_label(columns);
    TextLines lines(std::make_unique<FileBytes>(head_.path));
    if (!has_instants_ && !head_.time_step) {
      lines.bytes().fail(fmt::format("MBDyn writes no time here, and there is no {}", out_path_),
                         "put the .out file of the run beside it, or give the time step");
    }
    std::optional<MbdynInstants> instants;
    if (has_instants_) instants.emplace(out_path_);
    std::vector<double> values(columns.size());
    std::uint64_t steps = 0;
    for (; read_step(lines, steps, wanted, values); ++steps) {
      const double time = instants ? time_of(*instants, lines, steps)
                                   : static_cast<double>(steps) * *head_.time_step;
      if (const auto trouble = block.take(time, values.data())) {
        (instants ? instants->lines() : lines).fail(1, trouble->message, trouble->hint);
      }
    }
    if (!instants || !instants->next()) return;
    while (instants->next()) continue;
    lines.bytes().fail(
        fmt::format("{} tells {} instants, here are {} steps", out_path_, instants->count(), steps),
        "let MBDyn write both files once more, or give the time step");
  }

 private:
  struct Label {
    std::string label;
    std::size_t width = 0;  ///< numbers behind it
    std::size_t first = 0;  ///< channel
  };
  /// A value of a label's row that goes to a place of the wanted ones.
  struct Wanted {
    std::size_t value = 0;
    std::size_t to = 0;
  };

  void find_instants(const SignalSource& source) {
    out_path_ = std::filesystem::path(source.path).replace_extension(".out").string();
    std::error_code error;
    has_instants_ = !source.time_step && std::filesystem::is_regular_file(out_path_, error);
  }

  void take_label(const TextLines& lines, const std::string& label, std::size_t width) {
    constexpr std::size_t most_channels = 100'000;
    const bool known = !known_.insert(label).second;
    if (known) {
      lines.fail(1,
                 fmt::format("the label {} comes a second time before {} does", utf8_of(label),
                             utf8_of(labels_.front().label)),
                 mbdyn_hint);
    }
    const std::string_view digits = std::string_view(label).substr(0, label.find('@'));
    if (digits.empty() || digits.find_first_not_of("0123456789") != std::string_view::npos) {
      lines.fail(1, fmt::format("\"{}\" is no label of an element", utf8_of(label)), mbdyn_hint);
    }
    if (width == 0) lines.fail(1, "a label without numbers", mbdyn_hint);
    if (head_.channels.size() + width > most_channels) {
      lines.fail(1, fmt::format("a step has more than {} numbers", most_channels), mbdyn_hint);
    }
    labels_.push_back({label, width, head_.channels.size()});
    for (std::size_t i = 0; i < width; ++i) {
      head_.channels.push_back({fmt::format("{}.{}", label, name_of_value(i, label, width)), {}});
    }
  }

  /// Source: MBDyn input manual, output of joints, of beams, of external structural forces.
  std::string name_of_value(std::size_t i, const std::string& label, std::size_t width) const {
    static constexpr const char* components[] = {"Fx", "Fy", "Fz", "Mx", "My", "Mz"};
    const std::string extension = std::filesystem::path(head_.path).extension().string();
    const char* const component = components[i % 6];
    if (extension == ".jnt" && width >= 12 && i < 12) {
      return fmt::format("{}.{}", i < 6 ? "local" : "global", component);
    }
    if (extension == ".act" && (width == 6 || width == 12)) {
      return fmt::format("{}.{}", i < 6 ? "I" : "II", component);
    }
    const bool external = extension == ".frc" && label.find('@') != std::string::npos;
    if (external && width == 6) return component;
    return fmt::format("c{}", i + 2);
  }

  std::vector<std::vector<Wanted>> wanted_by_label(const std::vector<std::size_t>& columns) const {
    std::vector<std::vector<Wanted>> wanted(labels_.size());
    for (std::size_t to = 0; to < columns.size(); ++to) {
      const auto behind =
          std::upper_bound(labels_.begin(), labels_.end(), columns[to],
                           [](std::size_t channel, const Label& of) { return channel < of.first; });
      const auto label = static_cast<std::size_t>(behind - labels_.begin()) - 1;
      wanted[label].push_back({columns[to] - labels_[label].first, to});
    }
    return wanted;
  }

  /// False behind the last step.
  bool read_step(TextLines& lines, std::uint64_t step,
                 const std::vector<std::vector<Wanted>>& wanted, std::vector<double>& values) {
    for (std::size_t i = 0; i < labels_.size(); ++i) {
      const Label& of = labels_[i];
      bool more = lines.next();
      while (more && trimmed(lines.line()).empty()) more = lines.next();
      if (!more && i == 0) return false;
      if (!more) {
        lines.bytes().fail(fmt::format("the file ends within step {}: the label {} is missing",
                                       step + 1, utf8_of(of.label)),
                           mbdyn_hint);
      }
      const std::string_view line = trimmed(lines.line());
      const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
      if (line.substr(0, end) != of.label) {
        lines.fail_at(line,
                      fmt::format("the label {} stands where {} is due, as in the first step",
                                  utf8_of(line.substr(0, end)), utf8_of(of.label)),
                      mbdyn_hint);
      }
      if (wanted[i].empty()) continue;
      numbers_.resize(of.width);
      read_numbers(lines, line.substr(end), of.width, numbers_.data(), mbdyn_hint);
      for (const Wanted& value : wanted[i]) {
        values[value.to] = numbers_[value.value];
        if (const auto trouble = RowBlock::trouble_of_value(values[value.to])) {
          lines.fail_at(line, trouble->message, trouble->hint);
        }
      }
    }
    return true;
  }

  double time_of(MbdynInstants& instants, const TextLines& lines, std::uint64_t step) const {
    if (const std::optional<double> time = instants.next()) return *time;
    lines.fail(1,
               fmt::format("{} tells {} instants, here ends step {}", out_path_, instants.count(),
                           step + 1),
               "let MBDyn write both files once more, or give the time step");
  }

  std::string out_path_;
  bool has_instants_ = false;
  std::vector<Label> labels_;
  std::set<std::string> known_;
  std::vector<double> numbers_;
};

}  // namespace

OpenedSignals open_mbdyn_signals(SignalBytes bytes, const SignalSource& source) {
  return std::make_unique<MbdynReader>(std::move(bytes), source);
}

}  // namespace boxbeam
