#include "rt/scenarios/setup.h"

#include <suture/component/channel/channel.h>
#include <suture/loop/control_thread.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>

#include <optional>

namespace scenarios {
namespace {

constexpr const char* kKinds[] = {"Device",     "Periodic",     "Continuous",
                                  "FromSignal", "FromCallback", "Guest"};

suture::Lane askedLane(LaneUnderTest lane) {
  switch (lane) {
    case LaneUnderTest::Frame: return suture::Lane::Frame;
    case LaneUnderTest::Rpc: return suture::Lane::Rpc;
    default: return suture::Lane::Auto;
  }
}

}  // namespace

/// Holds one process, or two and their global manager: two managers in one process share nothing
/// but the sockets.
struct Scenario::Processes {
  explicit Processes(const std::string& socket)
      : control(std::in_place),
        names(std::in_place, *control, "unix:" + socket),
        servers(std::in_place, "servers", names->address()),
        clients(std::in_place, "clients", names->address()) {}
  Processes() : servers(std::in_place, "alone") {}

  std::optional<suture::loop::ControlThread> control;
  std::optional<suture::GlobalManager> names;
  std::optional<suture::Manager> servers, clients;

  suture::Manager& ofClient() { return clients ? *clients : *servers; }
};

Scenario::Scenario()
    : server(makeEnd(std::get<1>(GetParam()))), client(makeEnd(std::get<2>(GetParam()))) {}

Scenario::~Scenario() = default;

void Scenario::SetUp() {
  const bool local = std::get<0>(GetParam()) == LaneUnderTest::Local;
  processes_ = local ? std::make_unique<Processes>()
                     : std::make_unique<Processes>(directory_.file("manager.sock"));
  suture::Manager& servers = *processes_->servers;
  suture::Manager& clients = processes_->ofClient();
  server->addTo(servers, "Server");
  client->addTo(clients, "Client");
  servers.start();
  if (!local) clients.start();
  server->begin();
  client->begin();
  const suture::Lane lane = askedLane(std::get<0>(GetParam()));
  clients.connect("Client/Used", local ? "Server/Served" : "servers:Server/Served", {.lane = lane});
  servers.connect("Server/Used", local ? "Client/Served" : "clients:Client/Served", {.lane = lane});
  const std::string expected = local                        ? "local"
                               : lane == suture::Lane::Auto ? "shm"
                                                            : toString(lane);
  for (const auto& channel : clients.channels()) EXPECT_EQ(channel->lane, expected);
  for (End* end : {client.get(), server.get()}) ASSERT_TRUE(end->awaitConnection());
}

void Scenario::TearDown() {
  if (processes_ == nullptr) return;
  client->end();
  server->end();
  processes_->ofClient().stop();
  processes_->servers->stop();
}

std::string nameOf(const testing::TestParamInfo<Combination>& info) {
  const auto [lane, server, client] = info.param;
  static constexpr const char* kLanes[] = {"Local", "Shm", "Frame", "Rpc"};
  return std::string(kLanes[static_cast<int>(lane)]) + "To" + kKinds[static_cast<int>(server)] +
         "From" + kKinds[static_cast<int>(client)];
}

}  // namespace scenarios
