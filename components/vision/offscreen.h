#pragma once
// Where OpenGL draws without a screen.

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "robot_types/vision.h"

struct osmesa_context;

namespace robots {

/// A framebuffer in memory that Mesa's software renderer fills, with smooth edges. It is made in
/// the thread that draws, and draws in that thread alone.
class Offscreen {
 public:
  /// px. Throws suture::SetupError if Mesa has none.
  Offscreen(int width, int height);

  /// Calls `draw` while OpenGL draws here, and fills all of `image` but its stamp with what it has
  /// drawn: the upper left pixel first. Allocates.
  void draw(const std::function<void()>& draw, ImageFrame& image);

 private:
  struct Closer {
    void operator()(osmesa_context* context) const;
  };

  void makeCurrent();
  void makeFramebuffer();

  const int width_, height_;
  std::unique_ptr<osmesa_context, Closer> context_;
  std::vector<std::uint8_t> pixels_;  // red, green, blue, alpha
  unsigned framebuffer_ = 0;          // of several samples a pixel
};

}  // namespace robots
