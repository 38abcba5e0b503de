#include "boxbeam/project/problem_list.hpp"

#include <algorithm>
#include <tuple>

namespace boxbeam {

void ProblemList::add(const Place& place, std::string message, std::string hint) {
  problems_.push_back(document_->problem_at(place, std::move(message), std::move(hint)));
}

void ProblemList::add_missing(const Node& table, std::string_view key, std::string message,
                              std::string hint) {
  missing_.push_back({&table, std::string(key), problems_.size()});
  add(table.place, std::move(message), std::move(hint));
}

void ProblemList::drop_missing(const Node& table, std::string_view key) {
  const auto found = std::find_if(missing_.begin(), missing_.end(), [&](const Missing& of) {
    return of.table == &table && of.key == key;
  });
  if (found == missing_.end()) return;
  const std::size_t at = found->problem;
  problems_.erase(problems_.begin() + static_cast<std::ptrdiff_t>(at));
  missing_.erase(found);
  for (Missing& other : missing_) {
    if (other.problem > at) --other.problem;
  }
}

void ProblemList::raise() const {
  if (problems_.empty()) return;
  const std::vector<InputFile>& files = document_->files;
  const auto rank_of = [&](const Problem& problem) {
    const auto found = std::find_if(files.begin(), files.end(), [&](const InputFile& file) {
      return file.resolved == problem.file;
    });
    return found == files.end() ? 0 : 1 + (found - files.begin());
  };
  std::vector<Problem> sorted = problems_;
  std::stable_sort(sorted.begin(), sorted.end(), [&](const Problem& a, const Problem& b) {
    return std::tuple(rank_of(a), a.line, a.column) < std::tuple(rank_of(b), b.line, b.column);
  });
  // Two keys may lead to the same mistake, a table that both name.
  const auto same = [](const Problem& a, const Problem& b) {
    return std::tie(a.file, a.line, a.column, a.message) ==
           std::tie(b.file, b.line, b.column, b.message);
  };
  sorted.erase(std::unique(sorted.begin(), sorted.end(), same), sorted.end());
  throw InputError(std::move(sorted));
}

}  // namespace boxbeam
