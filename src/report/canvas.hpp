#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "drawing.hpp"
#include "plot_script.hpp"

/// Places in a figure, and labels that keep off each other. Pixels from the lower left corner, of a
/// figure that is `figure_width` wide.
namespace boxbeam::plot {

struct Frame {
  double left = 0.0, bottom = 0.0, right = 0.0, top = 0.0;
};

/// Axes of one diagram: where they stand and what they show.
struct Panel {
  Frame frame;
  double x_low = 0.0, x_high = 1.0;
  double y_low = 0.0, y_high = 1.0;
  bool log_x = false, log_y = false;

  Pixel at(double x, double y) const;
};

/// About how long a text is in the house's font [px]; no shorter.
double text_width(const std::string& text);

/// The text, or where it is longer than the room its beginning with "...".
std::string fitted(const std::string& text, double room);

/// The text in lines of at most so much room, broken at spaces.
std::vector<std::string> wrapped(const std::string& text, double room);

/// Texts one below the other, each in as many lines as it needs.
std::vector<std::string> wrapped(const std::vector<std::string>& texts, double room);

/// 1, 2 or 5 times a power of ten: divides a span into at most so many steps.
double tic_step(double span, int most);

/// Range of an axis that holds two values, zero among them, with a share of room beyond each.
std::pair<double, double> range_with_zero(double low, double high, double room);

/// Texts beside places, each where it hits neither another nor what is drawn.
class Labels {
 public:
  /// What labels must not touch, and what they had better not cross.
  void keep_free(const Frame& box) { boxes_.push_back(box); }
  void keep_off(const Pixel& from, const Pixel& to) { lines_.emplace_back(from, to); }
  void keep_off(const std::vector<Pixel>& polyline);
  /// The polyline of a curve in a panel.
  void keep_off(const Panel& panel, const std::vector<Row2>& rows);

  /// How much a line would disturb what is drawn [px]: its length on what labels must not touch,
  /// and ten for each line that it crosses.
  double disturbance(const Pixel& from, const Pixel& to) const;

  /// Puts a text near a place, inside the bounds; a thin line leads to it from afar. Nothing is
  /// drawn where there is no room.
  bool put(Script& gp, const std::string& text, const Pixel& at, const Frame& bounds,
           const char* colour = "#202020", double gap = 7.0);

  /// The same in a drawing, if it may be towards a direction.
  bool put(Drawing& drawing, const std::string& text, const Pixel& at, const Frame& bounds,
           const std::string& colour, double gap, const Eigen::Vector2d& towards = {0.0, 0.0});

 private:
  /// The left end of a text at the middle of its height, and where a line from there to its place
  /// begins.
  struct Spot {
    Pixel left;
    std::optional<Pixel> lead;
  };
  std::optional<Spot> spot_for(const std::string& text, const Pixel& at, const Frame& bounds,
                               double gap, const Eigen::Vector2d& towards);

  std::vector<Frame> boxes_;
  std::vector<std::pair<Pixel, Pixel>> lines_;
};

/// A text at a place of the figure: "left", "center" or "right" of it.
void put_text(Script& gp, const std::string& text, const Pixel& at, const char* side = "left",
              const char* colour = "#202020");

/// Height of a line of running text [px].
inline constexpr double text_line = 15.0;

/// Lines of text below a place; the height where they end.
double put_lines(Script& gp, const std::vector<std::string>& lines, const Pixel& top,
                 const char* side = "left", const char* colour = "#202020");

/// A line without a head.
void put_line(Script& gp, const Pixel& from, const Pixel& to, const std::string& style);

/// An arrow in pixels.
void put_arrow(Script& gp, const Pixel& from, const Pixel& to, const std::string& style);

/// Places the next plot, with steps that suit its size.
void place(Script& gp, const Panel& panel);

/// What the name of an ordinate has behind it where its axis does not begin at zero, so that
/// heights are no measure; "" elsewhere. Logarithmic axes show it themselves.
const char* note_of_beginning(const Panel& panel);

/// The name of a panel's ordinate, above its upper left corner, and that of its abscissa below.
void put_heading(Script& gp, const Panel& panel, const std::string& text);
void put_footing(Script& gp, const Panel& panel, const std::string& text);

/// The room that headings take above a panel, and numbers and footings below one [px].
inline constexpr double heading_room = 26.0;
inline constexpr double footing_room = 44.0;

/// A line of a legend.
struct LegendEntry {
  std::string title;
  std::string style;       ///< of the stroke before it: "lw 1.8 lc rgb '...'"; "" without one
  std::string point = {};  ///< of a mark on it: "pt 7 ps 0.7 lc rgb '...'"
  Pen pen = {};            ///< of the stroke in a drawing
};

/// A line of a legend where it is drawn: the beginning of its stroke.
using LegendRow = std::pair<LegendEntry, Pixel>;
inline constexpr double legend_stroke = 30.0;  ///< length of a legend's stroke [px]
inline constexpr double legend_words = 38.0;   ///< where the words begin behind its begin [px]
std::vector<LegendRow> rows_of_legend(const std::vector<LegendEntry>& entries, double bottom);

/// How high a legend over the whole width is [px].
double height_of_legend(const std::vector<LegendEntry>& entries);

/// Draws it with its lower border at a height.
void draw_legend(Script& gp, const std::vector<LegendEntry>& entries, double bottom);

}  // namespace boxbeam::plot
