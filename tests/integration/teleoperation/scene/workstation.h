#pragma once
// A master, a slave, the teleoperation between them and a surgeon in one process, and a client to
// ask and command them from the test's thread.

#include <gtest/gtest.h>
#include <suture/base/errors.h>
#include <suture/component/device.h>
#include <suture/manager/manager.h>

#include <chrono>
#include <thread>

#include "arm/arm.suture.h"
#include "integration/teleoperation/scene/driven_arm.h"
#include "support/eventually.h"
#include "surgeon/surgeon.h"
#include "teleop/teleop.h"
#include "teleop/teleoperation.suture.h"

namespace robots::test {

/// Stands for the operator.
class Client : public suture::Device {
 public:
  suture::Required<Arm> master{*this, "Master"};
  suture::Required<Arm> slave{*this, "Slave"};
  suture::Required<Teleoperation> teleop{*this, "Teleoperation"};
};

struct Workstation {
  /// `permit`: how old the slave's of the emergency stop may be, which the test then connects; 0:
  /// none is needed.
  explicit Workstation(const TeleopParameters& parameters, suture::Duration permit = {})
      : psm(permit), teleop(parameters) {
    mtm.addTo(manager, "MTM");
    psm.addTo(manager, "PSM");
    manager.add("Surgeon", surgeon);
    manager.add("Teleop", teleop);
    manager.add("Client", client);
    manager.connect("Teleop/Master", "MTM/Arm");
    manager.connect("Teleop/Slave", "PSM/Arm");
    manager.connect("Surgeon/Master", "MTM/Arm");
    manager.connect("Surgeon/Teleoperation", "Teleop/Teleoperation");
    manager.connect("Client/Master", "MTM/Arm");
    manager.connect("Client/Slave", "PSM/Arm");
    manager.connect("Client/Teleoperation", "Teleop/Teleoperation");
  }
  ~Workstation() { manager.stop(); }

  DrivenMtm mtm;
  DrivenPsm psm;
  Surgeon surgeon{SurgeonParameters{}};
  Teleop teleop;
  Client client;
  suture::Manager manager{"workstation"};
};

/// Returns what the provider answers now; if it does not, a read's default value and a failed test.
template <class Read>
auto ask(Read& read) {
  auto call = read.fresh();
  const auto& sample = call.within(std::chrono::seconds(10));
  EXPECT_TRUE(sample) << suture::toString(sample.error());
  return *sample;
}

/// Returns true once `task` has run `count` more cycles.
inline bool cyclesPass(const suture::Task& task, std::uint64_t count) {
  const std::uint64_t until = task.statistics().cycles.load() + count;
  return suture::eventually([&] { return task.statistics().cycles.load() >= until; });
}

}  // namespace robots::test
