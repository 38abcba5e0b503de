#pragma once

#include <memory>
#include <ostream>
#include <string>
#include <tuple>
#include <vector>

#include "boxbeam/project/project.hpp"
#include "boxbeam/verification/verify.hpp"
#include "drawing.hpp"

/// What the figures share: the script they are written into, and the house style.
namespace boxbeam::plot {

using Row2 = std::tuple<double, double>;
using Row3 = std::tuple<double, double, double>;
using Row4 = std::tuple<double, double, double, double>;

/// All figures are so wide [px], in letters of 12.
inline constexpr double figure_width = 620.0;

/// A gnuplot script with its data inside.
class Script {
 public:
  /// Throws OutputError where the file cannot be written.
  explicit Script(const std::string& path);
  ~Script();
  Script(const Script&) = delete;
  Script& operator=(const Script&) = delete;

  template <class T>
  Script& operator<<(const T& value) {
    out() << value;
    return *this;
  }

  /// The house style: quiet axes, light grid behind, one font. The figure is `figure_width` wide
  /// and so high [px]; as PDF as wide as the text of a page of A4, letters of 9 pt and a little.
  void begin(const std::string& name, double height);
  double width() const { return figure_width; }
  double height() const { return height_; }

  /// Draws curves in the axes that were placed, with the labels and arrows put since the last.
  void plot(const std::vector<std::string>& curves);

  /// A data block of rows of numbers.
  void block(const std::string& name, const std::vector<Row2>& rows);
  void block(const std::string& name, const std::vector<Row3>& rows);
  void block(const std::string& name, const std::vector<Row4>& rows);

 private:
  struct Pipe;
  std::ostream& out();
  std::unique_ptr<Pipe> pipe_;
  double height_ = 0.0;
};

/// Colours that eyes blind to red or green, and prints without colour, tell apart together with
/// `dashes`.
const char* colour(std::size_t i);
const char* dashes(std::size_t i);

/// A line of the i-th of several things.
std::string line_style(std::size_t i, double width = 1.6);

/// The unit of a cut force, and its symbol with its index below.
std::string axis_title(const CutForceName& name);

/// A user's text as a gnuplot string: in single quotes, where gnuplot replaces nothing, but quotes
/// themselves. Control characters become spaces. To be drawn "noenhanced".
std::string quoted(const std::string& text);

/// "t = 1.0710 s", and in a case of several situations which one.
std::string time_label(Time time, const std::string& situation = "");

// The figures, each in a file of its own.
Drawing sketch(const Project& project, const Verification& verification);
Drawing use_along_beam(const Project& project, const Verification& verification);
Drawing mechanism(const Project& project, const Verification& verification);
Drawing mechanism_in_space(const Project& project, const Verification& verification);
Drawing section(const Project& project, const Verification& verification);
Drawing modes(const Project& project, const Verification& verification);
void motion(Script& gp, const Project& project, const Verification& verification);
void cut_forces(Script& gp, const Project& project, const Verification& verification);
void cut_forces_in_space(Script& gp, const Project& project, const Verification& verification);
void loads_over_time(Script& gp, const Project& project, const Verification& verification);
void utilisation(Script& gp, const Project& project, const Verification& verification);
void stress(Script& gp, const Project& project, const Verification& verification);
void sn(Script& gp, const Project& project, const Verification& verification);
void spectrum(Script& gp, const Project& project, const Verification& verification);
void frequency_response(Script& gp, const Project& project, const Verification& verification);
void joint_forces(Script& gp, const Project& project, const Verification& verification);
void sudden_start(Script& gp, const Project& project, const Verification& verification);

}  // namespace boxbeam::plot
