// Cap'n Proto has two-party RPC and streaming calls, over TCP or a Unix socket.

#include <capnp/message.h>
#include <capnp/rpc-twoparty.h>
#include <capnp/serialize.h>
#include <kj/async-io.h>
#include <unistd.h>

#include "harness/keep.h"
#include "harness/peer_main.h"
#include "pose.capnp.h"

namespace peers {
namespace {

constexpr capnp::MessageSize kPoseSize{64, 0};

kj::StringPtr viewOf(const std::string& text) { return {text.c_str(), text.size()}; }

void store(const Pose& pose, calls::Pose::Builder wire) {
  const auto& r = pose.rotation;
  wire.setR0(r[0]);
  wire.setR1(r[1]);
  wire.setR2(r[2]);
  wire.setR3(r[3]);
  wire.setR4(r[4]);
  wire.setR5(r[5]);
  wire.setR6(r[6]);
  wire.setR7(r[7]);
  wire.setR8(r[8]);
  wire.setX(pose.position[0]);
  wire.setY(pose.position[1]);
  wire.setZ(pose.position[2]);
  wire.setTimestamp(pose.timestamp);
  wire.setValid(pose.valid);
  wire.setFrame(viewOf(pose.frame));
  wire.setReference(viewOf(pose.reference));
}

void load(calls::Pose::Reader wire, Pose& pose) {
  pose.rotation = {wire.getR0(), wire.getR1(), wire.getR2(), wire.getR3(), wire.getR4(),
                   wire.getR5(), wire.getR6(), wire.getR7(), wire.getR8()};
  pose.position = {wire.getX(), wire.getY(), wire.getZ()};
  pose.timestamp = wire.getTimestamp();
  pose.valid = wire.getValid();
  const auto frame = wire.getFrame(), reference = wire.getReference();
  pose.frame.assign(frame.begin(), frame.size());
  pose.reference.assign(reference.begin(), reference.size());
}

void store(const Blob& blob, calls::Blob::Builder wire) {
  wire.setTimestamp(blob.timestamp);
  auto data = wire.initData(static_cast<unsigned>(blob.data.size()));
  for (unsigned i = 0; i < data.size(); ++i) data.set(i, blob.data[i]);
}

void load(calls::Blob::Reader wire, Blob& blob) {
  blob.timestamp = wire.getTimestamp();
  const auto data = wire.getData();
  blob.data.resize(data.size());
  for (unsigned i = 0; i < data.size(); ++i) blob.data[i] = data[i];
}

capnp::MessageSize sizeOf(const Blob& blob) { return {64 + blob.data.size(), 0}; }

class Servant final : public calls::Echo::Server {
 public:
  explicit Servant(const Sink& sink) : sink_(sink) {}

  kj::Promise<void> echo(EchoContext call) override {
    load(call.getParams().getSent(), pose_);
    call.initResults(kPoseSize);
    store(pose_, call.getResults().initBack());
    return kj::READY_NOW;
  }
  kj::Promise<void> echoBlob(EchoBlobContext call) override {
    load(call.getParams().getSent(), blob_);
    call.initResults(sizeOf(blob_));
    store(blob_, call.getResults().initBack());
    return kj::READY_NOW;
  }
  kj::Promise<void> push(PushContext call) override {
    load(call.getParams().getSent(), pose_);
    sink_(pose_);
    return kj::READY_NOW;
  }
  kj::Promise<void> sync(SyncContext) override { return kj::READY_NOW; }

 private:
  const Sink sink_;
  Pose pose_;
  Blob blob_;
};

class CapnpClient final : public Client {
 public:
  CapnpClient(kj::WaitScope& scope, kj::Own<kj::AsyncIoStream> stream, bool fansOut)
      : scope_(scope),
        stream_(kj::mv(stream)),
        link_(*stream_),
        echo_(link_.bootstrap().castAs<calls::Echo>()),
        fansOut_(fansOut) {
    flush();  // returns when the capability is here
  }

  void echo(const Pose& sent, Pose& back) override {
    auto request = echo_.echoRequest(kPoseSize);
    store(sent, request.initSent());
    load(request.send().wait(scope_).getBack(), back);
  }
  void echo(const Blob& sent, Blob& back) override {
    auto request = echo_.echoBlobRequest(sizeOf(sent));
    store(sent, request.initSent());
    load(request.send().wait(scope_).getBack(), back);
  }
  void send(const Pose& pose) override {
    auto request = echo_.pushRequest(kPoseSize);
    store(pose, request.initSent());
    request.send().wait(scope_);  // it waits until the flow control has room
    if (fansOut_) scope_.poll();  // the write itself is left to a later turn of the event loop
  }
  void flush() override { echo_.syncRequest().send().wait(scope_); }

 private:
  kj::WaitScope& scope_;
  kj::Own<kj::AsyncIoStream> stream_;
  capnp::TwoPartyClient link_;
  calls::Echo::Client echo_;
  const bool fansOut_;
};

class CapnpPeer final : public Peer {
 public:
  explicit CapnpPeer(bool tcp) : tcp_(tcp) {}

  void serve(const Options& options, const Sink& sink,
             const std::function<void()>& ready) override {
    auto listener = addressOf(options, options.server)->listen();
    capnp::TwoPartyServer server(kj::heap<Servant>(sink));
    sink.control().exitWhenToldBeside();
    ready();
    server.listen(*listener).wait(io_.waitScope);
  }

  std::unique_ptr<Client> client(const Options& options, int server) override {
    auto stream = addressOf(options, server)->connect().wait(io_.waitScope);
    return std::make_unique<CapnpClient>(io_.waitScope, kj::mv(stream), options.fansOut());
  }

  std::size_t convert(const Pose& pose, Pose& back) override {
    capnp::word scratch[64] = {}, bytes[80];
    capnp::MallocMessageBuilder message(kj::arrayPtr(scratch, 64));
    store(pose, message.initRoot<calls::Pose>());
    kj::ArrayOutputStream out(kj::arrayPtr(bytes, 80).asBytes());
    capnp::writeMessage(out, message.getSegmentsForOutput());
    keep(bytes);
    const std::size_t words = out.getArray().size() / sizeof(capnp::word);
    capnp::FlatArrayMessageReader reader(kj::arrayPtr(bytes, words));
    load(reader.getRoot<calls::Pose>(), back);
    return out.getArray().size();
  }

 private:
  kj::Own<kj::NetworkAddress> addressOf(const Options& options, int server) {
    const std::string text = tcp_ ? "127.0.0.1:" + std::to_string(options.port + server)
                                  : "unix:" + options.socketPath(server);
    return io_.provider->getNetwork().parseAddress(viewOf(text)).wait(io_.waitScope);
  }

  const bool tcp_;
  kj::AsyncIoContext io_ = kj::setupAsyncIo();
};

std::unique_ptr<Peer> peerOf(const std::string& variant) {
  if (variant == "tcp") return std::make_unique<CapnpPeer>(true);
  if (variant == "unix") return std::make_unique<CapnpPeer>(false);
  return nullptr;
}

}  // namespace
}  // namespace peers

int main(int count, char** arguments) { return peers::peerMain(count, arguments, peers::peerOf); }
