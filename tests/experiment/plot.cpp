#include "experiment/plot.h"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "picture/canvas.h"
#include "timing/seconds.h"

namespace experiment {
namespace {

using Eigen::Vector2d;
using picture::Canvas;
using robots::Colour;

constexpr Colour kWhite{255, 255, 255}, kBlack{0, 0, 0}, kGrid{222, 222, 222},
    kTiring{250, 225, 220}, kPlacedField{222, 242, 222}, kPaper{120, 60, 150}, kOwn{200, 0, 0};
constexpr int kColumn = 380, kPanel = 330, kHead = 96;  // px
constexpr int kLeft = 48, kRight = 20, kTop = 26, kBottom = 40;
constexpr double kLongest = 0.5;  // s, of the link's round trips

/// This is a round trip that was found acceptable.
struct Acceptable {
  double delay;  // s
  const char* name;
};
constexpr std::array<Acceptable, 3> kAcceptable{{{0.1, "N"}, {0.2, "X"}, {0.3, "X"}}};

/// A Style is one of the four curves of a panel.
struct Style {
  bool fixtures;
  Inputs inputs;
  Colour colour;
  // Curves may lie upon each other.
  double ring;  // px
  bool thick;
  const char* name;
};
constexpr std::array<Style, 4> kStyles{{
    {true, Inputs::Two, {0, 80, 200}, 3, true, "fixtures, two inputs"},
    {true, Inputs::One, {0, 170, 200}, 6, false, "fixtures, one input"},
    {false, Inputs::Two, {210, 60, 0}, 3, true, "no fixtures, two inputs"},
    {false, Inputs::One, {235, 160, 0}, 6, false, "no fixtures, one input"},
}};

/// A Quantity is what is drawn upward in a panel.
struct Quantity {
  const char* name;
  std::vector<double> ticks;  // the first and the last are the panel's ends
  bool logarithmic;
  bool ofKnot;  // what is within a millimetre is placed
  std::function<double(const Result&)> of;
};

class Panel {
 public:
  Panel(Canvas& canvas, int column, int line, const Quantity& quantity)
      : canvas_(canvas),
        left_(column * kColumn + kLeft),
        top_(kHead + line * kPanel + kTop),
        quantity_(quantity) {}

  Vector2d at(double delay, double value) const {
    return {left_ + width() * delay / kLongest, top_ + height() * (1 - shareOf(value))};
  }
  void fillDelays(double from, double to, Colour colour) {
    canvas_.fill(at(from, highest()), at(to, lowest()), colour);
  }
  void fillValues(double from, double to, Colour colour) {
    canvas_.fill(at(0, to), at(kLongest, from), colour);
  }
  void grid() {
    for (int ms = 0; ms <= 500; ms += 100) {
      vertical(1e-3 * ms, kGrid);
      canvas_.text(at(1e-3 * ms, lowest()) + Vector2d(-12, 17), std::to_string(ms), kBlack);
    }
    for (const double tick : quantity_.ticks) {
      canvas_.line(at(0, tick), at(kLongest, tick), kGrid);
      canvas_.text(at(0, tick) + Vector2d(-40, 4), fmt::format("{}", tick), kBlack);
    }
  }
  void vertical(double delay, Colour colour) {
    canvas_.line(at(delay, lowest()), at(delay, highest()), colour);
  }
  void mark(double delay, const char* name, Colour colour) {
    vertical(delay, colour);
    canvas_.text(at(delay, highest()) + Vector2d(3, 13), name, colour);
  }
  void title(const std::string& words) {
    canvas_.text(at(0, highest()) + Vector2d(0, -8), words, kBlack);
  }
  void curve(const std::vector<Vector2d>& points, const Style& style) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vector2d here = at(points[i].x(), points[i].y());
      canvas_.ring(here, style.ring, style.colour);
      if (i == 0) continue;
      const Vector2d before = at(points[i - 1].x(), points[i - 1].y());
      canvas_.line(before, here, style.colour);
      if (style.thick) canvas_.line(before + Vector2d(0, 1), here + Vector2d(0, 1), style.colour);
    }
  }
  double lowest() const { return quantity_.ticks.front(); }
  double highest() const { return quantity_.ticks.back(); }

 private:
  static constexpr int width() { return kColumn - kLeft - kRight; }
  static constexpr int height() { return kPanel - kTop - kBottom; }
  double shareOf(double value) const {
    const double bounded = std::clamp(value, lowest(), highest());
    if (!quantity_.logarithmic) return (bounded - lowest()) / (highest() - lowest());
    return std::log(bounded / lowest()) / std::log(highest() / lowest());
  }

  Canvas& canvas_;
  int left_, top_;
  const Quantity& quantity_;
};

/// Returns jitter and loss without the delay.
Link kindOf(const Trial& trial) { return {{}, trial.link.jitter, trial.link.loss}; }

std::vector<Link> kindsIn(const std::vector<TrialResult>& results) {
  std::vector<Link> kinds;
  for (const TrialResult& one : results) {
    const Link kind = kindOf(one.trial);
    const bool known = std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
    if (!known && (kind.jitter == 0 || kind.loss == 0)) kinds.push_back(kind);
  }
  return kinds;
}

std::string nameOf(const Link& kind) {
  if (kind.jitter > 0) return fmt::format("jitter {:.0f} %", 1e2 * kind.jitter);
  if (kind.loss > 0) return fmt::format("loss {:.0f} %", 1e2 * kind.loss);
  return "no jitter, no loss";
}

void drawPanel(Canvas& canvas, int column, int line, const Quantity& quantity, const Link& kind,
               const std::vector<TrialResult>& results, const Limit& limit) {
  Panel panel(canvas, column, line, quantity);
  panel.fillDelays(0.4, 0.5, kTiring);
  if (quantity.ofKnot) panel.fillValues(panel.lowest(), 1e3 * kPlaced, kPlacedField);
  panel.grid();
  for (const auto& [delay, name] : kAcceptable) panel.mark(delay, name, kPaper);
  for (const double shift : {0.0, 0.0015}) panel.vertical(limit.measured + shift, kOwn);
  panel.title(std::string(quantity.name) + ": " + nameOf(kind));
  for (const Style& style : kStyles) {
    std::vector<Vector2d> points;
    for (const auto& [trial, result] : results) {
      if (kindOf(trial) != kind || trial.fixtures != style.fixtures) continue;
      if (trial.inputs != style.inputs) continue;
      points.emplace_back(robots::inSeconds(trial.link.roundTrip), quantity.of(result));
    }
    panel.curve(points, style);
  }
}

void drawHead(Canvas& canvas, const Limit& limit) {
  canvas.text(
      {12, 20},
      "An operator places a knot over a link: x is its round trip in ms. Green: within 1 mm. "
      "A time of 20 s: not placed.",
      kBlack);
  double x = 12;
  for (const Style& style : kStyles) {
    canvas.fill({x, 34}, {x + 24, 38}, style.colour);
    canvas.text({x + 30, 41}, style.name, kBlack);
    x += 225;
  }
  canvas.text(
      {12, 62},
      "violet: N, 100 ms: Nankaku 2022 (acceptable); X, 200 and 300 ms: Xu 2014 (ideal; suitable); "
      "pink: 400 to 500 ms Xu 2014 (tiring)",
      kPaper);
  canvas.text(
      {12, 82},
      fmt::format("red: the operator's own limit without fixtures, {:.0f} ms measured, {:.0f} "
                  "ms by pi/(2 w_c) - tau - {:.0f} ms",
                  1e3 * limit.measured, 1e3 * limit.byFormula, 1e3 * limit.loop),
      kOwn);
}

}  // namespace

void plot(const std::filesystem::path& file, const std::vector<TrialResult>& results,
          const Limit& limit) {
  const std::array<Quantity, 3> quantities{{
      {"knot error, mm",
       {0.01, 0.1, 1, 10, 100},
       true,
       true,
       [](const Result& one) { return 1e3 * one.error; }},
      {"time to place, s",
       {0, 5, 10, 15, 20},
       false,
       false,
       [](const Result& one) { return one.time.value_or(kLength); }},
      {"tracking error p50, mm",
       {0.01, 0.1, 1, 10, 100},
       true,
       false,
       [](const Result& one) { return 1e3 * one.tracking50; }},
  }};
  const std::vector<Link> kinds = kindsIn(results);
  const int lines = static_cast<int>(quantities.size());
  Canvas canvas(std::max(static_cast<int>(kinds.size()) * kColumn, 3 * kColumn),
                kHead + lines * kPanel, kWhite);
  drawHead(canvas, limit);
  for (std::size_t column = 0; column < kinds.size(); ++column) {
    for (int line = 0; line < lines; ++line) {
      drawPanel(canvas, static_cast<int>(column), line, quantities[static_cast<std::size_t>(line)],
                kinds[column], results, limit);
    }
  }
  canvas.write(file);
}

}  // namespace experiment
