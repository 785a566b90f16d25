#include "vision/one_thread.h"

#include <cstdlib>
#include <opencv2/core.hpp>

namespace robots {

void workInOneThread() {
  ::setenv("LP_NUM_THREADS", "0", 1);
  ::setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
  cv::setNumThreads(1);
}

}  // namespace robots
