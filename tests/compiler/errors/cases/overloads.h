#pragma once
#include <suture/annotate.h>
namespace demo {
class SUTURE_INTERFACE() Stage {
 public:
  SUTURE_COMMAND() virtual void move(int steps) = 0;
  SUTURE_COMMAND(name("moveMetres")) virtual void move(double metres) = 0;
  SUTURE_COMMAND() virtual double gain() const = 0;
  SUTURE_COMMAND(name("setGain")) virtual void gain(double value) = 0;
  // A method that is no command may share its name.
  SUTURE_COMMAND() virtual void turn(double angle) = 0;
  void turn(int degrees);
};
}  // namespace demo
