#include "knot_picture.h"

#include <suture/base/errors.h>

#include <algorithm>
#include <chrono>
#include <vector>

#include "canvas.h"
#include "recorder/knot_recording.h"
#include "strand/strand.h"
#include "vision/painter.h"

namespace demo {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using robots::Colour;
using robots::Eye;
using robots::KnotRow;

constexpr Colour kWhite{255, 255, 255}, kBlack{0, 0, 0}, kBlue{0, 60, 255}, kGreen{190, 235, 190},
    kGrey{225, 225, 225}, kLines{200, 200, 200}, kCurve{160, 0, 60};
constexpr int kPlotHeight = 240, kMargin = 12;  // px
constexpr double kNoise = 3;                    // of 255, as the endoscope has it
constexpr double kShownLine = 0.03;             // m of the line of approach

bool seesAll(const robots::CameraPair& cameras, const robots::Strand::Nodes& nodes) {
  for (int node = 0; node < robots::Strand::kNodes; ++node) {
    if (!cameras.sees(nodes.col(node))) return false;
  }
  return true;
}

void drawView(Canvas& canvas, const KnotPlacing& placing, const KnotRow& row, Eye eye) {
  const robots::CameraPair cameras;
  const Eigen::Isometry3d toCamera = row.camera.inverse();
  const robots::Strand::Nodes strand = toCamera * row.strand.nodes;
  if (!seesAll(cameras, strand)) return;
  robots::ImageFrame image;
  robots::Painter(cameras, kNoise).paint(eye, strand, image);
  const int left = eye == Eye::Left ? 0 : cameras.width;
  canvas.put(image, left, 0);

  const auto onCanvas = [&](const Vector3d& point) -> Vector2d {
    return cameras.project(eye, point) + Vector2d(left, 0);
  };
  const auto cross = [&](const Vector3d& point, double size, Colour colour) {
    if (cameras.sees(point)) canvas.cross(onCanvas(point), size, colour);
  };
  const Vector3d target = toCamera * placing.target;
  const Vector3d before = target - toCamera.linear() * placing.approach.normalized() * kShownLine;
  if (cameras.sees(before) && cameras.sees(target)) {
    canvas.line(onCanvas(before), onCanvas(target), kBlue);
  }
  cross(target, 6, kWhite);
  for (const int node : {0, robots::Strand::kKnot, robots::Strand::kNodes - 1}) {
    canvas.ring(onCanvas(strand.col(node)), 14, kWhite);
  }
  if (!row.sighting.valid) return;
  for (const Vector3d& point : {row.sighting.knot, row.sighting.left_tip, row.sighting.right_tip}) {
    cross(point, 9, kBlack);
  }
}

/// Where the rows are in a field of the canvas: time to the right, distance upward.
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

  double secondsOf(const KnotRow& row) const {
    return std::chrono::duration<double>(row.strand.stamp - begin_).count();
  }
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

void drawDistance(Canvas& canvas, const Axes& axes, const std::vector<KnotRow>& rows) {
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (rows[i].guiding) continue;
    const Vector2d from = axes.at(axes.secondsOf(rows[i - 1]), axes.highest());
    const Vector2d to = axes.at(axes.secondsOf(rows[i]), 0);
    canvas.fill(static_cast<int>(from.x()), static_cast<int>(from.y()),
                static_cast<int>(to.x()) + 1, static_cast<int>(to.y()), kGrey);
  }
  const Vector2d upper = axes.at(0, 0.001), lower = axes.at(axes.seconds(), 0);
  canvas.fill(static_cast<int>(upper.x()), static_cast<int>(upper.y()), static_cast<int>(lower.x()),
              static_cast<int>(lower.y()), kGreen);
  for (double t = 0; t <= axes.seconds(); t += 1) {
    canvas.line(axes.at(t, 0), axes.at(t, axes.highest()), kLines);
  }
  for (double distance = 0; distance <= axes.highest(); distance += 0.005) {
    canvas.line(axes.at(0, distance), axes.at(axes.seconds(), distance), kLines);
  }
  for (std::size_t i = 1; i < rows.size(); ++i) {
    canvas.line(axes.at(axes.secondsOf(rows[i - 1]), axes.distance(rows[i - 1])),
                axes.at(axes.secondsOf(rows[i]), axes.distance(rows[i])), kCurve);
  }
}

}  // namespace

const KnotPlacing& requireKnot(const Plan& plan) {
  if (plan.knot()) return *plan.knot();
  throw suture::SetupError("drawing a picture", "nothing in this topology places a knot",
                           "Use --topology fig3b, or leave --picture out");
}

void drawKnot(const std::filesystem::path& file, const KnotPlacing& placing) {
  const std::vector<KnotRow> rows = robots::readKnotRecording(placing.recording);
  if (rows.empty()) {
    throw suture::SetupError("drawing a picture", "the knot was never recorded",
                             "Run for longer: both arms home first, which takes some seconds");
  }
  const robots::CameraPair cameras;
  Canvas canvas(2 * cameras.width, cameras.height + kPlotHeight, kWhite);
  drawView(canvas, placing, rows.back(), Eye::Left);
  drawView(canvas, placing, rows.back(), Eye::Right);
  drawDistance(canvas, Axes(rows, placing.target, 2 * cameras.width, cameras.height), rows);
  canvas.write(file);
}

}  // namespace demo
