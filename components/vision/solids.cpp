#include "vision/solids.h"

#include <GL/gl.h>

#include <cmath>
#include <numbers>

namespace robots {
namespace {

using Eigen::Vector3d;

// With this many corners about an axis the outline is round to a hundredth of a pixel.
constexpr int kCorners = 24, kTubeCorners = 12;
constexpr int kGround = 24;  // squares along a side, each lit at its corners

Vector3d onCircle(int corner, int corners) {
  const double angle = 2 * std::numbers::pi * corner / corners;
  return {std::cos(angle), std::sin(angle), 0};
}

/// Returns a corner of a ring; the rings go from one pole to the other, and are half as many as
/// they have corners.
Vector3d onBall(int ring, int corner) {
  const double angle = 2 * std::numbers::pi * ring / kCorners;
  Vector3d point = std::sin(angle) * onCircle(corner, kCorners);
  point.z() = std::cos(angle);
  return point;
}

void vertex(const Vector3d& normal, const Vector3d& point) {
  glNormal3dv(normal.data());
  glVertex3dv(point.data());
}

template <class Draw>
unsigned listOf(const Draw& draw) {
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  draw();
  glEndList();
  return list;
}

void unitBall() {
  for (int ring = 0; ring < kCorners / 2; ++ring) {
    glBegin(GL_TRIANGLE_STRIP);
    for (int corner = 0; corner <= kCorners; ++corner) {
      for (const Vector3d& point : {onBall(ring, corner), onBall(ring + 1, corner)}) {
        vertex(point, point);
      }
    }
    glEnd();
  }
}

void unitTube() {
  glBegin(GL_TRIANGLE_STRIP);
  for (int corner = 0; corner <= kTubeCorners; ++corner) {
    const Vector3d side = onCircle(corner, kTubeCorners);
    vertex(side, side + Vector3d::UnitZ());
    vertex(side, side);
  }
  glEnd();
}

void callAt(unsigned list, const Eigen::Affine3d& place, Colour colour) {
  glColor3ubv(colour.data());
  glPushMatrix();
  glMultMatrixd(place.data());
  glCallList(list);
  glPopMatrix();
}

/// Returns the share of its brightness that the ground has at `x` and `y` m: it has folds of some
/// millimetres.
double shade(double x, double y) {
  return 0.9 + 0.06 * std::sin(260 * x + 2 * std::sin(150 * y)) + 0.04 * std::sin(410 * y - 90 * x);
}

}  // namespace

Solids::Solids() : ball_(listOf(unitBall)), tube_(listOf(unitTube)) {}

void Solids::ball(const Vector3d& centre, double radius, Colour colour) const {
  callAt(ball_, Eigen::Translation3d(centre) * Eigen::Scaling(radius), colour);
}

void Solids::tube(const Vector3d& from, const Vector3d& to, double radius, Colour colour) const {
  const Vector3d along = to - from;
  callAt(tube_,
         Eigen::Translation3d(from) * Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), along) *
             Eigen::Scaling(radius, radius, along.norm()),
         colour);
}

void Solids::ground(const Eigen::Hyperplane<double, 3>& plane, const Vector3d& centre, double reach,
                    Colour colour) const {
  const Vector3d middle = plane.projection(centre);
  const Vector3d across = plane.normal().unitOrthogonal(), other = plane.normal().cross(across);
  const auto corner = [&](int row, int column) {
    const double x = reach * (2.0 * column / kGround - 1), y = reach * (2.0 * row / kGround - 1);
    const double light = shade(x, y) / 255;
    glColor3d(light * colour[0], light * colour[1], light * colour[2]);
    vertex(plane.normal(), middle + x * across + y * other);
  };
  for (int row = 0; row < kGround; ++row) {
    glBegin(GL_TRIANGLE_STRIP);
    for (int column = 0; column <= kGround; ++column) {
      corner(row + 1, column);
      corner(row, column);
    }
    glEnd();
  }
}

}  // namespace robots
