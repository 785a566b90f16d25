#pragma once
// Where OpenGL draws without a screen.

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "robot_types/vision.h"

struct osmesa_context;

namespace robots {

/// Rows of an image, from the upper one on; `last` is the first that is not among them.
struct Rows {
  int first, last;
};

/// A part of an image, px; `left` and `top` are its first column and row.
struct Square {
  int left, top, size;
};

/// A framebuffer in memory that Mesa's software renderer fills. It is made in the thread that
/// draws, and draws in that thread alone.
class Offscreen {
 public:
  /// px. Throws suture::SetupError if Mesa has none.
  Offscreen(int width, int height);

  /// What to draw where. To have smooth edges takes several times as long, so the rows are to be no
  /// more than need them, and the squares small.
  struct Parts {
    std::function<void()> background;  ///< draws the whole image while OpenGL draws here
    std::function<void()> all;         ///< draws it too, with all that has edges
    Rows rows;                         ///< have smooth edges, of four samples a pixel
    /// These have the light of each pixel as a sensor adds it up, of sixteen samples. One that is
    /// larger than kLargestSquare, or reaches beyond the image, is as its rows are.
    std::vector<Square> squares;
  };
  static constexpr int kLargestSquare = 64;  ///< px

  /// Fills all of `image` but its stamp, the upper left pixel first. Allocates.
  void draw(const Parts& parts, ImageFrame& image);

 private:
  struct Closer {
    void operator()(osmesa_context* context) const;
  };

  void makeCurrent();
  unsigned makeFramebuffer(int width, int height);
  bool isPossible(const Square& square) const;
  std::vector<std::uint8_t> drawExact(const std::function<void()>& all, const Square& square);
  void drawSmooth(const std::function<void()>& all, Rows rows);
  void copyTo(ImageFrame& image) const;

  const int width_, height_;
  std::unique_ptr<osmesa_context, Closer> context_;
  std::vector<std::uint8_t> pixels_;  // red, green, blue, alpha
  unsigned smooth_ = 0, exact_ = 0;   // framebuffers of several samples a pixel
};

}  // namespace robots
