#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <thread>

#include "arrays.hpp"
#include "boxbeam/core/error.hpp"
#include "boxbeam/project/case_document.hpp"
#include "boxbeam/project/case_source.hpp"
#include "boxbeam/project/catalogue.hpp"
#include "boxbeam/project/named_section.hpp"
#include "boxbeam/project/project.hpp"
#include "boxbeam/report/json.hpp"
#include "boxbeam/report/result_book.hpp"
#include "boxbeam/report/section_text.hpp"
#include "boxbeam/study/case_keys.hpp"
#include "boxbeam/verification/front_end.hpp"
#include "boxbeam/verification/section_summary.hpp"
#include "boxbeam/verification/verify.hpp"
#include "version.hpp"

/// The compiled module of the Python package: documents as JSON, columns as arrays. What Python
/// sees of it, its names and types, stand in boxbeam/*.py and *.pyi.
namespace boxbeam::python {
namespace {

namespace py = pybind11;
using Settings = std::vector<std::string>;  ///< "key=value", as --set

/// A case by its file, or as text, which then stands where the path says.
struct Case {
  std::string path;
  std::optional<std::string> text;
};

std::vector<Project> read(const Case& of, const Settings& set) {
  std::vector<Project> beams =
      of.text ? parse_beams(of.path, *of.text, set) : read_beams(of.path, set);
  if (beams.size() == 1) beams.front().beam_name.clear();
  return beams;
}

std::string verified(const std::string& path, const std::optional<std::string>& text,
                     const Settings& set) {
  const py::gil_scoped_release others_run;
  return results_json(verify_beams(read({path, text}, set)));
}

/// The motion of a case, of which Python asks for the document, or for columns.
class Moved {
 public:
  Moved(const std::string& path, const std::optional<std::string>& text, const Settings& set,
        const Samples& times) {
    if (times.ndim() != 1) throw py::value_error("times are no array of one row");
    const std::vector<double> at(times.data(), times.data() + times.size());
    const py::gil_scoped_release others_run;
    beams_ = read({path, text}, set);
    motion_ = front_end_of(beams_.front())->motion(at, "");
  }
  std::string json() const {
    const py::gil_scoped_release others_run;
    return motion_json(motion_);
  }
  py::dict columns() const {
    std::vector<MotionColumn> found;
    {
      const py::gil_scoped_release others_run;
      found = motion_columns(motion_);
    }
    return columns_of(std::move(found));
  }

 private:
  std::vector<Project> beams_;
  AnyMotionResult motion_;
};

std::string section_properties(const std::vector<std::string>& profiles, const std::string& steel,
                               const std::array<double, cut_force::count>& forces,
                               bool with_forces) {
  const py::gil_scoped_release others_run;
  const auto material = find_steel(steel);
  if (!material)
    throw InputError(fmt::format("there is no steel \"{}\"", steel),
                     fmt::format("known are {}", fmt::join(steel_names(), ", ")));
  std::vector<SectionSummary> summaries;
  for (const NamedSection& section : sections_from_words(profiles)) {
    summaries.push_back(summary_of(section, *material));
    if (with_forces)
      summaries.back().under = std::make_shared<const SectionUnderForces>(section_under(
          section.section, *material,
          CutForces{si<Force>(forces[0]), si<Force>(forces[1]), si<Force>(forces[2]),
                    si<Moment>(forces[3]), si<Moment>(forces[4]), si<Moment>(forces[5])}));
  }
  return section_json(summaries);
}

/// What is kept of each design of a sweep.
struct SweptDesigns {
  std::vector<std::vector<double>> numbers;     ///< by column; not a number where there is none
  std::vector<std::vector<std::string>> words;  ///< by column, of "verdict" and "governing"
  std::vector<std::string> units;
  std::vector<std::string> status;
};

bool is_of_words(const std::string& column) { return column == "verdict" || column == "governing"; }

/// Verifies designs on several threads, none of which knows of Python.
class Sweeping {
 public:
  Sweeping(const Case& of, const std::vector<Settings>& designs,
           const std::vector<std::string>& columns)
      : case_(&of), designs_(&designs), columns_(&columns) {
    if (!of.text) source_.emplace(of.path);
    const double none = std::numeric_limits<double>::quiet_NaN();
    swept_.numbers.assign(columns.size(), std::vector<double>(designs.size(), none));
    swept_.words.assign(columns.size(), std::vector<std::string>(designs.size()));
    swept_.units.assign(columns.size(), "");
    swept_.status.assign(designs.size(), "");
  }

  SweptDesigns run(std::size_t threads) {
    {
      std::vector<std::jthread> workers;
      for (std::size_t i = 1; i < std::min(threads, designs_->size()); ++i)
        workers.emplace_back([this] { work(); });
      work();
    }
    if (trouble_) std::rethrow_exception(trouble_);
    if (hint_) throw InputError(fmt::format("there is no result \"{}\"", unknown_column_), *hint_);
    return std::move(swept_);
  }

 private:
  void work() {
    for (std::size_t i = next_++; i < designs_->size(); i = next_++) {
      try {
        swept_.status[i] = trouble_of(i);
      } catch (...) {
        const std::lock_guard lock(mutex_);
        if (!trouble_) trouble_ = std::current_exception();
        next_ = designs_->size();
      }
    }
  }

  /// "ok", or the first thing that is wrong with a design.
  std::string trouble_of(std::size_t design) {
    try {
      take(design, verify_beams(beams_of((*designs_)[design])));
      return "ok";
    } catch (const InputError& error) {
      return error.problems().empty() ? error.what() : error.problems().front().message;
    } catch (const AnalysisError& error) {
      return error.failure().where.empty() ? error.failure().what
                                           : error.failure().where + ": " + error.failure().what;
    } catch (const OutputError& error) {
      return error.what();
    }
  }

  /// Of a case in a file that file is read once.
  std::vector<Project> beams_of(const Settings& set) const {
    if (!source_) return read(*case_, set);
    std::vector<Project> beams = source_->read_beams(set);
    if (beams.size() == 1) beams.front().beam_name.clear();
    return beams;
  }

  void take(std::size_t design, const std::vector<VerifiedBeam>& beams) {
    const Verification& worst = worst_of(beams).verification;
    std::optional<ResultBook> book;
    for (std::size_t k = 0; k < columns_->size(); ++k) {
      const std::string& column = (*columns_)[k];
      if (column == "verdict") {
        swept_.words[k][design] = to_text(worst.verdict);
      } else if (column == "governing") {
        if (!worst.checks.empty()) swept_.words[k][design] = worst.checks.front().check.id;
      } else {
        if (!book) book = results_of(beams, *columns_);
        const ResultValue* const value = book->find(column);
        const std::lock_guard lock(mutex_);
        if (value != nullptr) {
          swept_.numbers[k][design] = value->value;
          if (value->unit != "1") swept_.units[k] = value->unit;
        }
        known_[column] = known_[column] || value != nullptr;
        note_unknown(beams);
      }
    }
  }

  /// A column that no design has had yet; which is what is said where none ever does.
  void note_unknown(const std::vector<VerifiedBeam>& beams) {
    for (const auto& [column, is_known] : known_) {
      if (is_known) continue;
      if (hint_ && unknown_column_ == column) return;
      unknown_column_ = column;
      hint_ = results_of(beams).hint_for(column);
      return;
    }
    hint_.reset();
  }

  const Case* case_;
  std::optional<CaseSource> source_;  ///< of a case in a file
  const std::vector<Settings>* designs_;
  const std::vector<std::string>* columns_;
  SweptDesigns swept_;
  std::atomic<std::size_t> next_{0};
  std::mutex mutex_;  ///< of what follows, and of units
  std::exception_ptr trouble_;
  std::map<std::string, bool> known_;
  std::string unknown_column_;
  std::optional<std::string> hint_;
};

/// A key that the case has not, or has in another dimension, is wrong in all designs, which set the
/// keys in this order.
void require_keys(const Case& of, const std::vector<std::string>& keys,
                  const std::vector<Settings>& designs) {
  if (designs.empty()) return;
  const CaseDocument document =
      of.text ? parse_document(of.path, *of.text, {}) : read_document(of.path, {});
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const std::string value = designs.front()[i].substr(keys[i].size() + 1);
    const auto trouble =
        trouble_with_key(document, keys[i], value, {designs.front(), designs.back()},
                         [&](const Settings& set) { read(of, set); });
    if (trouble) throw InputError(trouble->what, trouble->hint);
  }
}

py::tuple swept(const std::string& path, const std::optional<std::string>& text,
                const std::vector<std::string>& keys, const std::vector<Settings>& designs,
                const std::vector<std::string>& columns, std::size_t threads) {
  SweptDesigns found;
  {
    const py::gil_scoped_release others_run;
    if (threads == 0) threads = std::max(1U, std::thread::hardware_concurrency());
    const Case of{path, text};
    // What is wrong with the case as it is, is wrong with all designs.
    read(of, {});
    require_keys(of, keys, designs);
    found = Sweeping(of, designs, columns).run(threads);
  }
  py::list results;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    if (is_of_words(columns[k]))
      results.append(py::cast(found.words[k]));
    else
      results.append(array_of(std::move(found.numbers[k])));
  }
  return py::make_tuple(results, found.units, found.status);
}

/// An exception of the package, with what is known of it as its arguments.
template <class... Arguments>
void raise(const char* name, Arguments&&... arguments) {
  const py::object type = py::module_::import("boxbeam._errors").attr(name);
  const py::object error = type(std::forward<Arguments>(arguments)...);
  PyErr_SetObject(type.ptr(), error.ptr());
}

void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const InputError& error) {
    py::list problems;
    for (const Problem& of : error.problems())
      problems.append(
          py::make_tuple(of.file, of.line, of.column, of.source_line, of.message, of.hint));
    raise("InputError", error.what(), problems);
  } catch (const AnalysisError& error) {
    const AnalysisFailure& of = error.failure();
    raise("AnalysisError", error.what(), of.what, of.where, of.time, of.residual, of.condition,
          of.details);
  } catch (const OutputError& error) {
    raise("OutputError", error.what());
  }
}

/// Arrays of numpy 2 are laid out otherwise than pybind11 knew before 2.12: they would have wrong
/// numbers.
void require_known_arrays() {
  if (PYBIND11_VERSION_MAJOR > 2 || PYBIND11_VERSION_MINOR >= 12) return;
  const auto numpy = py::module_::import("numpy").attr("__version__").cast<std::string>();
  if (std::stoi(numpy) < 2) return;
  throw py::import_error(
      fmt::format("boxbeam is built with pybind11 {}.{}, which does not know the arrays of numpy "
                  "{}: build it with pybind11 2.12 or later (pip install pybind11), or install "
                  "numpy below 2",
                  PYBIND11_VERSION_MAJOR, PYBIND11_VERSION_MINOR, numpy));
}

}  // namespace
}  // namespace boxbeam::python

PYBIND11_MODULE(_core, module) {
  namespace of = boxbeam::python;
  of::require_known_arrays();
  pybind11::register_exception_translator(of::translate);
  module.attr("version") = boxbeam::version;
  module.def("verify", of::verified);
  pybind11::class_<of::Moved>(module, "Moved")
      .def(pybind11::init<const std::string&, const std::optional<std::string>&,
                          const of::Settings&, const of::Samples&>())
      .def("json", &of::Moved::json)
      .def("columns", &of::Moved::columns);
  module.def("section", of::section_properties);
  module.def("sweep", of::swept);
  of::add_fatigue(module);
}
