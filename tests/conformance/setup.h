#pragma once
// A provider and a client, connected over the lane under test.

#include <gtest/gtest.h>
#include <suture/manager/manager.h>

#include <memory>
#include <string>
#include <tuple>

#include "conformance/arm.h"
#include "conformance/client.h"
#include "support/eventually.h"
#include "support/temporary_directory.h"

namespace conformance {

enum class LaneUnderTest {
  Local,
  Shm,
  FrameUnix,
  FrameTcp,
  RpcUnix,
  RpcTcp,
  DelayedLocal,
  DelayedShm,
  DelayedFrame,
  DelayedRpc,
  FaultyShm,  ///< delayed, and messages come twice or late, but none is lost
};
enum class ProviderKind { Periodic, EventDriven, Device };
enum class ClientKind { Task, Device };

using Combination = std::tuple<LaneUnderTest, ProviderKind, ClientKind>;

/// Every combination runs every scenario. `arm` and `client` are connected when the scenario
/// begins.
class Conformance : public testing::TestWithParam<Combination> {
 protected:
  Conformance();
  ~Conformance() override;
  void SetUp() override;
  void TearDown() override;

  /// Connects another required interface of the client.
  void connect(const std::string& required, const std::string& provided);

  bool providerIsDevice() const { return std::get<1>(GetParam()) == ProviderKind::Device; }
  bool withinOneProcess() const {
    const LaneUnderTest lane = std::get<0>(GetParam());
    return lane == LaneUnderTest::Local || lane == LaneUnderTest::DelayedLocal;
  }
  bool isDelayed() const {
    const LaneUnderTest lane = std::get<0>(GetParam());
    return lane == LaneUnderTest::DelayedLocal || lane == LaneUnderTest::DelayedShm ||
           lane == LaneUnderTest::DelayedFrame || lane == LaneUnderTest::DelayedRpc || isFaulty();
  }
  bool isFaulty() const { return std::get<0>(GetParam()) == LaneUnderTest::FaultyShm; }
  /// That is asked for. Shared memory nobody has to ask for.
  suture::Lane askedLane() const;
  /// Its name, without the delay.
  std::string expectedLane() const;
  bool runsInCallersThread() const {
    return providerIsDevice() && std::get<0>(GetParam()) == LaneUnderTest::Local;
  }
  bool eventuallyTaken(const std::vector<std::string>& lines) {
    return suture::eventually([&] { return arm->taken() == lines; });
  }
  /// The connection as the client's process sees it.
  std::shared_ptr<suture::Channel> channel() const { return clientManager_->channels().at(0); }

  /// The provided interface that the client's "Arm" is connected to.
  virtual const char* provided() const { return "Arm"; }
  /// The provider's process goes away; its component object stays.
  void stopProvider();

  std::unique_ptr<ArmComponent> arm;
  std::unique_ptr<Client> client;

 private:
  struct Names;

  suture::TemporaryDirectory directory_;
  std::unique_ptr<Names> names_;
  std::unique_ptr<suture::Manager> providerManager_;
  std::unique_ptr<suture::Manager> ownClientManager_;
  suture::Manager* clientManager_ = nullptr;  // the provider's on `local`
};

/// Every lane, every kind of provider, every kind of client.
inline auto allCombinations() {
  return testing::Combine(
      testing::Values(LaneUnderTest::Local, LaneUnderTest::Shm, LaneUnderTest::FrameUnix,
                      LaneUnderTest::FrameTcp, LaneUnderTest::RpcUnix, LaneUnderTest::RpcTcp,
                      LaneUnderTest::DelayedLocal, LaneUnderTest::DelayedShm,
                      LaneUnderTest::DelayedFrame, LaneUnderTest::DelayedRpc,
                      LaneUnderTest::FaultyShm),
      testing::Values(ProviderKind::Periodic, ProviderKind::EventDriven, ProviderKind::Device),
      testing::Values(ClientKind::Task, ClientKind::Device));
}

std::string nameOf(const testing::TestParamInfo<Combination>& info);

inline PoseStamped poseAt(double x) {
  PoseStamped pose;
  pose.pose.translation().x() = x;
  pose.stamp = suture::now();
  pose.valid = true;
  return pose;
}

}  // namespace conformance
