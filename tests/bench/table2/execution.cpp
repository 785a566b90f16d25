#include "bench/table2/execution.h"

#include <suture/component/device.h>
#include <suture/manager/manager.h>

#include "bench/loop.suture.h"
#include "bench/table2/codec.h"
#include "bench/table2/sample_pose.h"
#include "bench/timed_loops.h"

namespace bench {
namespace {

class ServerDevice final : public suture::Device, public LoopServer {
 public:
  void put(const robots::PosePrm& value) override { last_ = &value; }
  void bounce(const robots::PosePrm&) override {}
  const robots::PosePrm& value() const override { return value_; }

 private:
  suture::Provided<LoopServer> provided_{*this, "Loop", *this};
  robots::PosePrm value_ = samplePose();
  const robots::PosePrm* last_ = nullptr;
};

struct ClientDevice final : suture::Device {
  suture::Required<LoopServer> server{*this, "Server"};
};

}  // namespace

Statistics measureExecution(std::size_t loops) {
  ServerDevice server;
  ClientDevice client;
  suture::Manager manager{"bench"};
  manager.add("Server", server);
  manager.add("Client", client);
  manager.connect("Client/Server", "Server/Loop");
  manager.start();
  const robots::PosePrm pose = samplePose();
  return timedLoops(loops, kCodecLoop, [&] {
    auto taken = client.server.put(pose);
    keep(taken);
  });
}

}  // namespace bench
