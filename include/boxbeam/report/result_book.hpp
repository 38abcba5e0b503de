#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "boxbeam/verification/verify.hpp"

namespace boxbeam {

/// A number that a document holds, and the key by which it is asked for.
struct ResultValue {
  std::string key;   ///< "beam.stations[3.2-].M.max"
  std::string unit;  ///< SI: "N m"; "1" without
  double value = 0.0;
};

/// The numbers of results by their keys, which are paths into the documents in JSON.
class ResultBook {
 public:
  void add(std::vector<ResultValue> values);

  /// By its key, or by what stands behind "beam." or "governing." in it, with blanks or "_" in the
  /// names of criteria; nullptr where there is none.
  const ResultValue* find(const std::string& key) const;

  /// What to write instead of a key that is none.
  std::string hint_for(const std::string& key) const;

 private:
  std::vector<std::string> continuations_of(const std::string& key) const;

  std::vector<ResultValue> values_;
  std::vector<std::string> keys_;  ///< of the values
  std::unordered_map<std::string, std::size_t> places_;
};

/// All numbers of results.json and, beside them, "utilisation" of the check that is used most and
/// the governing check of every criterion, "governing.effective_section.utilisation".
ResultBook results_of(const Project& project, const Verification& verification);
ResultBook results_of(const std::vector<VerifiedBeam>& beams);
/// At least those that are found by some keys, of none of them all: most of the work is for texts
/// and lists that no key leads to.
ResultBook results_of(const std::vector<VerifiedBeam>& beams, const std::vector<std::string>& keys);

}  // namespace boxbeam
