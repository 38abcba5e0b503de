#pragma once

#include <memory>
#include <span>
#include <string>

#include "readers.hpp"

namespace boxbeam::readers {

/// The parts of a case that a situation may change: how the mechanism runs, not what is verified.
struct Changeable {
  std::span<const char* const> parts;
  const char* example;  ///< "drivers.exciter.frequency"
  std::string beam;     ///< the beam's body or link
};

/// How a kind of case is read, into the project that it is made for: the only place of the reader
/// where kinds are told apart.
class FrontEndReader {
 public:
  FrontEndReader(const Sections& sections, TimeTables& tables, Project& project)
      : sections_(&sections), tables_(&tables), project_(&project) {}
  FrontEndReader(const FrontEndReader&) = delete;
  FrontEndReader& operator=(const FrontEndReader&) = delete;
  virtual ~FrontEndReader() = default;

  /// The beam and what moves or loads it. `tree` is the case.
  virtual void read(TableReader& root, const Node& tree) = 0;

  virtual Changeable changeable() const = 0;

  /// The mechanism once more, with what a situation changes.
  virtual AnyMechanism changed_mechanism(TableReader& root) const = 0;

  /// Whether it vibrates of itself, so that it can be started.
  virtual bool vibrates() const { return false; }

  /// "loads" of a situation whose other changes are read, where it has load cases.
  virtual void read_loads(TableReader&, Situation&) const {}

  /// Situations that the case does not list.
  virtual std::vector<Situation> read_combinations(TableReader&) const { return {}; }

  /// What is checked beside the beam.
  virtual void read_neighbours(TableReader&) {}

 protected:
  const Sections* sections_;
  TimeTables* tables_;
  Project* project_;
};

/// The reader for the kind of the project's mechanism. Everything given stays as long as the
/// reader.
std::unique_ptr<FrontEndReader> front_end_reader(const Sections& sections, TimeTables& tables,
                                                 Project& project);

/// Those of the kinds, each in its *_case.cpp; of the mechanism only the kind counts.
std::unique_ptr<FrontEndReader> reader_for(const planar::Mechanism&, const Sections&, TimeTables&,
                                           Project&);
std::unique_ptr<FrontEndReader> reader_for(const spatial::Mechanism&, const Sections&, TimeTables&,
                                           Project&);
std::unique_ptr<FrontEndReader> reader_for(const flexible::Mechanism&, const Sections&, TimeTables&,
                                           Project&);
std::unique_ptr<FrontEndReader> reader_for(const frame::Structure&, const Sections&, TimeTables&,
                                           Project&);
std::unique_ptr<FrontEndReader> reader_for(const recorded::Loads&, const Sections&, TimeTables&,
                                           Project&);

/// The parts of a mechanism of rigid bodies that a situation may change.
Changeable changeable_of_bodies(const std::string& beam_body);

/// What a situation does not change of joints that give way.
void refuse_other_joints(TableReader& root, bool other);

/// Which parts of rigid mechanisms in the plane another kind of case knows as well.
struct Known {
  bool deflection = false, neighbours = false, loops = false;
};

/// Notes the parts that it does not know.
void refuse_planar_parts(TableReader& root, const Project& project, Known known = {});

}  // namespace boxbeam::readers
