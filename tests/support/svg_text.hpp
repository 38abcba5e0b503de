#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// What stands in figures, and whether it can be read.
namespace test {

/// A text of an SVG and where it stands [px], y downwards.
struct SvgText {
  std::string text;
  double left = 0.0, right = 0.0, top = 0.0, bottom = 0.0;
  double size = 0.0;
};

/// All texts of a figure. None may be written upright.
std::vector<SvgText> texts_of(const std::string& svg);

bool has(const std::vector<SvgText>& texts, const std::string& part);

/// No text of a figure leaves it, is small on paper, or lies on another.
void check_legible(const std::string& svg);

/// What gnuplot says of a script, run as its first line tells the reader to.
std::string words_of_gnuplot(const std::filesystem::path& folder, const std::string& name);

}  // namespace test
