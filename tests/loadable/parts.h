#pragma once
// The components of the library.

#include <suture/component/event_task.h>
#include <suture/component/periodic_task.h>

#include <chrono>
#include <stdexcept>

#include "loadable/turntable.suture.h"

namespace loadable {

struct SUTURE_TYPE() PlatterParameters {
  double angle = 0;
};

class SUTURE_COMPONENT() Platter final : public suture::EventTask, public Turntable {
 public:
  explicit Platter(const PlatterParameters& parameters) : angle_(parameters.angle) {}

  void turn(double angle) override {
    if (angle < 0) throw std::runtime_error("it turns one way only");
    angle_ += angle;
  }
  double angle() const override { return angle_; }
  void run() override {}

 private:
  double angle_;
  suture::Provided<Turntable> turntable_{*this, "Turntable", *this};
};

class SUTURE_COMPONENT() Hand final : public suture::PeriodicTask {
 public:
  Hand() : PeriodicTask({.period = std::chrono::milliseconds(1)}) {}

  void run() override { (void)turntable_.turn(0.1); }

 private:
  suture::Required<Turntable> turntable_{*this, "Turntable"};
  SUTURE_REQUIRED(optional()) suture::Required<Turntable> other_{*this, "Other"};
};

}  // namespace loadable
