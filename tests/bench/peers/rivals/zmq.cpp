// ZeroMQ has REQ and REP for the round trip, PUSH and PULL for the stream, XPUB and SUB for the
// fan-out. It has no serializer, so the hand-written packer is used.

#include <zmq.hpp>

#include <cstring>
#include <thread>

#include "harness/fail.h"
#include "harness/hand_packer.h"
#include "harness/peer_main.h"

namespace peers {
namespace {

enum class Purpose { Echo, BlobEcho, Stream, FanOut };

std::string endpoint(bool tcp, const Options& options, int server, Purpose purpose) {
  const int number = static_cast<int>(purpose);
  if (tcp) return "tcp://127.0.0.1:" + std::to_string(options.port + 100 * number + server);
  return "ipc://" + options.place + "." + std::to_string(number) + "." + std::to_string(server);
}

const unsigned char* bytesOf(const zmq::message_t& message) {
  return static_cast<const unsigned char*>(message.data());
}

void unpackOrFail(const zmq::message_t& message, Pose& pose) {
  if (!unpack(bytesOf(message), message.size(), pose)) fail("a message that is no pose");
}

void sendPacked(zmq::socket_t& socket, const Pose& pose) {
  unsigned char bytes[kMostPackedBytes];
  socket.send(zmq::buffer(bytes, pack(pose, bytes)), zmq::send_flags::none);
}

void receiveStream(zmq::socket_t& socket, const Sink& sink) {
  zmq::message_t message;
  Pose pose;
  while (socket.recv(message)) {
    unpackOrFail(message, pose);
    sink(pose);
  }
}

void echoPoses(zmq::socket_t& socket) {
  zmq::message_t message;
  Pose pose;
  while (socket.recv(message)) {
    unpackOrFail(message, pose);
    sendPacked(socket, pose);
  }
}

void echoBlobs(zmq::socket_t& socket) {
  zmq::message_t message;
  while (socket.recv(message)) socket.send(message, zmq::send_flags::none);
}

struct ClientSockets {
  zmq::socket_t echo, blobEcho, out;
};

class ZmqClient final : public Client {
 public:
  explicit ZmqClient(ClientSockets sockets) : sockets_(std::move(sockets)) {
    sockets_.out.set(zmq::sockopt::linger, 1000);
  }

  void echo(const Pose& sent, Pose& back) override {
    sendPacked(sockets_.echo, sent);
    receive(sockets_.echo);
    unpackOrFail(answer_, back);
  }

  void echo(const Blob& sent, Blob& back) override {
    const std::size_t bytes = sent.data.size() * sizeof(double);
    zmq::message_t message(sizeof(double) + bytes);
    char* const to = static_cast<char*>(message.data());
    std::memcpy(to, &sent.timestamp, sizeof(double));
    std::memcpy(to + sizeof(double), sent.data.data(), bytes);
    sockets_.blobEcho.send(message, zmq::send_flags::none);

    receive(sockets_.blobEcho);
    const unsigned char* const from = bytesOf(answer_);
    std::memcpy(&back.timestamp, from, sizeof(double));
    back.data.resize(answer_.size() / sizeof(double) - 1);
    std::memcpy(back.data.data(), from + sizeof(double), back.data.size() * sizeof(double));
  }

  void send(const Pose& pose) override { sendPacked(sockets_.out, pose); }

 private:
  void receive(zmq::socket_t& socket) {
    if (!socket.recv(answer_)) fail("no answer");
  }

  ClientSockets sockets_;
  zmq::message_t answer_;
};

class ZmqPeer final : public Peer {
 public:
  explicit ZmqPeer(bool tcp) : tcp_(tcp) {}

  bool publishes() const override { return true; }

  void serve(const Options& options, const Sink& sink,
             const std::function<void()>& ready) override {
    zmq::socket_t poses(context_, ZMQ_REP), blobs(context_, ZMQ_REP);
    zmq::socket_t pull(context_, ZMQ_PULL), subscriber(context_, ZMQ_SUB);
    poses.bind(endpoint(tcp_, options, options.server, Purpose::Echo));
    blobs.bind(endpoint(tcp_, options, options.server, Purpose::BlobEcho));
    pull.bind(endpoint(tcp_, options, options.server, Purpose::Stream));
    subscriber.set(zmq::sockopt::subscribe, "");
    subscriber.connect(endpoint(tcp_, options, 0, Purpose::FanOut));
    std::thread([&] { echoBlobs(blobs); }).detach();
    std::thread([&] { receiveStream(pull, sink); }).detach();
    std::thread([&] { receiveStream(subscriber, sink); }).detach();
    sink.control().exitWhenToldBeside();
    ready();
    echoPoses(poses);
  }

  std::unique_ptr<Client> client(const Options& options, int server) override {
    if (options.fansOut()) return publisher(options);
    ClientSockets sockets{{context_, ZMQ_REQ}, {context_, ZMQ_REQ}, {context_, ZMQ_PUSH}};
    sockets.echo.connect(endpoint(tcp_, options, server, Purpose::Echo));
    sockets.blobEcho.connect(endpoint(tcp_, options, server, Purpose::BlobEcho));
    sockets.out.connect(endpoint(tcp_, options, server, Purpose::Stream));
    return std::make_unique<ZmqClient>(std::move(sockets));
  }

 private:
  std::unique_ptr<Client> publisher(const Options& options) {
    zmq::socket_t out(context_, ZMQ_XPUB);
    out.set(zmq::sockopt::xpub_verboser, 1);  // each subscriber is told of, not the first alone
    out.bind(endpoint(tcp_, options, 0, Purpose::FanOut));
    zmq::message_t subscription;
    for (int i = 0; i < options.servers; ++i) {
      if (!out.recv(subscription)) fail("a subscriber is missing");
    }
    return std::make_unique<ZmqClient>(ClientSockets{{}, {}, std::move(out)});
  }

  const bool tcp_;
  zmq::context_t context_{1};
};

std::unique_ptr<Peer> peerOf(const std::string& variant) {
  if (variant == "tcp") return std::make_unique<ZmqPeer>(true);
  if (variant == "ipc") return std::make_unique<ZmqPeer>(false);
  return nullptr;
}

}  // namespace
}  // namespace peers

int main(int count, char** arguments) { return peers::peerMain(count, arguments, peers::peerOf); }
