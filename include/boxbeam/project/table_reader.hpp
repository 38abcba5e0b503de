#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "boxbeam/project/case_document.hpp"
#include "boxbeam/project/key_record.hpp"
#include "boxbeam/project/problem_list.hpp"
#include "boxbeam/project/quantity_text.hpp"

namespace boxbeam {

/// Reads one table key by key. A missing or wrong value is noted as a problem and replaced by a
/// harmless one, so that reading goes on; keys never asked for are unknown keys.
class TableReader {
 public:
  TableReader(ProblemList& problems, const Node& table, std::string name, std::string pattern = {});

  /// Whether a key is there; it counts as asked for, and is to be read where it is.
  bool has(const Key& key);
  /// The same of a key that belongs to another kind of case, and is refused with a reason.
  bool has_misplaced(std::string_view key);
  /// The same of a key that is read only where it is there: what it would be.
  bool has_choice(const Key& key, const std::vector<std::string>& words);
  bool has_quantity(const Key& key, const WantedDimension& wanted);
  bool has_number(const Key& key);
  /// Whether exactly one of several ways to say something is written: a key of it at least is
  /// there. All keys count as asked for.
  bool says_one_of(const KeyWays& ways);
  /// Says that a key is wanted where another one is a word, or has it among its words.
  void wants_with(const Key& key, std::string_view other, std::string_view word);
  /// The same of a key that has no place here: it stays unknown.
  bool is_there(std::string_view key) const { return peek(key) != nullptr; }
  /// What stands there, nullptr where nothing does; it stays unknown.
  const Node* peek(std::string_view key) const { return table_->find(key); }
  /// Place of a key's value, or of the table where the key is missing.
  Place place_of(std::string_view key) const;
  Place place() const { return table_->place; }
  const std::string& name() const { return name_; }

  /// Value in SI units. Without `fallback` the key is required.
  double quantity(const Key& key, const WantedDimension& wanted,
                  std::optional<double> fallback = {});
  /// A quantity that must be above zero, or not below it.
  double positive(const Key& key, const WantedDimension& wanted,
                  std::optional<double> fallback = {});
  double not_negative(const Key& key, const WantedDimension& wanted,
                      std::optional<double> fallback = {});
  /// Two quantities, ["1 m", "2 m"].
  Eigen::Vector2d pair(const Key& key, const WantedDimension& wanted,
                       std::optional<Eigen::Vector2d> fallback = {});
  /// Any number of pairs, [["1 m", "2 m"], ...], and of lists of them.
  std::vector<Eigen::Vector2d> pairs(const Key& key, const WantedDimension& wanted);
  std::vector<std::vector<Eigen::Vector2d>> lists_of_pairs(const Key& key,
                                                           const WantedDimension& wanted);
  /// Three quantities, ["1 m", "2 m", "0 m"].
  Eigen::Vector3d triple(const Key& key, const WantedDimension& wanted,
                         std::optional<Eigen::Vector3d> fallback = {});
  /// A symmetric matrix: its diagonal, or three rows.
  Eigen::Matrix3d symmetric(const Key& key, const WantedDimension& wanted);
  /// A direction, "x", "-y" or three numbers, as a unit vector.
  Eigen::Vector3d direction(const Key& key, std::optional<Eigen::Vector3d> fallback = {});
  /// So many directions.
  std::vector<Eigen::Vector3d> directions(const Key& key, std::size_t count);
  /// A list of turns one after the other, [["x", "10 deg"], ...], or one of them by itself: the
  /// axes of each and the angle [rad]. Empty where the key is missing.
  std::vector<std::pair<Eigen::Vector3d, double>> turns(const Key& key);
  /// A quantity of either sign, but not zero.
  double not_zero(const Key& key, const WantedDimension& wanted);
  std::vector<double> quantities(const Key& key, const WantedDimension& wanted);
  /// The same, each of a dimension of its own; not more than there are dimensions.
  std::vector<double> quantities(const Key& key, std::span<const WantedDimension> each);
  /// Not below zero, one for each of `count` directions: a single value is that of all. The word
  /// `infinite`, where not empty, stands for an infinite one.
  std::vector<double> per_direction(const Key& key, std::size_t count,
                                    const WantedDimension& wanted, std::string_view infinite = {},
                                    std::optional<double> fallback = {});
  /// Whether the value of a key is a list, or a table.
  bool is_list(std::string_view key) const;
  bool is_table(std::string_view key) const;

  /// A bare, finite number above zero and of a size that can be meant.
  double number(const Key& key, std::optional<double> fallback = {}, const char* example = "2.0");
  /// A bare, finite number of either sign, or zero.
  double any_number(const Key& key, std::optional<double> fallback = {});
  int whole_number(const Key& key, std::optional<int> fallback = {},
                   const std::vector<std::string>& known = {});
  bool boolean(const Key& key, bool fallback);
  /// Without `fallback` the text must not be empty: "" means that a problem has been noted.
  std::string text(const Key& key, std::optional<std::string> fallback = {});
  std::vector<std::string> texts(const Key& key, bool required);
  /// One of a few words; an index into them.
  std::size_t choice(const Key& key, const std::vector<std::string>& words,
                     std::optional<std::size_t> fallback = {});

  /// The same of a word that decides which other keys the table has.
  std::size_t kind(const Key& key, const std::vector<std::string>& words);

  /// A table below this one; an empty one where it is missing (a problem if required).
  TableReader table(const Key& key, bool required = true);
  /// The tables of an array of tables, [[key]].
  std::vector<TableReader> tables(const Key& key, bool required = false);
  /// How many tables stand under a key that may be one, [key], or several, [[key]].
  std::size_t count_of(std::string_view key) const;
  /// One of them, by its index; the only one where it is one.
  TableReader one_of_tables(const Key& key, std::size_t index);
  /// Notes a key whose tables are described where the case itself has them.
  void accept_as_in_case(const Key& key);
  /// All members as named tables, for tables whose keys are the user's own names.
  std::vector<std::pair<std::string, TableReader>> named_tables(std::string_view meaning = {});
  /// The members as they stand, for keys of the user's own names whose values are no tables.
  const std::vector<Node::Member>& members(std::string_view meaning = {});
  /// Takes every key as known.
  void accept_all();

  /// Two quantities in a node of the user's own naming, or three.
  Eigen::Vector2d pair_in(const Node& node, const std::string& what, const WantedDimension& wanted);
  Eigen::Vector3d triple_in(const Node& node, const std::string& what,
                            const WantedDimension& wanted);

  void problem(std::string_view key, std::string message, std::string hint = {});
  ProblemList& problems() { return *problems_; }

  /// Notes every key that was never asked for, with the nearest one that is known here.
  void finish();

 private:
  /// What a recorder learns of a key besides its shape.
  struct Asked {
    bool required = false;
    const WantedDimension* wanted = nullptr;
    std::string fallback = {};
    std::vector<std::string> words = {};
  };
  bool recording() const { return problems_->recorder != nullptr && !absent_; }
  void note(const Key& key, KeyShape shape, const Asked& asked);
  std::string pattern_below(std::string_view key) const;

  const Node* take(std::string_view key, bool required, std::string_view example);
  const Node* take_or_say(std::string_view key, bool required, std::string hint);
  std::string name_below(std::string_view key) const;
  double bare_number(std::string_view key, std::optional<double> fallback, bool above_zero,
                     const char* example);
  bool is_too_long(const std::string& name, const Place& place, std::size_t count);
  const std::vector<Node>* list_of(std::string_view key, const char* example);
  double quantity_in(const Node& node, const std::string& what, const WantedDimension& wanted);
  Eigen::Vector3d direction_in(const Node& node, const std::string& what);

  ProblemList* problems_;
  const Node* table_;
  /// The table is missing or no table, which has been said: nothing more is said of its keys.
  bool absent_ = false;
  std::string name_;  ///< "bodies.beam"; "" for the whole file
  /// "bodies.*": what the recorder calls it.
  std::string pattern_;
  bool own_names_ = false;  ///< its keys are names of the user's own
  std::vector<std::string> asked_;
};

}  // namespace boxbeam
