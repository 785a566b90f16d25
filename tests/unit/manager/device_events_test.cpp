// A device's own thread handles these events whenever it likes.

#include <gtest/gtest.h>
#include <suture/component/device.h>
#include <suture/manager/manager.h>

#include "reference/still_arm.h"

namespace suture {
namespace {

struct PatientEmitter final : Device, StillArm {
  Provided<reference::ArmLike> port{*this, "Arm", *this};
};

struct LeavingListener final : Device {
  Required<reference::ArmLike> arm{*this, "Slave"};
};

TEST(DeviceEvents, AnEndedConnectionsEventsAreUnheard) {
  PatientEmitter arm;
  LeavingListener listener;
  Manager manager("robot");
  int heard = 0;
  listener.arm.on().stopped([&] {
    ++heard;
    manager.disconnect("Teleop/Slave");
    EXPECT_EQ(listener.arm.unusable(), Errc::NotConnected);
  });
  manager.add("PSM", arm);
  manager.add("Teleop", listener);
  manager.connect("Teleop/Slave", "PSM/Arm");
  manager.start();
  EXPECT_TRUE(listener.processEvents());
  EXPECT_TRUE(arm.port.emit().stopped());
  EXPECT_TRUE(arm.port.emit().stopped());
  listener.processEvents();
  EXPECT_EQ(heard, 1);
  manager.stop();
}

}  // namespace
}  // namespace suture
