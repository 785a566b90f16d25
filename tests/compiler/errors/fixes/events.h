#pragma once
#include <suture/annotate.h>
namespace demo {
struct SUTURE_TYPE() Pose {
  double rotation[4] = {}, position[3] = {};
};
class SUTURE_INTERFACE() Contract {
 public:
  virtual ~Contract() = default;
  SUTURE_EVENT() suture::EventOf<void> stopped;
};
}  // namespace demo
