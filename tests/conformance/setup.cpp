#include "conformance/setup.h"

#include <suture/manager/global_manager.h>
#include <suture/transport/rpc/control_thread.h>
#include <unistd.h>

#include <cstdlib>

#include "support/eventually.h"

namespace conformance {
namespace {

std::unique_ptr<ArmComponent> makeArm(ProviderKind kind) {
  using namespace std::chrono_literals;
  switch (kind) {
    case ProviderKind::Periodic:
      return std::make_unique<ArmTask<suture::PeriodicTask>>(
          suture::PeriodicOptions{.period = 1ms});
    case ProviderKind::EventDriven:
      return std::make_unique<ArmTask<suture::EventTask>>(suture::EventOptions{});
    case ProviderKind::Device: return std::make_unique<ArmDevice>();
  }
  return nullptr;
}

std::unique_ptr<Client> makeClient(ClientKind kind) {
  if (kind == ClientKind::Task) return std::make_unique<TaskClient>();
  return std::make_unique<DeviceClient>();
}

}  // namespace

/// A global manager of the test's own.
struct Conformance::Names {
  explicit Names(const std::string& address) : global(control, address) {}
  suture::rpc::ControlThread control;
  suture::GlobalManager global;
};

Conformance::Conformance()
    : arm(makeArm(std::get<1>(GetParam()))), client(makeClient(std::get<2>(GetParam()))) {
  // Seconds of the past, however long a scenario takes.
  for (suture::ProvidedBase* one : arm->component().provided()) one->keepState({.rows = 4096});
}

// Two managers in one process are two processes to each other: nothing is shared but the sockets.
void Conformance::SetUp() {
  const LaneUnderTest lane = std::get<0>(GetParam());
  if (withinOneProcess()) {
    providerManager_ = std::make_unique<suture::Manager>("alone");
    clientManager_ = providerManager_.get();
  } else {
    const bool tcp = lane == LaneUnderTest::RpcTcp || lane == LaneUnderTest::FrameTcp;
    names_ = std::make_unique<Names>(tcp ? "tcp://127.0.0.1:0"
                                         : "unix:" + directory_.file("manager.sock"));
    const std::string& address = names_->global.address();
    providerManager_ = std::make_unique<suture::Manager>("provider", address);
    ownClientManager_ = std::make_unique<suture::Manager>("client", address);
    clientManager_ = ownClientManager_.get();
  }
  providerManager_->add("PSM", arm->component());
  clientManager_->add("Console", client->component());
  providerManager_->start();
  if (ownClientManager_ != nullptr) ownClientManager_->start();
  connect("Arm", provided());
}

suture::Lane Conformance::askedLane() const {
  switch (std::get<0>(GetParam())) {
    case LaneUnderTest::FrameUnix:
    case LaneUnderTest::FrameTcp:
    case LaneUnderTest::DelayedFrame: return suture::Lane::Frame;
    case LaneUnderTest::RpcUnix:
    case LaneUnderTest::RpcTcp:
    case LaneUnderTest::DelayedRpc: return suture::Lane::Rpc;
    default: return suture::Lane::Auto;
  }
}

std::string Conformance::expectedLane() const {
  if (withinOneProcess()) return "local";
  return askedLane() == suture::Lane::Auto ? "shm" : toString(askedLane());
}

void Conformance::connect(const std::string& required, const std::string& provided) {
  const std::chrono::milliseconds each(isDelayed() ? 2 : 0);
  suture::FaultPlan faults;
  if (isFaulty()) faults = {.seed = 1, .duplicate = 0.3, .delay = 0.1};
  faults.delayLength = std::chrono::milliseconds(3);
  clientManager_->connect("Console/" + required,
                          (withinOneProcess() ? "PSM/" : "provider:PSM/") + provided, askedLane(),
                          suture::Manager::kDefaultPatience,
                          {.commands = each, .answers = each, .faults = faults});
  const auto with = [&](const std::function<void(Arm&)>& work) {
    if (required == "Gripper") return client->withGripper(work);
    client->with(work);
  };
  // A client that is in a cycle already takes the connection over in its next one.
  ASSERT_TRUE(suture::eventually([&] {
    bool connected = false;
    with([&](Arm& remote) { connected = remote.connected(); });
    return connected;
  }));
  // A task sends its events to a new client from its next cycle on: the one that answers a command.
  bool answered = false;
  with([&](Arm& remote) {
    answered = remote.distance.start({}).within(std::chrono::seconds(5)).has_value();
  });
  ASSERT_TRUE(answered);
}

void Conformance::TearDown() {
  arm->gate.open();
  if (ownClientManager_ != nullptr) ownClientManager_->stop();
  if (providerManager_ != nullptr) providerManager_->stop();
}

Conformance::~Conformance() = default;

void Conformance::stopProvider() {
  // On `local` both live in one manager, and only the provider's task is to end.
  if (!withinOneProcess()) return providerManager_->stop();
  dynamic_cast<suture::Task&>(arm->component()).stop();
}

std::string nameOf(const testing::TestParamInfo<Combination>& info) {
  static constexpr const char* kLanes[] = {
      "Local",        "Shm",        "FrameUnix",    "FrameTcp",   "RpcUnix",  "RpcTcp",
      "DelayedLocal", "DelayedShm", "DelayedFrame", "DelayedRpc", "FaultyShm"};
  static constexpr const char* kProviders[] = {"Periodic", "EventDriven", "Device"};
  static constexpr const char* kClients[] = {"Task", "Device"};
  const auto [lane, provider, client] = info.param;
  return std::string(kLanes[static_cast<int>(lane)]) + "To" +
         kProviders[static_cast<int>(provider)] + "From" + kClients[static_cast<int>(client)];
}

}  // namespace conformance
