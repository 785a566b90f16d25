#include "vision/painter.h"

#include <GL/gl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "vision/markers.h"
#include "vision/offscreen.h"
#include "vision/one_thread.h"
#include "vision/solids.h"

namespace robots {
namespace {

using Eigen::Vector3d;

// In m: these sizes are our own, except that of the shaft, which is the 8 mm of da Vinci
// instruments.
constexpr double kStrandRadius = 0.0004, kJawRadius = 0.0006, kShaftRadius = 0.004;
constexpr double kJawLength = 0.009, kShaftLength = 0.08;
constexpr double kGroundReach = 0.2, kFarthest = 1;

// These are the shares of the light. Enough comes from all around that no side of a marker looks
// like something else.
constexpr float kAround = 0.7F, kFromEyes = 0.3F;

/// Sets the view of an eye. OpenGL looks along -z with y upward, and pixels are whole between their
/// edges.
void look(const CameraPair& cameras, Eye eye) {
  constexpr double kNear = CameraPair::kNearest;
  const double x = kNear * cameras.width / 2 / cameras.focal;
  const double y = kNear * cameras.height / 2 / cameras.focal;
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glFrustum(-x, x, -y, y, kNear, kFarthest);
  glMatrixMode(GL_MODELVIEW);
  const Eigen::Affine3d view = Eigen::Scaling(1.0, -1.0, -1.0) * cameras.inFrameOf(eye);
  glLoadMatrixd(view.data());
}

/// Sets the light of the endoscope, which is between the eyes.
void light(const CameraPair& cameras) {
  const std::array<float, 4> around{kAround, kAround, kAround, 1};
  const std::array<float, 4> fromEyes{kFromEyes, kFromEyes, kFromEyes, 1};
  const std::array<float, 4> place{static_cast<float>(cameras.baseline / 2), 0, 0, 1};
  glLightModelfv(GL_LIGHT_MODEL_AMBIENT, around.data());
  glLightfv(GL_LIGHT0, GL_DIFFUSE, fromEyes.data());
  glLightfv(GL_LIGHT0, GL_POSITION, place.data());
  for (const GLenum each :
       {GL_DEPTH_TEST, GL_CULL_FACE, GL_LIGHTING, GL_LIGHT0, GL_COLOR_MATERIAL, GL_NORMALIZE})
    glEnable(each);
}

void drawStrand(const Solids& solids, const Strand::Nodes& strand) {
  for (int node = 1; node < Strand::kNodes; ++node) {
    solids.tube(strand.col(node - 1), strand.col(node), kStrandRadius, kStrandColour);
  }
}

/// This is an instrument, which comes from the side that is away from the other tip.
struct Instrument {
  Instrument(const Vector3d& its, const Vector3d& other)
      : tip(its),
        wrist(tip + kJawLength * (tip - other).normalized()),
        end(wrist + kShaftLength * (tip - other).normalized()) {}

  Vector3d tip, wrist, end;
};

std::array<Instrument, 2> instrumentsOf(const View& view) {
  const Vector3d left = view.strand.col(0), right = view.strand.col(Strand::kNodes - 1);
  return {Instrument(left, right), Instrument(right, left)};
}

void drawGround(const Solids& solids, const View& view) {
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  solids.ground(view.tissue, view.strand.col(Strand::kKnot), kGroundReach, kTissueColour);
}

void drawThings(const Solids& solids, const View& view) {
  drawStrand(solids, view.strand);
  for (const Instrument& one : instrumentsOf(view)) {
    solids.tube(one.tip, one.wrist, kJawRadius, kMetalColour);
    solids.ball(one.wrist, kShaftRadius, kMetalColour);
    solids.tube(one.wrist, one.end, kShaftRadius, kMetalColour);
  }
  const auto mark = [&](Marker marker, int node) {
    solids.ball(view.strand.col(node), radiusOf(marker), colourOf(marker));
  };
  mark(Marker::LeftTip, 0);
  mark(Marker::Knot, Strand::kKnot);
  mark(Marker::RightTip, Strand::kNodes - 1);
}

/// Returns the rows where anything but ground is: all rows, if a part of that is beside or behind
/// the camera.
Rows rowsOfThings(const CameraPair& cameras, Eye eye, const View& view) {
  double upper = cameras.height, lower = 0;
  const auto add = [&](const Vector3d& centre) {
    const double z = (cameras.inFrameOf(eye) * centre).z();
    if (z < CameraPair::kNearest + kShaftRadius) {
      upper = 0;
      lower = cameras.height;
      return;
    }
    const double row = cameras.project(eye, centre).y();
    const double reach = cameras.focal * kShaftRadius / (z - kShaftRadius) + 2;
    upper = std::min(upper, row - reach);
    lower = std::max(lower, row + reach);
  };
  for (int node = 0; node < Strand::kNodes; ++node) add(view.strand.col(node));
  for (const Instrument& one : instrumentsOf(view)) add(one.end);
  return {static_cast<int>(std::clamp<double>(upper, 0, cameras.height)),
          static_cast<int>(std::clamp<double>(lower, 0, cameras.height))};
}

/// Returns a square about each marker, including what the blur of the image brings from beside it.
std::vector<Square> squaresOfMarkers(const CameraPair& cameras, Eye eye, const View& view) {
  constexpr double kBlur = 4;  // px, and more than it reaches
  std::vector<Square> squares;
  const auto add = [&](Marker marker, int node) {
    const Vector3d centre = view.strand.col(node);
    const double z = (cameras.inFrameOf(eye) * centre).z();
    if (z < CameraPair::kNearest + radiusOf(marker)) return;
    const double reach = cameras.focal * radiusOf(marker) / (z - radiusOf(marker)) + kBlur;
    const Eigen::Vector2d corner = (cameras.project(eye, centre).array() - reach).floor();
    if (!(corner.array().abs() < cameras.width).all()) return;
    squares.push_back({static_cast<int>(corner.x()), static_cast<int>(corner.y()),
                       static_cast<int>(std::ceil(2 * reach)) + 1});
  };
  add(Marker::LeftTip, 0);
  add(Marker::Knot, Strand::kKnot);
  add(Marker::RightTip, Strand::kNodes - 1);
  return squares;
}

}  // namespace

View seenFrom(const Eigen::Isometry3d& camera, const Strand::Nodes& strand, double tissue) {
  const Eigen::Isometry3d toCamera = camera.inverse();
  const Vector3d upward = toCamera.linear() * Vector3d::UnitZ();
  return {toCamera * strand, {upward, toCamera * Vector3d(0, 0, tissue)}};
}

class Painter::Studio {
 public:
  explicit Studio(const CameraPair& cameras) : offscreen(cameras.width, cameras.height) {}

  Offscreen offscreen;
  const Solids solids;
};

Painter::Painter(const CameraPair& cameras) : cameras_(cameras) { workInOneThread(); }

Painter::~Painter() = default;

void Painter::paint(Eye eye, const View& view, ImageFrame& image) {
  if (!studio_) studio_ = std::make_unique<Studio>(cameras_);
  const auto ground = [&] {
    look(cameras_, eye);
    light(cameras_);
    drawGround(studio_->solids, view);
  };
  const auto all = [&] {
    ground();
    drawThings(studio_->solids, view);
  };
  studio_->offscreen.draw({.background = ground,
                           .all = all,
                           .rows = rowsOfThings(cameras_, eye, view),
                           .squares = squaresOfMarkers(cameras_, eye, view)},
                          image);
}

}  // namespace robots
