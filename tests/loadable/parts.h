#pragma once
// These are the components of the library.

#include <suture/component/task/event_task.h>
#include <suture/component/task/periodic_task.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

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

struct SUTURE_TYPE() SpindleParameters {
  std::int32_t cycles = 50;                       ///< until it seizes, again and again
  SUTURE_FIELD(capacity(255)) std::string brake;  ///< the file that stands for it
  /// The file that lets it turn until it seizes, and that it takes away then; "": it turns anyway.
  SUTURE_FIELD(capacity(255)) std::string key;
};

/// Its safe state is a closed brake: a line in the file.
class SUTURE_COMPONENT() Spindle final : public suture::PeriodicTask, public Turntable {
 public:
  explicit Spindle(const SpindleParameters& parameters)
      : PeriodicTask({.period = std::chrono::milliseconds(1)}), parameters_(parameters) {}

  void turn(double angle) override { angle_ += angle; }
  double angle() const override { return angle_; }
  void run() override {
    const bool unlocked = parameters_.key.empty() || cycles_ % parameters_.cycles != 0;
    if (!unlocked && !std::filesystem::remove(parameters_.key)) return;
    angle_ += 1;
    if (++cycles_ % parameters_.cycles == 0) throw std::runtime_error("the spindle has seized");
  }

 private:
  void onStart() override { note("running"); }
  void onStop() override { note("stopped"); }
  void onFault() override { note("closed"); }
  void onRestart() override { note("open"); }
  void note(const char* what) const {
    std::ofstream(parameters_.brake, std::ios::app) << what << std::endl;
  }

  const SpindleParameters parameters_;
  double angle_ = 0;
  std::int32_t cycles_ = 0;
  suture::Provided<Turntable> turntable_{*this, "Turntable", *this};
};

}  // namespace loadable
