#pragma once

#include <fmt/format.h>

#include <functional>
#include <random>
#include <string>
#include <vector>

#include "boxbeam/project/case_document.hpp"
#include "boxbeam/report/json.hpp"
#include "boxbeam/study/written_quantity.hpp"
#include "boxbeam/verification/verify.hpp"

/// Designs at random: a case with other numbers.
namespace test {

/// A number that stands in a case, under its key.
struct WrittenNumber {
  std::string key;
  boxbeam::WrittenQuantity value;
};

inline void add_numbers(const boxbeam::Node& node, const std::string& key,
                        std::vector<WrittenNumber>& numbers) {
  const std::string below = key.empty() ? "" : key + ".";
  for (const boxbeam::Node::Member& member : node.members)
    add_numbers(member.value, below + member.key, numbers);
  for (std::size_t i = 0; i < node.items.size(); ++i)
    add_numbers(node.items[i], below + std::to_string(i), numbers);
  if (const auto value = boxbeam::quantity_written_in(node); value && value->value != 0.0)
    numbers.push_back({key, *value});
}

/// All of a case.
inline std::vector<WrittenNumber> numbers_in(const std::string& path) {
  std::vector<WrittenNumber> numbers;
  add_numbers(boxbeam::read_document(path, {}).root, "", numbers);
  return numbers;
}

/// It by another one, now and then far from what can be.
inline std::string changed(const WrittenNumber& of, std::mt19937& random) {
  const double factor = random() % 8 == 0 ? -1.0 : 0.8 + 0.05 * static_cast<double>(random() % 9);
  return fmt::format(
      "{}={}", of.key,
      boxbeam::to_text(boxbeam::WrittenQuantity{factor * of.value.value, of.value.unit}));
}

/// Every digit of the results, or what is wrong.
inline std::string outcome_of(const std::function<std::vector<boxbeam::VerifiedBeam>()>& verified) {
  try {
    return boxbeam::results_json(verified());
  } catch (const std::exception& error) {
    return error.what();
  }
}

inline bool is_result(const std::string& outcome) { return outcome.starts_with("{"); }

}  // namespace test
