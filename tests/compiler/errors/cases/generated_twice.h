#pragma once
#include <suture/annotate.h>
namespace demo {
class SUTURE_INTERFACE() Camera {
 public:
  SUTURE_COMMAND() virtual void light_set(double value) = 0;
  SUTURE_EVENT() suture::EventOf<int, int> light_changed;
};
class SUTURE_INTERFACE() CameraLight {
 public:
  SUTURE_COMMAND() virtual void set(double value) = 0;
  SUTURE_EVENT() suture::EventOf<int, int> changed;
};
}  // namespace demo
