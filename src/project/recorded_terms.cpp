#include "recorded_terms.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace boxbeam::readers {
namespace {

/// Which of the six leave the plane of x and z.
constexpr bool leaves_plane(std::size_t k) { return k == 1 || k == 3 || k == 5; }

}  // namespace

const WantedDimension& dimension_of(std::size_t k) {
  return k < 3 ? wanted::force : wanted::moment;
}

double read_factor(TableReader& table) {
  const double factor =
      table.any_number({"factor", "on all columns; -1 turns what acts on another body"}, 1.0);
  if (factor == 0.0)
    table.problem("factor", "zero times its columns is no load", "remove the load instead");
  return factor;
}

std::array<bool, 6> read_six(TableReader& columns, const SixColumns& of, std::size_t file,
                             double factor, std::size_t place, ChannelFiles& files,
                             RecordedTerms& into) {
  std::array<bool, 6> given{};
  for (std::size_t k = 0; k < 6; ++k) {
    const Key key{of.words[k], of.meanings[k]};
    if (!columns.has(key)) continue;
    Term term{files.channel_of(columns, key, file, dimension_of(k))};
    term.place = place;
    (k < 3 ? term.force : term.moment)[static_cast<Eigen::Index>(k % 3)] = factor;
    term.what = factor == 1.0 ? of.words[k] : fmt::format("{:g} {}", factor, of.words[k]);
    term.unit = k < 3 ? "kN" : "kN m";
    into.in_space = into.in_space || leaves_plane(k);
    into.terms.push_back(std::move(term));
    given[k] = true;
  }
  return given;
}

void add_column(const ChannelFiles& files, const recorded::Channels& channels, std::size_t channel,
                double shown, const std::string& unit, recorded::ChannelSource& source) {
  const std::vector<double>& values = channels.values[channel];
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  source.column = files.column(channel);
  source.file = files.path(channel);
  source.low = *low * shown;
  source.high = *high * shown;
  source.unit = unit;
}

}  // namespace boxbeam::readers
