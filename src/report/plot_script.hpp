#pragma once

#include <memory>
#include <ostream>
#include <string>
#include <tuple>
#include <vector>

#include "boxbeam/project/project.hpp"
#include "boxbeam/verification/verify.hpp"

/// What the figures share: the script they are written into, and the house style.
namespace boxbeam::plot {

using Row2 = std::tuple<double, double>;
using Row3 = std::tuple<double, double, double>;
using Row4 = std::tuple<double, double, double, double>;

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

  /// The house style: quiet axes, light grid behind, one font.
  void begin(const std::string& name, int width, int height);

  /// A data block of rows of numbers.
  void block(const std::string& name, const std::vector<Row2>& rows);
  void block(const std::string& name, const std::vector<Row3>& rows);
  void block(const std::string& name, const std::vector<Row4>& rows);

 private:
  struct Pipe;
  std::ostream& out();
  std::unique_ptr<Pipe> pipe_;
};

const char* colour(std::size_t i);

/// A line of a legend.
struct LegendEntry {
  std::string title;
  std::string style;  ///< of the stroke before it: "lw 1.8 lc rgb '...'"
};

/// Draws a legend over the whole width of a figure, its last row so many pixels above the lower
/// border: with the next plot, as labels and arrows from number 500. gnuplot's own legend knows
/// only the width of one panel.
void draw_legend(Script& gp, const std::vector<LegendEntry>& entries, int width, int height,
                 int above);

/// Rows that the legend will take.
std::size_t rows_of_legend(const std::vector<LegendEntry>& entries, int width);

/// The unit of a cut force, and its symbol with its index below.
std::string axis_title(const CutForceName& name);

/// A user's text inside a gnuplot string in single quotes.
std::string quoted(const std::string& text);

/// "t = 1.0710 s", and in a case of several situations which one.
std::string time_label(Time time, const std::string& situation = "");

// The figures, each in a file of its own.
void cut_forces(Script& gp, const Project& project, const Verification& verification);
void cut_forces_in_space(Script& gp, const Project& project, const Verification& verification);
void mechanism(Script& gp, const Project& project, const Verification& verification);
void mechanism_in_space(Script& gp, const Project& project, const Verification& verification);
void modes(Script& gp, const Project& project, const Verification& verification);
void frequency_response(Script& gp, const Project& project, const Verification& verification);
void joint_forces(Script& gp, const Project& project, const Verification& verification);
void sudden_start(Script& gp, const Project& project, const Verification& verification);
void loads_over_time(Script& gp, const Project& project, const Verification& verification);
void stress(Script& gp, const Project& project, const Verification& verification);
void sn(Script& gp, const Project& project, const Verification& verification);

}  // namespace boxbeam::plot
