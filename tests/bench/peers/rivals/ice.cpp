// ZeroC Ice, which the paper used, calls there and back, and one way, over TCP.

#include <Ice/Ice.h>

#include <cstring>

#include "PoseIce.h"
#include "harness/peer_main.h"

namespace peers {
namespace {

static_assert(sizeof(zeroc::Mat3) == sizeof(Pose::rotation));
static_assert(sizeof(zeroc::Vec3) == sizeof(Pose::position));

void store(const Pose& pose, zeroc::Pose& wire) {
  std::memcpy(&wire.rotation, pose.rotation.data(), sizeof wire.rotation);
  std::memcpy(&wire.position, pose.position.data(), sizeof wire.position);
  wire.timestamp = pose.timestamp;
  wire.valid = pose.valid;
  wire.frame = pose.frame;
  wire.reference = pose.reference;
}

void load(const zeroc::Pose& wire, Pose& pose) {
  std::memcpy(pose.rotation.data(), &wire.rotation, sizeof wire.rotation);
  std::memcpy(pose.position.data(), &wire.position, sizeof wire.position);
  pose.timestamp = wire.timestamp;
  pose.valid = wire.valid;
  pose.frame = wire.frame;
  pose.reference = wire.reference;
}

class Servant final : public zeroc::Echo {
 public:
  explicit Servant(const Sink& sink) : sink_(sink) {}

  zeroc::Pose ping(zeroc::Pose sent, const Ice::Current&) override {
    load(sent, pose_);
    zeroc::Pose back;
    store(pose_, back);
    return back;
  }
  zeroc::Blob pingBlob(zeroc::Blob sent, const Ice::Current&) override { return sent; }
  void push(zeroc::Pose sent, const Ice::Current&) override {
    load(sent, pose_);
    sink_(pose_);
  }

 private:
  const Sink sink_;
  Pose pose_;
};

std::shared_ptr<Ice::Communicator> makeCommunicator() {
  Ice::InitializationData data;
  data.properties = Ice::createProperties();
  data.properties->setProperty("Ice.MessageSizeMax", "8192");  // KiB
  data.properties->setProperty("Ice.IPv6", "0");
  data.properties->setProperty("Ice.Warn.Connections", "0");
  return Ice::initialize(data);
}

class IceClient final : public Client {
 public:
  explicit IceClient(std::shared_ptr<zeroc::EchoPrx> echo)
      : echo_(std::move(echo)), oneWay_(echo_->ice_oneway()) {}

  void echo(const Pose& sent, Pose& back) override {
    store(sent, wire_);
    load(echo_->ping(wire_), back);
  }
  void echo(const Blob& sent, Blob& back) override {
    zeroc::Blob answer = echo_->pingBlob({sent.timestamp, sent.data});
    back.timestamp = answer.timestamp;
    back.data = std::move(answer.data);
  }
  void send(const Pose& pose) override {
    store(pose, wire_);
    oneWay_->push(wire_);
  }
  void flush() override { echo_->ice_ping(); }

 private:
  const std::shared_ptr<zeroc::EchoPrx> echo_, oneWay_;
  zeroc::Pose wire_;
};

class IcePeer final : public Peer {
 public:
  ~IcePeer() override { communicator_->destroy(); }

  void serve(const Options& options, const Sink& sink,
             const std::function<void()>& ready) override {
    const auto adapter =
        communicator_->createObjectAdapterWithEndpoints("Echo", endpoint(options, options.server));
    adapter->add(std::make_shared<Servant>(sink), Ice::stringToIdentity("echo"));
    adapter->activate();
    ready();
    sink.control().exitWhenTold();
  }

  std::unique_ptr<Client> client(const Options& options, int server) override {
    const auto proxy = communicator_->stringToProxy("echo:" + endpoint(options, server));
    return std::make_unique<IceClient>(Ice::checkedCast<zeroc::EchoPrx>(proxy));
  }

  std::size_t convert(const Pose& pose, Pose& back) override {
    store(pose, sent_);
    Ice::OutputStream out(communicator_);
    out.write(sent_);
    const auto bytes = out.finished();
    Ice::InputStream in(communicator_, bytes);
    in.read(received_);
    load(received_, back);
    return static_cast<std::size_t>(bytes.second - bytes.first);
  }

 private:
  static std::string endpoint(const Options& options, int server) {
    return "tcp -h 127.0.0.1 -p " + std::to_string(options.port + server);
  }

  const std::shared_ptr<Ice::Communicator> communicator_ = makeCommunicator();
  zeroc::Pose sent_, received_;
};

std::unique_ptr<Peer> peerOf(const std::string& variant) {
  return variant == "tcp" ? std::make_unique<IcePeer>() : nullptr;
}

}  // namespace
}  // namespace peers

int main(int count, char** arguments) { return peers::peerMain(count, arguments, peers::peerOf); }
