#include "boxbeam/project/signal_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <type_traits>
#include <utility>

#include "boxbeam/core/error.hpp"
#include "file_unit.hpp"
#include "signal_reader.hpp"

namespace boxbeam {
namespace {

/// Where all are wanted: each by its column, as two names may be alike.
ChosenSignals all_signals(const SignalHead& head) {
  ChosenSignals chosen;
  for (std::size_t i = 0; i < head.channels.size(); ++i) {
    chosen.columns.push_back(i);
    chosen.factors.push_back(1.0);
  }
  return chosen;
}

std::string names_of(const SignalHead& head) {
  constexpr std::size_t shown = 12;
  std::string names;
  for (std::size_t i = 0; i < std::min(shown, head.channels.size()); ++i) {
    names += fmt::format("{}\"{}\"", i == 0 ? "" : ", ", head.channels[i].name);
  }
  return head.channels.size() > shown
             ? fmt::format("{} and {} more", names, head.channels.size() - shown)
             : names;
}

/// The factor to SI of a channel's values, or what is wrong.
std::variant<double, ChosenSignals::Trouble> factor_of(const SignalChannel& channel,
                                                       const WantedSignal& wanted) {
  using Trouble = ChosenSignals::Trouble;
  if (!wanted.dimension) return wanted.scale.value_or(1.0);
  const auto unit = parse_file_unit(channel.unit);
  const auto* quantity = std::get_if<ParsedQuantity>(&unit);
  if (quantity == nullptr && wanted.scale) return *wanted.scale;
  const std::string say_unit =
      fmt::format("say what one of it is, for example {}", wanted.dimension->example);
  if (channel.unit.empty()) {
    return Trouble{0, fmt::format("the file gives no unit for \"{}\"", channel.name), say_unit};
  }
  if (quantity == nullptr) {
    return Trouble{0, fmt::format("\"{}\": {}", channel.name, std::get<std::string>(unit)),
                   say_unit};
  }
  if (!is_of(quantity->exponents, *wanted.dimension)) {
    return Trouble{
        0,
        fmt::format("\"{}\" is to be {}, but its unit \"{}\" is that of {}", channel.name,
                    wanted.dimension->name, channel.unit, name_of(quantity->exponents)),
        "choose a channel of that kind"};
  }
  if (wanted.scale) {
    return Trouble{
        0, fmt::format("the file gives the unit of \"{}\", \"{}\"", channel.name, channel.unit),
        "take the unit that is given besides away"};
  }
  return quantity->value;
}

struct OpenedAndChosen {
  OpenedSignals reader;
  ChosenSignals chosen;
};

OpenedAndChosen open_and_choose(const SignalSource& source,
                                const std::vector<WantedSignal>& wanted) {
  OpenedAndChosen opened;
  opened.reader = open_signals(source);
  const SignalHead& head = opened.reader->head();
  opened.chosen = wanted.empty() ? all_signals(head) : choose_signals(head, wanted);
  std::vector<Problem> problems;
  for (const ChosenSignals::Trouble& trouble : opened.chosen.troubles) {
    problems.push_back({head.path, head.names_line, head.names_line > 0 ? 1 : 0, head.names_text,
                        trouble.message, trouble.hint});
  }
  if (!problems.empty()) throw InputError(std::move(problems));
  return opened;
}

}  // namespace

ChosenSignals choose_signals(const SignalHead& head, const std::vector<WantedSignal>& wanted) {
  ChosenSignals chosen;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const std::string& name = wanted[i].name;
    std::vector<std::size_t> found;
    for (std::size_t k = 0; k < head.channels.size(); ++k) {
      if (head.channels[k].name == name) found.push_back(k);
    }
    if (found.size() > 1) {
      chosen.troubles.push_back(
          {i,
           fmt::format("\"{}\" is the name of {} channels, {} and {} of the file", name,
                       found.size(), found[0] + 1, found[1] + 1),
           "give them names of their own"});
      continue;
    }
    if (found.empty()) {
      std::vector<std::string> names;
      for (const SignalChannel& channel : head.channels) names.push_back(channel.name);
      const std::string nearest = nearest_word(name, names);
      chosen.troubles.push_back({i, fmt::format("the file has no channel \"{}\"", name),
                                 nearest.empty() ? fmt::format("it has {}", names_of(head))
                                                 : fmt::format("did you mean \"{}\"?", nearest)});
      continue;
    }
    auto factor = factor_of(head.channels[found.front()], wanted[i]);
    if (auto* trouble = std::get_if<ChosenSignals::Trouble>(&factor)) {
      trouble->wanted = i;
      chosen.troubles.push_back(std::move(*trouble));
      continue;
    }
    chosen.columns.push_back(found.front());
    chosen.factors.push_back(std::get<double>(factor));
  }
  return chosen;
}

SignalHead list_signals(const SignalSource& source) { return open_signals(source)->head(); }

SignalSummary read_signals(const SignalSource& source, const std::vector<WantedSignal>& wanted,
                           const SignalSink& sink) {
  const OpenedAndChosen opened = open_and_choose(source, wanted);
  RowBlock block(opened.chosen.factors, sink);
  opened.reader->read(opened.chosen.columns, block);
  block.finish();
  return block.summary();
}

SignalColumn::SignalColumn(bool single, bool about_first) : about_first_(about_first) {
  if (!single) values_.emplace<std::vector<double>>();
}

void SignalColumn::append(std::span<const double> values) {
  if (values.empty()) return;
  if (about_first_ && size() == 0) offset_ = values.front();
  std::visit(
      [&](auto& own) {
        using Number = typename std::decay_t<decltype(own)>::value_type;
        const std::size_t before = own.size();
        own.resize(before + values.size());
        Number* const to = own.data() + before;
        for (std::size_t i = 0; i < values.size(); ++i)
          to[i] = static_cast<Number>(values[i] - offset_);
      },
      values_);
}

void SignalColumn::reserve(std::size_t rows) {
  std::visit([&](auto& own) { own.reserve(rows); }, values_);
}

std::size_t SignalColumn::size() const {
  return std::visit([](const auto& own) { return own.size(); }, values_);
}

double SignalColumn::operator[](std::size_t row) const {
  return std::visit([&](const auto& own) { return offset_ + static_cast<double>(own[row]); },
                    values_);
}

SignalTable read_signal_file(const SignalSource& source, const std::vector<WantedSignal>& wanted,
                             bool compact) {
  const OpenedAndChosen opened = open_and_choose(source, wanted);
  const SignalHead& head = opened.reader->head();
  SignalTable table;
  table.path = head.path;
  table.format = name_of(head.format);
  for (const std::size_t column : opened.chosen.columns) {
    table.names.push_back(head.channels[column].name);
    table.units.push_back(head.channels[column].unit);
    const bool single = head.channels[column].single_precision;
    table.columns.emplace_back(single || compact, compact && !single);
    // The head's count has been compared with the size of the file.
    if (head.rows) table.columns.back().reserve(static_cast<std::size_t>(*head.rows));
  }
  const SignalSink keep = [&](const SignalRows& rows) {
    if (!head.time_step) {
      table.time.instants.insert(table.time.instants.end(), rows.time.begin(), rows.time.end());
    }
    for (std::size_t k = 0; k < rows.values.size(); ++k) table.columns[k].append(rows.values[k]);
  };
  RowBlock block(opened.chosen.factors, keep);
  opened.reader->read(opened.chosen.columns, block);
  block.finish();
  table.time.count = static_cast<std::size_t>(block.summary().rows);
  table.time.start = block.summary().first_time;
  table.time.step = head.time_step.value_or(0.0);
  return table;
}

}  // namespace boxbeam
