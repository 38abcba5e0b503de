#pragma once

#include <Eigen/Core>
#include <functional>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "boxbeam/report/result_book.hpp"
#include "json_number.hpp"

/// The fields of a document, said once: from one list of calls the document is written, its schema
/// described, and every number found by its key.
namespace boxbeam::report {

/// A field's name, and in a few words what it is.
struct Field {
  std::string_view name;
  std::string_view meaning;

  Field(const char* key, std::string_view what = {}) : name(key), meaning(what) {}
  Field(std::string_view key, std::string_view what = {}) : name(key), meaning(what) {}
  Field(const std::string& key, std::string_view what = {}) : name(key), meaning(what) {}
};

/// Which numbers of an object are asked for, by keys below it: what no key leads to is left out.
class WantedKeys {
 public:
  WantedKeys() = default;  ///< all
  explicit WantedKeys(std::vector<std::string_view> keys) : keys_(std::move(keys)), all_(false) {}

  bool all() const { return all_; }
  /// Whether a key leads to this field, or below it.
  bool lead_to(std::string_view name) const;
  /// Those below an object, without its name; of the entries of a list all.
  WantedKeys below(std::string_view name) const;

 private:
  std::vector<std::string_view> keys_;
  bool all_ = true;
};

/// Names of the numbers of a vector.
using FieldNames = std::initializer_list<const char*>;

/// The fields of one object. Where the schema is described there are no values: a value may be
/// given as a function, which is then not called, and what is filled for a list's entries is filled
/// once with a default one.
class Fields {
 public:
  /// Takes fields into a document, and their numbers into a list where one is given.
  explicit Fields(Json& document, std::vector<ResultValue>* values = nullptr,
                  WantedKeys wanted = {})
      : out_(&document), values_(values), wanted_(std::move(wanted)) {}
  /// Describes them instead.
  static Fields describing(Json& schema);

  bool is_describing() const { return schema_ != nullptr; }
  /// The next field may be missing.
  Fields& optional() {
    optional_ = true;
    return *this;
  }

  /// Of optional fields all of exactly one group are there.
  void either(std::initializer_list<FieldNames> groups);

  /// A finite number in an SI unit, "1" where it has none; OutputError where it is not finite.
  template <class Value>
  void number(const Field& field, std::string_view unit, const Value& value) {
    if (is_describing()) return describe_number(field, unit, false);
    if (leaves_out(field)) return;
    put_number(field, unit, called(value));
  }
  void number_or_null(const Field& field, std::string_view unit, std::optional<double> value);
  /// One whose unit another field says; `units`: by that field's words, where it is none itself.
  void number_in(const Field& field, std::string_view unit, const char* said_by, double value,
                 const Json& units = {});
  /// A count; of a unit where it can be asked for.
  template <class Value>
  void whole(const Field& field, const Value& value, std::string_view unit = {}) {
    if (is_describing()) return describe_whole(field, unit);
    put_whole(field, static_cast<long long>(called(value)), unit);
  }
  template <class Value>
  void text(const Field& field, const Value& value) {
    if (is_describing()) return describe(field, {{"type", "string"}});
    if (leaves_out(field)) return;
    put(field, Json(called(value)));
  }
  void text_or_null(const Field& field, const std::optional<std::string>& value);
  /// One of a few words; null where there is none.
  void word(const Field& field, std::string_view value, FieldNames words);
  void word_or_null(const Field& field, std::optional<std::string_view> value, FieldNames words);
  /// Always the same.
  void constant(const Field& field, const char* value);
  void boolean(const Field& field, bool value);
  template <class Value>
  void texts(const Field& field, const Value& values) {
    if (is_describing())
      return describe(field, {{"type", "array"}, {"items", {{"type", "string"}}}});
    if (leaves_out(field)) return;
    put(field, Json(called(values)));
  }
  /// Numbers of one unit; `names` where each is asked for by a name and not by its place.
  void numbers(const Field& field, std::string_view unit, std::span<const double> values,
               FieldNames names = {}, std::size_t fewest = 0);

  void wholes(const Field& field, std::initializer_list<int> values);
  void vector(const Field& field, std::string_view unit, const Eigen::Vector3d& value) {
    numbers(field, unit, std::span(value.data(), 3), {"x", "y", "z"});
  }
  /// A matrix by its rows.
  void rows(const Field& field, std::string_view unit, const Eigen::Matrix3d& value);

  /// An object below this one.
  template <class Fill>
  void object(const Field& field, const Fill& fill) {
    below(field, false, [&](Fields& fields) { fill(fields); });
  }
  /// The same of something that may not be there: null.
  template <class T, class Fill>
  void object_or_null(const Field& field, const T* of, const Fill& fill) {
    if (is_describing()) {
      const T none{};
      return below(field, true, [&](Fields& fields) { fill(fields, none); });
    }
    if (of == nullptr)
      put(field, Json());
    else
      below(field, true, [&](Fields& fields) { fill(fields, *of); });
  }
  template <class T, class Fill>
  void object_or_null(const Field& field, const std::optional<T>& of, const Fill& fill) {
    object_or_null(field, of ? &*of : nullptr, fill);
  }
  /// A list of objects, each asked for by the name that `key` builds of its fields, "{s}{side}",
  /// and by its place from 0.
  template <class Items, class Fill>
  void list(const Field& field, const char* key, const Items& items, const Fill& fill) {
    using T = std::remove_cvref_t<decltype(*std::begin(called(items)))>;
    if (is_describing()) {
      const T none{};
      return describe_list(field, key, [&](Fields& fields) { fill(fields, none); });
    }
    if (leaves_out(field)) return;
    Json& all = put(field, Json::array());
    std::vector<std::string> names;
    for (const T& item : called(items)) {
      entry(field, key, all, names, [&](Fields& fields) { fill(fields, item); });
    }
  }
  /// Objects by names of the user's own.
  template <class Items, class Name, class Fill>
  void named(const Field& field, const Items& items, const Name& name_of, const Fill& fill) {
    using T = std::remove_cvref_t<decltype(*std::begin(items))>;
    if (is_describing()) {
      const T none{};
      return describe_named(field, [&](Fields& fields) { fill(fields, none); });
    }
    if (leaves_out(field)) return;
    Json& all = put(field, Json::object());
    for (const T& item : items)
      member(field, name_of(item), all, [&](Fields& fields) { fill(fields, item); });
  }
  /// Numbers by names of the user's own, each of its own unit.
  void named_numbers(const Field& field, const std::vector<std::pair<std::string, double>>& values);
  /// Words by names of the user's own.
  void named_words(const Field& field,
                   const std::vector<std::pair<std::string, std::string>>& values,
                   FieldNames words);

 private:
  using Fill = std::function<void(Fields&)>;
  Fields() = default;

  template <class Value>
  static decltype(auto) called(const Value& value) {
    if constexpr (std::is_invocable_v<const Value&>)
      return value();
    else
      return (value);
  }

  /// Whether nobody asks for a field.
  bool leaves_out(const Field& field) {
    if (wanted_.lead_to(field.name)) return false;
    optional_ = false;
    return true;
  }
  Json& put(const Field& field, Json value);
  void put_number(const Field& field, std::string_view unit, double value);
  void put_whole(const Field& field, long long value, std::string_view unit);
  void describe(const Field& field, Json schema);
  void describe_number(const Field& field, std::string_view unit, bool may_be_null);
  void describe_whole(const Field& field, std::string_view unit);
  void describe_list(const Field& field, const char* key, const Fill& fill);
  void describe_named(const Field& field, const Fill& fill);
  void below(const Field& field, bool may_be_null, const Fill& fill);
  void entry(const Field& field, const char* key, Json& all, std::vector<std::string>& names,
             const Fill& fill);
  void member(const Field& field, const std::string& name, Json& all, const Fill& fill);
  void take(const std::string& prefix, const std::vector<ResultValue>& values);

  Json* out_ = nullptr;
  std::vector<ResultValue>* values_ = nullptr;
  Json* schema_ = nullptr;
  bool optional_ = false;
  WantedKeys wanted_;
};

/// The numbers of a document whose fields `put` says, `prefix` before their keys; of some keys at
/// least those.
template <class Put>
std::vector<ResultValue> values_of(const std::string& prefix, const Put& put,
                                   WantedKeys wanted = {}) {
  Json document = Json::object();
  std::vector<ResultValue> values;
  Fields fields(document, &values, std::move(wanted));
  put(fields);
  for (ResultValue& value : values) value.key = prefix + value.key;
  return values;
}

}  // namespace boxbeam::report
