// Suture is measured over each of its lanes, by what its users have.

#include <suture/base/errors.h>
#include <suture/manager/manager.h>

#include <algorithm>
#include <string_view>

#include "harness/clock.h"
#include "harness/fail.h"
#include "harness/peer_main.h"
#include "suture/clients.h"
#include "suture/components.h"
#include "suture/generated_codec.h"

namespace peers {
namespace {

using namespace std::chrono_literals;

struct Variant {
  std::string_view name;
  suture::Lane lane;
  bool tcp;
  Back back = Back::AsEvent;
};

const Variant kVariants[] = {
    {"shm", suture::Lane::Shm, false},
    {"frame-unix", suture::Lane::Frame, false},
    {"frame-tcp", suture::Lane::Frame, true},
    {"rpc-unix", suture::Lane::Rpc, false},
    {"rpc-tcp", suture::Lane::Rpc, true},
    {"shm-return", suture::Lane::Shm, false, Back::AsReturnValue},
    {"frame-tcp-return", suture::Lane::Frame, true, Back::AsReturnValue},
    {"rpc-unix-return", suture::Lane::Rpc, false, Back::AsReturnValue},
};

/// suture-manager listens there, and the processes of a run find each other by it. The report
/// starts it (catalogue.py).
std::string addressOf(const Options& options, const Variant& variant) {
  return variant.tcp ? "tcp://127.0.0.1:" + std::to_string(options.port)
                     : "unix:" + options.place + ".suture/manager";
}

class SuturePeer final : public Peer {
 public:
  explicit SuturePeer(const Variant& variant) : variant_(variant) {}

  bool publishes() const override { return true; }

  void serve(const Options& options, const Sink& sink,
             const std::function<void()>& ready) override {
    Responder responder(sink);
    suture::Manager manager("server" + std::to_string(options.server),
                            addressOf(options, variant_));
    manager.add("Responder", responder);
    manager.start();
    ready();
    if (options.fansOut()) {
      // The publisher stays in one run(), and would count as hung after 2 s.
      connect(manager, "Responder/Feed", "client:Requester/Feed", {.silence = 120s});
    }
    sink.control().awaitStop();
    manager.stop();
  }

  void inClientThread(const Options& options, const std::function<void()>& work) override {
    Requester requester;
    suture::Manager manager("client", addressOf(options, variant_));
    manager.add("Requester", requester);
    manager.start();
    if (options.fansOut()) {
      awaitSubscribers(manager, options.servers);
    } else {
      connect(manager, "Requester/Echo", "server0:Responder/Echo");
      connect(manager, "Requester/BlobEcho", "server0:Responder/BlobEcho");
    }
    requester_ = &requester;
    requester.runInTask(work);
    requester_ = nullptr;
    manager.stop();
  }

  std::unique_ptr<Client> client(const Options& options, int) override {
    return options.fansOut() ? publisher(*requester_) : clientOfServer(*requester_, variant_.back);
  }

  std::size_t convert(const Pose& pose, Pose& back) override {
    return variant_.lane == suture::Lane::Rpc ? codec_.throughMessage(pose, back)
                                              : codec_.throughSlot(pose, back);
  }

 private:
  void connect(suture::Manager& manager, const char* required, const char* provided,
               const suture::ConnectionContract& contract = {}) const {
    manager.connect(required, provided,
                    {.lane = variant_.lane, .laneRequired = true, .contract = contract});
  }

  static void awaitSubscribers(const suture::Manager& manager, int count) {
    const auto all = [&] { return manager.channels().size() >= static_cast<std::size_t>(count); };
    if (!eventually(all, 15s)) fail("not all subscribers were connected within 15 s");
  }

  const Variant variant_;
  GeneratedCodec codec_;
  Requester* requester_ = nullptr;  // while inClientThread() runs
};

std::unique_ptr<Peer> peerOf(const std::string& name) {
  const auto* const found = std::ranges::find(kVariants, name, &Variant::name);
  return found == std::end(kVariants) ? nullptr : std::make_unique<SuturePeer>(*found);
}

}  // namespace
}  // namespace peers

int main(int count, char** arguments) {
  try {
    return peers::peerMain(count, arguments, peers::peerOf);
  } catch (const suture::SetupError& error) {
    peers::fail(error.what());
  }
}
