#pragma once
// Here OpenGL draws without a screen.

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "robot_types/vision.h"

struct osmesa_context;

namespace robots {

/// These are the rows of a part of an image, from the upper one on; `last` is the first that does
/// not belong to it.
struct Rows {
  int first, last;
};

/// A Square is a part of an image, in px; `left` and `top` are its first column and row.
struct Square {
  int left, top, size;
};

/// One thread: it draws only in the thread in which it was made. An Offscreen is a framebuffer in
/// memory that Mesa's software renderer fills.
class Offscreen {
 public:
  /// The size is in px. Throws suture::SetupError if Mesa cannot make it.
  Offscreen(int width, int height);

  /// Says what to draw where. Smooth edges take several times as long, so `rows` should have only
  /// those rows that need them, and the squares should be small.
  struct Parts {
    std::function<void()> background;  ///< draws the whole image while OpenGL draws here
    std::function<void()> all;         ///< draws the whole image with all that has edges
    Rows rows;                         ///< these have smooth edges, of four samples a pixel
    /// In these each pixel is the mean of sixteen samples, as a sensor adds up the light that falls
    /// on a pixel. A square that is larger than kLargestSquare, or reaches beyond the image, is
    /// drawn as its rows are.
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
