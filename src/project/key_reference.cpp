#include "boxbeam/project/key_reference.hpp"

#include <algorithm>
#include <map>

#include "boxbeam/project/project.hpp"
#include "template_data.hpp"

namespace boxbeam {
namespace {

/// The visits of one table, and what its choices say in them.
struct Visits {
  std::vector<const TableVisit*> of;
  std::map<std::string, std::vector<std::string>> words;  ///< that stood, by choice
};

void add_once(std::vector<std::string>& words, const std::string& word) {
  if (std::find(words.begin(), words.end(), word) == words.end()) words.push_back(word);
}

const std::string* word_in(const TableVisit& visit, const std::string& choice) {
  const auto found = std::find_if(visit.choices.begin(), visit.choices.end(),
                                  [&](const auto& of) { return of.first == choice; });
  return found == visit.choices.end() ? nullptr : &found->second;
}

/// Whether two keys are one: alike in all that a user writes.
bool same(const AskedKey& a, const AskedKey& b) {
  return a.name == b.name && a.shape == b.shape && a.dimension == b.dimension &&
         a.words == b.words && a.meaning == b.meaning;
}

/// Under which words of the table's choices something is known, where not under all.
template <class Knows>
std::vector<KeyDescription::Only> only_of(const Visits& visits, const Knows& knows) {
  std::vector<KeyDescription::Only> only;
  for (const auto& [choice, words] : visits.words) {
    KeyDescription::Only here{choice, {}};
    bool without = false;  // known where the choice is not even asked for
    for (const TableVisit* visit : visits.of) {
      if (!knows(*visit, choice)) continue;
      if (const std::string* word = word_in(*visit, choice)) {
        add_once(here.words, *word);
      } else {
        without = true;
      }
    }
    if (!without && !here.words.empty() && here.words.size() < words.size())
      only.push_back(std::move(here));
  }
  return only;
}

std::vector<KeyDescription::Only> only_of(const AskedKey& key, const Visits& visits) {
  return only_of(visits, [&](const TableVisit& visit, const std::string& choice) {
    const AskedKey* const found = choice == key.name ? nullptr : visit.find(key.name);
    return found != nullptr && (found->shape == KeyShape::unknown || same(*found, key));
  });
}

bool has_ways(const TableVisit& visit, const KeyWays& ways) {
  return std::find(visit.ways.begin(), visit.ways.end(), ways) != visit.ways.end();
}

/// Whether a table is of the kinds in which a key is known.
bool holds(const std::vector<KeyDescription::Only>& only, const TableVisit& visit) {
  return std::all_of(only.begin(), only.end(), [&](const KeyDescription::Only& each) {
    const std::string* const word = word_in(visit, each.key);
    return word != nullptr &&
           std::find(each.words.begin(), each.words.end(), *word) != each.words.end();
  });
}

TableDescription described(const std::string& pattern, const Visits& visits) {
  TableDescription table{pattern, {}, {}};
  for (const TableVisit* visit : visits.of) {
    for (const AskedKey& key : visit->keys) {
      // Of a key that was only looked for another visit knows more.
      const auto is_described = [](const AskedKey& of) {
        return of.shape != KeyShape::unknown && !of.meaning.empty();
      };
      const bool known_elsewhere =
          !is_described(key) &&
          std::any_of(visits.of.begin(), visits.of.end(), [&](const TableVisit* other) {
            const AskedKey* const of = other->find(key.name);
            return of != nullptr && is_described(*of);
          });
      const auto is_it = [&](const KeyDescription& of) { return same(of.key, key); };
      const auto at = std::find_if(table.keys.begin(), table.keys.end(), is_it);
      if (known_elsewhere) continue;
      if (at != table.keys.end()) {
        at->key.required = at->key.required && key.required;
        // What holds instead follows from something else.
        if (at->key.fallback != key.fallback) at->key.fallback.clear();
        for (const auto& with : key.required_with) {
          std::vector<std::pair<std::string, std::string>>& known = at->key.required_with;
          if (std::find(known.begin(), known.end(), with) == known.end()) known.push_back(with);
        }
      } else {
        // Beside what else goes by its name.
        const auto last = std::find_if(table.keys.rbegin(), table.keys.rend(),
                                       [&](const auto& of) { return of.key.name == key.name; });
        table.keys.insert(last == table.keys.rend() ? table.keys.end() : last.base(),
                          {key, only_of(key, visits)});
      }
    }
    for (const KeyWays& ways : visit->ways) {
      const bool known = std::any_of(table.ways.begin(), table.ways.end(),
                                     [&](const WaysDescription& of) { return of.ways == ways; });
      if (known) continue;
      table.ways.push_back({ways, only_of(visits, [&](const TableVisit& other, const std::string&) {
                              return has_ways(other, ways);
                            })});
    }
  }
  // Required only where no visit of its kinds did without it, and nothing may stand instead.
  for (KeyDescription& of : table.keys) {
    for (const WaysDescription& several : table.ways) {
      for (const KeyWay& way : several.ways) {
        if (std::find(way.keys.begin(), way.keys.end(), of.key.name) != way.keys.end())
          of.key.required = false;
      }
    }
    for (const TableVisit* visit : visits.of) {
      const AskedKey* const found = visit->find(of.key.name);
      const bool wanted = found != nullptr && found->required;
      if (!wanted && holds(of.only, *visit)) of.key.required = false;
    }
  }
  return table;
}

}  // namespace

const std::vector<std::string>& case_kinds() {
  static const std::vector<std::string> kinds(kind_words.begin(), kind_words.end());
  return kinds;
}

namespace {

std::vector<TableDescription> described_tables(const std::string& case_kind) {
  KeyRecorder recorder;
  for (const auto& example : template_data::examples) {
    if (case_kind == example.kind) record_keys(example.name, example.text, recorder);
  }
  std::vector<std::string> order;
  std::map<std::string, Visits> tables;
  for (const TableVisit& visit : recorder.visits()) {
    Visits& visits = tables[visit.pattern];
    if (visits.of.empty()) order.push_back(visit.pattern);
    visits.of.push_back(&visit);
    for (const auto& [choice, word] : visit.choices) add_once(visits.words[choice], word);
  }
  std::vector<TableDescription> reference;
  for (const std::string& pattern : order) reference.push_back(described(pattern, tables[pattern]));
  return reference;
}

/// What a table of the same name in another kind of case knows of a key that is only looked for in
/// the examples of this one.
const AskedKey* known_elsewhere(const std::vector<std::vector<TableDescription>>& all,
                                const std::string& pattern, const std::string& key) {
  for (const std::vector<TableDescription>& reference : all) {
    for (const TableDescription& table : reference) {
      if (table.pattern != pattern) continue;
      for (const KeyDescription& of : table.keys) {
        if (of.key.name == key && of.key.shape != KeyShape::unknown) return &of.key;
      }
    }
  }
  return nullptr;
}

std::map<std::string, std::vector<TableDescription>> all_references() {
  std::vector<std::vector<TableDescription>> all;
  for (const std::string& kind : case_kinds()) all.push_back(described_tables(kind));
  std::map<std::string, std::vector<TableDescription>> references;
  for (std::size_t i = 0; i < all.size(); ++i) {
    std::vector<TableDescription> own = all[i];
    for (TableDescription& table : own) {
      for (KeyDescription& of : table.keys) {
        if (of.key.shape != KeyShape::unknown) continue;
        const AskedKey* const known = known_elsewhere(all, table.pattern, of.key.name);
        if (known == nullptr) continue;
        const auto required_with = of.key.required_with;
        of.key = *known;
        of.key.required = false;
        of.key.required_with = required_with;
      }
    }
    references.emplace(case_kinds()[i], std::move(own));
  }
  return references;
}

}  // namespace

const std::vector<TableDescription>& key_reference_of(const std::string& case_kind) {
  static const auto references = all_references();
  return references.at(case_kind);
}

}  // namespace boxbeam
