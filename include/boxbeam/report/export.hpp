#pragma once

#include <deque>
#include <string>
#include <vector>

#include "boxbeam/verification/load_samples.hpp"
#include "boxbeam/verification/plate_field.hpp"
#include "boxbeam/verification/shell_model.hpp"
#include "boxbeam/verification/verify.hpp"

/// What other programs read of a verification. Numbers in full, SI, decimal points.
namespace boxbeam {

/// A file of an export.
struct ExportedFile {
  std::string name, content;
};

/// Rows that a spreadsheet holds.
inline constexpr std::size_t spreadsheet_rows = 1'048'576;

/// Cut forces of every situation that runs at every station of the result, over its instants. Where
/// these are more rows than a spreadsheet holds every n-th instant, from the first; n is `every`.
std::string cut_forces_csv(const Verification& verification, const std::deque<SituationRun>& runs,
                           std::size_t& every);

/// The utilisation by every criterion along the beam, and the worst; empty where not judged.
std::string utilisation_csv(const Verification& verification);

/// The checks as results.json has them.
std::string checks_csv(const Verification& verification);

/// Properties and sizes of the sections at the stations of the result, gross where not said
/// otherwise.
std::string sections_csv(const Project& project, const Verification& verification);

/// A case of kind "loads" that verifies the beam without its mechanism, with its tables of loads.
std::vector<ExportedFile> given_loads_files(const Project& project, const LoadSamples& samples);

/// Names of all files that an export can have; of tables of loads those of the case.
std::vector<std::string> names_of_exports(const Project& project);

/// Plates and axis as an unstructured grid. Source: VTK file formats, "Simple legacy formats",
/// version 3.0.
std::string plates_vtk(const PlateField& field, const std::string& title);

/// An input file of CalculiX, linear static. Source: CalculiX CrunchiX user's manual, version 2.20.
std::string shells_inp(const ShellModel& model, const Project& project, const std::string& title);

/// Our stress in the middle of every element of it, to be compared.
std::string shells_csv(const ShellModel& model);

}  // namespace boxbeam
