#include "picture/knot_picture.h"

#include <suture/base/errors.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "picture/canvas.h"
#include "recorder/knot_recording.h"
#include "strand/strand.h"
#include "timing/seconds.h"
#include "vision/painter.h"

namespace demo {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using picture::Canvas;
using robots::Colour;
using robots::Eye;
using robots::KnotRow;

constexpr Colour kWhite{255, 255, 255}, kBlack{0, 0, 0}, kBlue{20, 60, 200}, kGreen{190, 235, 190},
    kGrey{225, 225, 225}, kRed{245, 200, 195}, kLines{200, 200, 200}, kCurve{160, 0, 60};
constexpr int kPlotHeight = 260, kMargin = 40;  // px
constexpr double kShownCorridor = 0.025;        // m of it, before the target

bool seesAll(const robots::CameraPair& cameras, const robots::Strand::Nodes& nodes) {
  for (int node = 0; node < robots::Strand::kNodes; ++node) {
    if (!cameras.sees(nodes.col(node))) return false;
  }
  return true;
}

/// A View is one eye's view of a scene, on the canvas.
class View {
 public:
  View(Canvas& canvas, const Eigen::Isometry3d& camera, Eye eye)
      : canvas_(canvas),
        toCamera_(camera.inverse()),
        eye_(eye),
        left_(eye == Eye::Left ? 0 : cameras_.width) {}

  /// Returns false if a part of it is not before the camera.
  bool paint(const KnotRow& row) {
    const robots::View view = robots::seenFrom(row.camera, row.strand.nodes, row.tissue);
    if (!seesAll(cameras_, view.strand)) return false;
    robots::ImageFrame image;
    robots::Painter(cameras_).paint(eye_, view, image);
    canvas_.put(image, left_, 0);
    canvas_.text({left_ + 12.0, 22}, eye_ == Eye::Left ? "left eye" : "right eye", kWhite);
    return true;
  }
  /// Points and lengths here are in the frame of the scene, in m.
  void cross(const Vector3d& point, double size, Colour colour) {
    if (const auto place = placeOf(point)) canvas_.cross(*place, size, colour);
  }
  void ring(const Vector3d& point, double radius, Colour colour) {
    if (const auto place = placeOf(point)) canvas_.ring(*place, radius, colour);
  }
  void line(const Vector3d& from, const Vector3d& to, Colour colour) {
    const auto first = placeOf(from), last = placeOf(to);
    if (first && last) canvas_.line(*first, *last, colour);
  }

  Eigen::Isometry3d toScene() const { return toCamera_.inverse(); }

 private:
  std::optional<Vector2d> placeOf(const Vector3d& point) const {
    const Vector3d seen = toCamera_ * point;
    if (!cameras_.sees(seen)) return std::nullopt;
    return cameras_.project(eye_, seen) + Vector2d(left_, 0);
  }

  Canvas& canvas_;
  const robots::CameraPair cameras_;
  const Eigen::Isometry3d toCamera_;
  const Eye eye_;
  const int left_;
};

/// Draws rings about the line of approach, as wide as the knot may be off there.
void drawCorridor(View& view, const KnotPlacing& placing) {
  constexpr int kRings = 6, kCorners = 36;
  const Vector3d approach = placing.bounds.approach.normalized();
  const Vector3d across = approach.unitOrthogonal(), other = approach.cross(across);
  view.line(placing.target - kShownCorridor * approach, placing.target, kBlue);
  for (int ring = 0; ring < kRings; ++ring) {
    const double before = kShownCorridor * ring / (kRings - 1);
    const double radius = placing.bounds.radius + placing.bounds.slope * before;
    const auto corner = [&](int i) -> Vector3d {
      const double angle = 2 * std::numbers::pi * i / kCorners;
      return placing.target - before * approach +
             radius * (std::cos(angle) * across + std::sin(angle) * other);
    };
    for (int i = 0; i < kCorners; ++i) view.line(corner(i), corner(i + 1), kBlue);
  }
}

void drawView(Canvas& canvas, const KnotPlacing& placing, const KnotRow& row, Eye eye) {
  View view(canvas, row.camera, eye);
  if (!view.paint(row)) return;
  drawCorridor(view, placing);
  view.cross(placing.target, 7, kWhite);
  for (const int node : {0, robots::Strand::kKnot, robots::Strand::kNodes - 1}) {
    view.ring(row.strand.nodes.col(node), 14, kWhite);
  }
  if (!row.sighting.valid) return;
  for (const Vector3d& point : {row.sighting.knot, row.sighting.left_tip, row.sighting.right_tip}) {
    view.cross(view.toScene() * point, 9, kBlack);
  }
}

/// Says where the rows are in a field of the canvas: time to the right, distance upward.
class Axes {
 public:
  Axes(const std::vector<KnotRow>& rows, const Vector3d& target, int width, int top)
      : target_(target),
        begin_(rows.front().strand.stamp),
        seconds_(std::max(secondsOf(rows.back()), 1.0)),
        width_(width),
        top_(top) {
    for (const KnotRow& row : rows) highest_ = std::max(highest_, distance(row));
  }

  double secondsAt(suture::Time time) const { return robots::secondsBetween(begin_, time); }
  double secondsOf(const KnotRow& row) const { return secondsAt(row.strand.stamp); }
  double distance(const KnotRow& row) const { return (row.knot() - target_).norm(); }
  double seconds() const { return seconds_; }
  double highest() const { return highest_; }

  Vector2d at(double seconds, double distance) const {
    return {kMargin + (width_ - 2 * kMargin) * seconds / seconds_,
            top_ + kPlotHeight - kMargin - (kPlotHeight - 2 * kMargin) * distance / highest_};
  }

 private:
  Vector3d target_;
  suture::Time begin_;
  double seconds_, highest_ = 0.002;
  int width_, top_;
};

void fillTimes(Canvas& canvas, const Axes& axes, double from, double to, Colour colour) {
  canvas.fill(axes.at(std::max(from, 0.0), axes.highest()),
              axes.at(std::min(to, axes.seconds()), 0), colour);
}

/// Returns the first of 1, 2, 5, 10 and so on that makes at most 20 steps of `length`.
int stepOf(double length) {
  for (int power = 1;; power *= 10) {
    for (const int step : {1, 2, 5}) {
      if (length <= 20.0 * step * power) return step * power;
    }
  }
}

void drawGrid(Canvas& canvas, const Axes& axes) {
  for (int t = 0; t <= axes.seconds(); t += stepOf(axes.seconds())) {
    canvas.line(axes.at(t, 0), axes.at(t, axes.highest()), kLines);
    canvas.text(axes.at(t, 0) + Vector2d(-4, 18), std::to_string(t), kBlack);
  }
  for (int mm = 0; mm <= 1e3 * axes.highest(); mm += 5) {
    canvas.line(axes.at(0, 1e-3 * mm), axes.at(axes.seconds(), 1e-3 * mm), kLines);
    canvas.text(axes.at(0, 1e-3 * mm) + Vector2d(-28, 4), std::to_string(mm), kBlack);
  }
}

void drawDistance(Canvas& canvas, const Axes& axes, const std::vector<KnotRow>& rows,
                  const std::optional<Outage>& outage) {
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (rows[i].guiding) continue;
    fillTimes(canvas, axes, axes.secondsOf(rows[i - 1]), axes.secondsOf(rows[i]), kGrey);
  }
  if (outage) {
    fillTimes(canvas, axes, axes.secondsAt(outage->broken), axes.secondsAt(outage->mended), kRed);
  }
  canvas.fill(axes.at(0, 0.001), axes.at(axes.seconds(), 0), kGreen);
  drawGrid(canvas, axes);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    canvas.line(axes.at(axes.secondsOf(rows[i - 1]), axes.distance(rows[i - 1])),
                axes.at(axes.secondsOf(rows[i]), axes.distance(rows[i])), kCurve);
  }
  canvas.text(axes.at(0, axes.highest()) + Vector2d(0, -14),
              std::string("distance of the knot from its target, mm, over time, s; ") +
                  "green: within 1 mm; grey: not guided" + (outage ? "; red: cut off" : ""),
              kBlack);
}

}  // namespace

const KnotPlacing& requireKnot(const Plan& plan) {
  if (plan.knot()) return *plan.knot();
  throw suture::SetupError(
      "drawing a picture", "nothing in this topology places a knot",
      "Choose one with a KnotGuide and a KnotRecorder, such as fig3b, or leave --picture "
      "out");
}

void drawKnot(const std::filesystem::path& file, const KnotPlacing& placing,
              const ProcessGraph& graph, const std::optional<Outage>& outage) {
  const std::vector<KnotRow> rows = robots::readKnotRecording(placing.recording).rows;
  if (rows.empty()) {
    throw suture::SetupError("drawing a picture", "the knot was never recorded",
                             "Run for longer: both arms home first, which takes some seconds");
  }
  const robots::CameraPair cameras;
  Canvas canvas(2 * cameras.width, cameras.height + kPlotHeight + kGraphHeight, kWhite);
  drawView(canvas, placing, rows.back(), Eye::Left);
  drawView(canvas, placing, rows.back(), Eye::Right);
  canvas.text(
      {12, cameras.height - 12.0},
      "ring: where it is; black cross: where it was seen; white cross: the target; blue: the "
      "corridor",
      kWhite);
  drawDistance(canvas, Axes(rows, placing.target, 2 * cameras.width, cameras.height), rows, outage);
  drawGraph(canvas, graph, cameras.height + kPlotHeight);
  canvas.write(file);
}

}  // namespace demo
