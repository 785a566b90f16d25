#include "bench/image_viewer.h"

namespace bench {

void ImageViewer::run() {
  const auto pair = camera_.images();
  if (!pair || pair->left.stamp == lastImage_) return;
  lastImage_ = pair->left.stamp;
  ++images_;
}

}  // namespace bench
