#pragma once
// A provider and a client, connected over the lane under test.

#include <gtest/gtest.h>
#include <suture/manager/manager.h>

#include <functional>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "conformance/client.h"
#include "conformance/provider.h"
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
enum class ClientKind { Task, Device };

using Combination = std::tuple<LaneUnderTest, ProviderKind, ClientKind, Where>;

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
  /// Then nothing crosses a wire.
  bool shareManager() const {
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

  std::unique_ptr<Provider> arm;
  std::unique_ptr<Client> client;

 private:
  struct Names;

  Where where() const { return std::get<3>(GetParam()); }
  std::string managerAddress() const;
  void expectWhereItBelongs() const;

  suture::TemporaryDirectory directory_;
  std::unique_ptr<Names> names_;
  std::unique_ptr<suture::Manager> ownClientManager_;
  suture::Manager* clientManager_ = nullptr;  // the provider's on `local`
};

/// In one process: every lane, every kind of provider, every kind of client. In two, and on two
/// machines: every lane that there is between them, and every kind of provider, of one client each.
std::vector<Combination> allCombinations();
/// Those of them for which `keep` says so.
std::vector<Combination> combinations(const std::function<bool(LaneUnderTest, ProviderKind)>& keep);

std::string nameOf(const testing::TestParamInfo<Combination>& info);

inline PoseStamped poseAt(double x) {
  PoseStamped pose;
  pose.pose.translation().x() = x;
  pose.stamp = suture::now();
  pose.valid = true;
  return pose;
}

}  // namespace conformance
