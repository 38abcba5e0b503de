#include "boxbeam/mechanism/common/sticking_spans.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace boxbeam {

std::vector<StickingContact> sticking_contacts(const std::vector<FirstSlip>& first, double begin,
                                               const std::vector<SlipChange>& changes) {
  std::vector<StickingContact> contacts;
  for (const FirstSlip& of : first) {
    StickingContact& contact = contacts.emplace_back();
    contact.joint = of.joint;
    if (of.slip == Slip::none) contact.spans.push_back({begin, {}});
    for (const SlipChange& change : changes) {
      if (change.joint != of.joint) continue;
      if (change.from == Slip::none && !contact.spans.empty())
        contact.spans.back().until = change.time;
      if (change.to == Slip::none) contact.spans.push_back({change.time, {}});
    }
  }
  return contacts;
}

std::vector<FirstSlip> first_slips_of(const std::vector<Friction>& laws,
                                      const std::vector<std::string>& names,
                                      const std::vector<Slip>& slips) {
  std::vector<FirstSlip> first;
  for (std::size_t j = 0; j < slips.size(); ++j)
    if (can_stick(laws[j])) first.push_back({names[j], slips[j]});
  return first;
}

std::string to_text(const StickingContact& contact) {
  if (contact.spans.empty()) return fmt::format("{} never sticks", contact.joint);
  constexpr std::size_t most_named = 20;
  std::vector<std::string> spans;
  for (const StickingSpan& span : contact.spans) {
    if (spans.size() == most_named) {
      spans.push_back("...");
      break;
    }
    spans.push_back(span.until ? fmt::format("{:.6g} s to {:.6g} s", span.from, *span.until)
                               : fmt::format("from {:.6g} s on", span.from));
  }
  const std::size_t times = contact.spans.size();
  return fmt::format("{} sticks {}: {}", contact.joint,
                     times == 1 ? "once" : fmt::format("{} times", times), fmt::join(spans, ", "));
}

}  // namespace boxbeam
