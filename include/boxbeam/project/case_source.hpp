#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "boxbeam/project/project.hpp"

namespace boxbeam {

class KeptFiles;

/// A case that is read many times, each time with other values of its keys. Its text and the files
/// that it names are read once, when they are first asked for, and are as they were then; every
/// reading is what reading the file would give. May be asked by several threads at once.
class CaseSource {
 public:
  /// Throws InputError where the file cannot be read or is no TOML.
  explicit CaseSource(const std::string& path);
  ~CaseSource();
  CaseSource(const CaseSource&) = delete;
  CaseSource& operator=(const CaseSource&) = delete;

  /// As the function of this name, of this file.
  std::vector<Project> read_beams(const std::vector<std::string>& overrides = {},
                                  std::optional<Dynamics> dynamics = {}) const;

 private:
  std::string text_;
  CaseDocument document_;  ///< without overrides
  std::unique_ptr<KeptFiles> files_;
};

}  // namespace boxbeam
