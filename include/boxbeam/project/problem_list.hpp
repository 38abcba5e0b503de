#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "boxbeam/project/case_document.hpp"

namespace boxbeam {

class KeyRecorder;

/// Collects the problems of a document, so that all are reported at once.
class ProblemList {
 public:
  explicit ProblemList(const CaseDocument& document) : document_(&document) {}

  void add(const Place& place, std::string message, std::string hint = {});
  /// Notes that a table has not a key which it needs.
  void add_missing(const Node& table, std::string_view key, std::string message, std::string hint);
  /// The same is said otherwise, as a wrong spelling: no longer notes it, where it was noted.
  void drop_missing(const Node& table, std::string_view key);
  bool empty() const { return problems_.empty(); }
  std::size_t size() const { return problems_.size(); }
  /// Throws InputError with all problems, where there are any: those of the case in its order, then
  /// those of the files that it names.
  void raise() const;

  /// Where not nullptr: notes what the readers ask for.
  KeyRecorder* recorder = nullptr;

 private:
  const CaseDocument* document_;
  std::vector<Problem> problems_;
  /// Which of them say that a key is missing: of what table, and which.
  struct Missing {
    const Node* table;
    std::string key;
    std::size_t problem;
  };
  std::vector<Missing> missing_;
};

}  // namespace boxbeam
