// Connecting members: the C++ compiler compares the contracts.

#include <gtest/gtest.h>
#include <suture/component/channel/channel.h>
#include <suture/component/device.h>
#include <suture/manager/manager.h>

#include "reference/gripper_arm.suture.h"
#include "reference/still_arm.h"
#include "support/refusal.h"

namespace suture {
namespace {

using reference::ArmLike;
using reference::GripperArm;

struct DeviceArm final : Device {
  StillArm still;
  Provided<ArmLike> arm{*this, "Arm", still};
};

struct TypedClient final : Device {
  Required<ArmLike> arm{*this, "Arm"};
};

template <class Wanted, class Offered>
concept Connects = requires(Manager manager, Required<Wanted>& required,
                            Provided<Offered>& provided) {
  manager.connect(required, provided);
};
static_assert(Connects<ArmLike, ArmLike>);
static_assert(Connects<ArmLike, GripperArm>, "it derives from the other");
static_assert(!Connects<GripperArm, ArmLike>);

TEST(TypedConnect, ConnectsTwoMembers) {
  DeviceArm arm;
  TypedClient client;
  Manager manager("here");
  manager.add("PSM", arm);
  manager.add("Console", client);
  manager.start();
  manager.connect(client.arm, arm.arm);
  EXPECT_TRUE(client.arm.hold());
  EXPECT_EQ(arm.still.holds, 1);
  EXPECT_EQ(manager.channels().at(0)->name(), "here:Console/Arm -> here:PSM/Arm");
  EXPECT_NE(refusal([&] { manager.connect(client.arm, arm.arm); }).find("already connected"),
            std::string::npos);
}

TEST(TypedConnect, RefusesWhatHasNotBeenAddedHere) {
  DeviceArm arm, elsewhere;
  TypedClient client;
  Manager manager("here"), other("there");
  manager.add("PSM", arm);
  other.add("PSM", elsewhere);
  EXPECT_EQ(refusal([&] { manager.connect(client.arm, arm.arm); }),
            "connecting '(unnamed)/Arm': its component does not belong to process 'here'. Add it "
            "with add() first");
  manager.add("Console", client);
  EXPECT_NE(refusal([&] { manager.connect(client.arm, elsewhere.arm); }).find("'PSM/Arm'"),
            std::string::npos)
      << "of the same name, but another";
}

}  // namespace
}  // namespace suture
