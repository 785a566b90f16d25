#pragma once
// This component does nothing by itself.

#include <suture/component/task/event_task.h>

#include "bench/sample_loop.suture.h"

namespace bench {

/// Serves, and sleeps until a client asks for something.
class Sleeper final : public suture::EventTask, public SampleServer {
 public:
  ~Sleeper() override { stop(); }
  void put(const robots::PoseSample&) override {}
  void bounce(const robots::PoseSample&) override {}
  robots::PoseSample value() const override { return {}; }
  void run() override {}

 private:
  suture::Provided<SampleServer> provided_{*this, "Samples", *this};
};

}  // namespace bench
