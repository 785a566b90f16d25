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

/// A framebuffer in memory that Mesa's software renderer fills. It is made in the thread that
/// draws, and draws in that thread alone.
class Offscreen {
 public:
  /// px. Throws suture::SetupError if Mesa has none.
  Offscreen(int width, int height);

  /// Fills all of `image` but its stamp, the upper left pixel first, with what `background` draws
  /// while OpenGL draws here, and the rows with what `all` draws, with smooth edges. To have those
  /// takes several times as long, so the rows are to be no more than need them. Allocates.
  void draw(const std::function<void()>& background, const std::function<void()>& all, Rows rows,
            ImageFrame& image);

 private:
  struct Closer {
    void operator()(osmesa_context* context) const;
  };

  void makeCurrent();
  void makeFramebuffer();
  void drawSmooth(const std::function<void()>& all, Rows rows);
  void copyTo(ImageFrame& image) const;

  const int width_, height_;
  std::unique_ptr<osmesa_context, Closer> context_;
  std::vector<std::uint8_t> pixels_;  // red, green, blue, alpha
  unsigned framebuffer_ = 0;          // of several samples a pixel
};

}  // namespace robots
