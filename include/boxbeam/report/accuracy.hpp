#pragma once

#include <string>
#include <vector>

#include "boxbeam/report/document.hpp"
#include "boxbeam/study/topics.hpp"

namespace boxbeam {

/// A topic and what it showed.
struct TopicShown {
  const study::Topic* topic;
  study::TopicResult result;
};

/// The data of a chart or a map as CSV, a row per setting or trial, the unit of each column in its
/// name. Numbers in full, so that they are read back as they were.
std::string chart_csv(const study::Chart& chart);
std::string map_csv(const study::Map& map);

/// Draws all charts and maps into a folder by gnuplot, NAME.svg each, and where `pdf_folder` is not
/// empty NAME.pdf there; scripts as those of `draw_figures`. Returns the names of the SVG files.
/// Throws OutputError where gnuplot is missing or fails.
std::vector<std::string> draw_charts(const std::vector<TopicShown>& topics,
                                     const std::string& folder, const std::string& pdf_folder = "");

/// All charts and maps in one document, with a table of the default settings and a sentence each
/// on what to choose.
report::Document accuracy_document(const std::vector<TopicShown>& topics);

}  // namespace boxbeam
