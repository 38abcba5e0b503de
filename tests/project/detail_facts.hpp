#pragma once

#include <string>
#include <vector>

#include "boxbeam/project/detail_catalogue.hpp"

/// What the tables of details say of facts.
namespace detail_facts {

using namespace boxbeam;

using Words = std::vector<std::string>;

inline DetailAssessment about(const Facts& facts, StressKind kind = StressKind::direct) {
  return assess(detail_rows(), kind, facts);
}

inline std::string governing(Facts facts, StressKind kind = StressKind::direct) {
  facts.emplace("stress", "nominal");
  const auto candidates = about(facts, kind).candidates;
  if (candidates.empty()) return "none";
  return candidates.front().id + ": " + category_name_of(candidates.front());
}

inline Facts with(Facts facts, const Facts& more) {
  for (const auto& [name, value] : more) facts.insert_or_assign(name, value);
  return facts;
}

}  // namespace detail_facts
