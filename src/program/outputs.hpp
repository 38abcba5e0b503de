#pragma once

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "boxbeam/core/error.hpp"
#include "boxbeam/report/document.hpp"
#include "report/folder_update.hpp"

/// What commands that write files share.
namespace boxbeam::program {

/// What went wrong with outputs.
struct Troubles {
  std::vector<std::string> words;
  /// Something that can be had here failed (a full disk, a tool that breaks off), other than a tool
  /// that is not installed.
  bool failed = false;

  /// Does what may fail without the rest; whether it did not.
  template <class Write>
  bool attempt(const Write& write) {
    try {
      write();
      return true;
    } catch (const report::MissingTool& error) {
      words.emplace_back(error.what());
    } catch (const OutputError& error) {
      words.emplace_back(error.what());
      failed = true;
    }
    return false;
  }
};

/// Puts what was written into its place, unless something failed and the report of an earlier run
/// is there: that one stays whole then. Returns whether the new one is in its place.
inline bool publish(report::FolderUpdate& update, const std::string& folder,
                    const std::vector<std::string>& earlier, Troubles& troubles) {
  const auto stands = [&](const std::string& name) {
    std::error_code error;
    return std::filesystem::is_regular_file(std::filesystem::path(folder) / name, error);
  };
  for (std::string& words : troubles.words) words = update.in_place(words);
  if (troubles.failed && std::any_of(earlier.begin(), earlier.end(), stands)) {
    // The log of a tool that failed is no part of a report.
    for (const std::string& name : earlier) {
      if (name.ends_with(".log")) update.publish_beside(name);
    }
    troubles.words.push_back("what an earlier run wrote to " + folder + " stays as it was");
    return false;
  }
  return troubles.attempt([&] { update.publish(earlier); });
}

/// The content of a figure in a folder, where it stands there.
std::optional<std::string> svg_in(const std::string& folder, const std::string& name);

/// Writes a page of a study into a folder, with the figures that stand there; its name again.
std::string write_page(const std::string& name, const report::Document& document,
                       const std::string& folder);

/// Whether a result can be written to where the user wants it, before it is calculated. All throw
/// OutputError. A file stands in a folder that is there: none is made for it; "" and "-" are none.
void require_file(const std::string& path);
/// Likewise; but the folder of the report is made with the report.
void require_file_beside(const std::string& path, const std::string& folder);
/// A folder that is there and can be written to, or can be made.
void require_folder(const std::string& path);

}  // namespace boxbeam::program
