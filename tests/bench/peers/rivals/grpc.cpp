// gRPC makes a call for each round trip, and has a stream of the client for what goes one way.

#include <grpcpp/grpcpp.h>

#include <algorithm>

#include "harness/fail.h"
#include "harness/keep.h"
#include "harness/peer_main.h"
#include "rivals/grpc_services.h"

namespace peers {
namespace {

void checked(const grpc::Status& status) {
  if (!status.ok()) fail(status.error_message());
}

class GrpcClient final : public Client {
 public:
  explicit GrpcClient(const std::shared_ptr<grpc::Channel>& channel)
      : stub_(protobuf::Echo::NewStub(channel)) {}
  ~GrpcClient() noexcept(false) override { flush(); }

  void echo(const Pose& sent, Pose& back) override {
    store(sent, sent_);
    grpc::ClientContext context;
    checked(stub_->Ping(&context, sent_, &back_));
    load(back_, back);
  }

  void echo(const Blob& sent, Blob& back) override {
    sentBlob_.set_timestamp(sent.timestamp);
    sentBlob_.mutable_data()->Resize(static_cast<int>(sent.data.size()), 0);
    std::copy(sent.data.begin(), sent.data.end(), sentBlob_.mutable_data()->begin());
    grpc::ClientContext context;
    checked(stub_->PingBlob(&context, sentBlob_, &backBlob_));
    back.timestamp = backBlob_.timestamp();
    back.data.assign(backBlob_.data().begin(), backBlob_.data().end());
  }

  void send(const Pose& pose) override {
    if (stream_ == nullptr) beginStream();
    store(pose, sent_);
    if (!stream_->Write(sent_)) fail("the stream is broken");
  }

  void flush() override {
    if (stream_ == nullptr) return;
    stream_->WritesDone();
    checked(stream_->Finish());
    stream_.reset();
    streamContext_.reset();
  }

 private:
  void beginStream() {
    streamContext_ = std::make_unique<grpc::ClientContext>();
    stream_ = stub_->Push(streamContext_.get(), &received_);
  }

  const std::unique_ptr<protobuf::Echo::Stub> stub_;
  protobuf::Pose sent_, back_;
  protobuf::Blob sentBlob_, backBlob_;
  protobuf::Received received_;
  std::unique_ptr<grpc::ClientContext> streamContext_;
  std::unique_ptr<grpc::ClientWriter<protobuf::Pose>> stream_;
};

enum class Serving { Blocking, ByCallback };

class GrpcPeer final : public Peer {
 public:
  GrpcPeer(bool tcp, Serving serving) : tcp_(tcp), serving_(serving) {}

  void serve(const Options& options, const Sink& sink,
             const std::function<void()>& ready) override {
    BlockingService blocking(sink);
    CallbackService byCallback(sink);
    grpc::ServerBuilder builder;
    builder.AddListeningPort(addressOf(options, options.server), grpc::InsecureServerCredentials());
    builder.SetMaxReceiveMessageSize(-1);
    if (serving_ == Serving::Blocking) {
      builder.RegisterService(&blocking);
    } else {
      builder.RegisterService(&byCallback);
    }
    const auto server = builder.BuildAndStart();
    if (server == nullptr) fail("the server does not start");
    ready();
    sink.control().exitWhenTold();
  }

  std::unique_ptr<Client> client(const Options& options, int server) override {
    grpc::ChannelArguments arguments;
    arguments.SetMaxReceiveMessageSize(-1);
    arguments.SetInt("grpc.use_local_subchannel_pool", 1);  // each client has its connection
    return std::make_unique<GrpcClient>(grpc::CreateCustomChannel(
        addressOf(options, server), grpc::InsecureChannelCredentials(), arguments));
  }

  std::size_t convert(const Pose& pose, Pose& back) override {
    std::uint8_t bytes[512];
    store(pose, sent_);
    const std::size_t size = sent_.ByteSizeLong();
    sent_.SerializeWithCachedSizesToArray(bytes);
    keep(bytes);
    if (!received_.ParseFromArray(bytes, static_cast<int>(size))) fail("bytes that are no pose");
    load(received_, back);
    return size;
  }

 private:
  std::string addressOf(const Options& options, int server) const {
    return tcp_ ? "127.0.0.1:" + std::to_string(options.port + server)
                : "unix:" + options.socketPath(server);
  }

  const bool tcp_;
  const Serving serving_;
  protobuf::Pose sent_, received_;
};

std::unique_ptr<Peer> peerOf(const std::string& variant) {
  if (variant == "tcp") return std::make_unique<GrpcPeer>(true, Serving::Blocking);
  if (variant == "unix") return std::make_unique<GrpcPeer>(false, Serving::Blocking);
  if (variant == "tcp-callback") return std::make_unique<GrpcPeer>(true, Serving::ByCallback);
  return nullptr;
}

}  // namespace
}  // namespace peers

int main(int count, char** arguments) { return peers::peerMain(count, arguments, peers::peerOf); }
