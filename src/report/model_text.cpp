#include "model_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "boxbeam/verification/model_ladder.hpp"
#include "text_layout.hpp"

namespace boxbeam {
namespace {

std::string percent(double of) { return fmt::format("{:.2g} %", 100.0 * of); }

std::string list_of(const std::vector<double>& frequencies) {
  std::string text;
  for (const double frequency : frequencies) {
    text += fmt::format("{}{:.4g}", text.empty() ? "" : ", ", frequency);
  }
  return text;
}

}  // namespace

std::string model_section(const ModelChoice& choice) {
  std::string out = layout::heading("Model");
  out += layout::paragraph(choice.reason + ".");
  if (!choice.frequencies.empty()) {
    out += fmt::format("\n  natural frequencies [Hz]  {}\n", list_of(choice.frequencies));
  }
  if (!choice.harmonics.empty()) {
    out += "  loads vibrate with [Hz]   ";
    for (const LoadHarmonic& harmonic : choice.harmonics) {
      out += fmt::format("{}{:.4g} ({:.0f} %)", &harmonic == &choice.harmonics.front() ? "" : ", ",
                         harmonic.frequency, 100.0 * harmonic.share);
    }
    out += "\n";
  }
  if (choice.weighed.empty()) return out + "\n";
  // Of a long ladder the top is what decides.
  constexpr std::size_t shown = 12;
  const std::size_t first = choice.weighed.size() - std::min(shown, choice.weighed.size());
  out += "\n";
  layout::Table table({"model weighed", "estimated", "found", "the estimate's parts"});
  for (std::size_t i = first; i < choice.weighed.size(); ++i) {
    const ModelEstimate& of = choice.weighed[i];
    table.row(
        {describe(of.model), percent(of.error), of.found ? percent(*of.found) : "-", of.basis});
  }
  out += table.text();
  if (first > 0) {
    out += fmt::format(
        "  {} cheaper models, all estimated to miss the tolerance, stand in "
        "results.json\n",
        first);
  }
  return out + "\n";
}

}  // namespace boxbeam
