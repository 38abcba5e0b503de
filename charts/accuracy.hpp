#pragma once

#include <string>
#include <utility>
#include <vector>

#include "boxbeam/report/document.hpp"
#include "charts/topics.hpp"

namespace boxbeam {

/// A topic and what it showed.
struct TopicShown {
  const charts::Topic* topic;
  charts::TopicResult result;
};

/// What was charted, and on what.
struct AccuracyRun {
  std::vector<TopicShown> topics;
  bool quick = false;
  bool drawn = true;  ///< charts and maps stand as pictures beside the document
  /// The cases with the SHA-256 of what they say.
  std::vector<std::pair<std::string, std::string>> scenes = {};
};

/// The data of a chart or a map as CSV (RFC 4180), a row per setting or trial, the unit of each
/// column in its name. Numbers with as many digits as it takes to read them back as they were;
/// nothing where there is none.
std::string chart_csv(const charts::Chart& chart);
std::string map_csv(const charts::Map& map);

/// Draws all charts and maps into a folder by gnuplot, NAME.svg each, and where `tex_folder` is not
/// empty NAME.tex there; scripts as those of `draw_figures`. Returns the names of the SVG files.
/// Throws OutputError where gnuplot is missing or fails.
std::vector<std::string> draw_charts(const std::vector<TopicShown>& topics,
                                     const std::string& folder, const std::string& tex_folder = "");

/// All charts and maps in one document, which judges nothing: first a table of the settings that
/// the program uses by itself, then a chapter per topic with a sentence on what to choose below
/// each picture, and what failed and why.
report::Document accuracy_document(const AccuracyRun& run);

/// Per topic the settings that the program uses by itself and whether they are good enough for a
/// strength check; of maps the counts.
std::string accuracy_text(const std::vector<TopicShown>& topics);

}  // namespace boxbeam
