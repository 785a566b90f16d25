// Eclipse iceoryx lends memory for plain structs, and has a wait that blocks. It needs iox-roudi.

#include <iceoryx_hoofs/log/logmanager.hpp>
#include <iceoryx_posh/popo/publisher.hpp>
#include <iceoryx_posh/popo/subscriber.hpp>
#include <iceoryx_posh/popo/untyped_publisher.hpp>
#include <iceoryx_posh/popo/untyped_subscriber.hpp>
#include <iceoryx_posh/popo/wait_set.hpp>
#include <iceoryx_posh/runtime/posh_runtime.hpp>

#include <cstring>

#include "harness/clock.h"
#include "harness/comes_back.h"
#include "harness/fail.h"
#include "harness/peer_main.h"
#include "harness/plain_pose.h"

namespace peers {
namespace {

using namespace iox::popo;
using PoseSubscriber = Subscriber<PlainPose>;

constexpr std::int64_t kLongestAnswer = 5 * kSecond, kFirstAnswer = kSecond / 10;

/// It stands before the numbers of a blob.
struct BlobLead {
  std::uint64_t bytes;  ///< how long the blob is with this
  double timestamp;
};

void beginRuntime(const std::string& process) {
  iox::log::LogManager::GetLogManager().SetDefaultLogLevel(iox::log::LogLevel::kWarn,
                                                           iox::log::LogLevelOutput::kHideLogLevel);
  iox::runtime::PoshRuntime::initRuntime(iox::RuntimeName_t(iox::cxx::TruncateToCapacity, process));
}

iox::capro::ServiceDescription topic(const std::string& name) {
  return {"peers", iox::capro::IdString_t(iox::cxx::TruncateToCapacity, name), "topic"};
}

PublisherOptions reliablePublisher() {
  PublisherOptions options;
  options.historyCapacity = 0;
  options.subscriberTooSlowPolicy = ConsumerTooSlowPolicy::WAIT_FOR_CONSUMER;
  return options;
}

SubscriberOptions reliableSubscriber() {
  SubscriberOptions options;
  options.queueCapacity = 256;
  options.queueFullPolicy = QueueFullPolicy::BLOCK_PRODUCER;
  return options;
}

void publish(Publisher<PlainPose>& publisher, const Pose& pose) {
  publisher.loan()
      .and_then([&](auto& sample) {
        store(pose, *sample);
        sample.publish();
      })
      .or_else([](auto&) { fail("no memory to lend"); });
}

template <class Fill>
void publishBytes(UntypedPublisher& publisher, std::uint64_t bytes, const Fill& fillIn) {
  publisher.loan(static_cast<std::uint32_t>(bytes))
      .and_then([&](void* memory) {
        fillIn(static_cast<char*>(memory));
        publisher.publish(memory);
      })
      .or_else([](auto&) { fail("no memory to lend"); });
}

/// Calls `take` with each pose that is there. Returns false if there was none.
template <class Take>
bool takePoses(PoseSubscriber& subscriber, const Take& take) {
  bool any = false;
  Pose pose;
  for (auto sample = subscriber.take(); !sample.has_error(); sample = subscriber.take()) {
    load(*sample.value(), pose);
    take(pose);
    any = true;
  }
  return any;
}

/// Does the same with the bytes of a blob, of which there is one at most.
template <class Take>
bool takeBlob(UntypedSubscriber& subscriber, const Take& take) {
  bool any = false;
  subscriber.take().and_then([&](const void* memory) {
    take(static_cast<const char*>(memory));
    subscriber.release(memory);
    any = true;
  });
  return any;
}

template <class Attached>
void attach(WaitSet<>& waits, Attached& subscriber) {
  waits.attachState(subscriber, SubscriberState::HAS_DATA).or_else([](auto) {
    fail("a subscriber cannot be waited for");
  });
}

BlobLead leadOf(const char* memory) {
  BlobLead lead;
  std::memcpy(&lead, memory, sizeof lead);
  return lead;
}

/// Only the first server answers; the others take part under names without a user.
std::string answering(int server, const std::string& name) {
  return server == 0 ? name : name + "_unused";
}

class Server {
 public:
  Server(const Sink& sink, int server)
      : sink_(sink),
        poses_(topic(answering(server, "pose_request")), reliableSubscriber()),
        blobs_(topic(answering(server, "blob_request")), reliableSubscriber()),
        poseAnswers_(topic(answering(server, "pose_answer")), reliablePublisher()),
        blobAnswers_(topic(answering(server, "blob_answer")), reliablePublisher()) {
    attach(waits_, poses_);
    attach(waits_, blobs_);
    attach(waits_, stream_);
  }

  /// Returns once it is told to stop: iox-roudi has to hear of the end of a process.
  void run() {
    std::thread waker([this] {
      sink_.control().awaitStop();
      waits_.markForDestruction();
    });
    while (sink_.control().stop.load() == 0) {
      for (const auto& arrival : waits_.wait()) take(*arrival);
    }
    waker.join();
  }

 private:
  void take(const NotificationInfo& arrival) {
    if (arrival.doesOriginateFrom(&stream_)) {
      takePoses(stream_, sink_);
    } else if (arrival.doesOriginateFrom(&poses_)) {
      takePoses(poses_, [&](const Pose& pose) { publish(poseAnswers_, pose); });
    } else {
      takeBlob(blobs_, [&](const char* blob) { answer(blob); });
    }
  }

  void answer(const char* blob) {
    const std::uint64_t bytes = leadOf(blob).bytes;
    publishBytes(blobAnswers_, bytes, [&](char* to) { std::memcpy(to, blob, bytes); });
  }

  const Sink sink_;
  PoseSubscriber poses_;
  UntypedSubscriber blobs_;
  PoseSubscriber stream_{topic("stream"), reliableSubscriber()};
  Publisher<PlainPose> poseAnswers_;
  UntypedPublisher blobAnswers_;
  WaitSet<> waits_;
};

class IceoryxClient final : public Client {
 public:
  IceoryxClient() {
    attach(poseWait_, poseAnswers_);
    attach(blobWait_, blobAnswers_);
  }

  void echo(const Pose& sent, Pose& back) override {
    request(sent);
    if (!answered(back, kLongestAnswer)) fail("an answer is lost");
  }
  void echo(const Blob& sent, Blob& back) override {
    request(sent);
    if (!answered(back, kLongestAnswer)) fail("an answer is lost");
  }
  bool reaches(const Pose& sent) override {
    request(sent);
    return comesBack(sent, [&](Pose& back) { return answered(back, kFirstAnswer); });
  }
  bool reaches(const Blob& sent) override {
    request(sent);
    return comesBack(sent, [&](Blob& back) { return answered(back, kFirstAnswer); });
  }

  void send(const Pose& pose) override { publish(stream_, pose); }

 private:
  void request(const Pose& pose) { publish(poses_, pose); }
  void request(const Blob& blob) {
    const std::size_t numbers = blob.data.size() * sizeof(double);
    const BlobLead lead{sizeof lead + numbers, blob.timestamp};
    publishBytes(blobs_, lead.bytes, [&](char* to) {
      std::memcpy(to, &lead, sizeof lead);
      std::memcpy(to + sizeof lead, blob.data.data(), numbers);
    });
  }

  bool answered(Pose& back, std::int64_t limit) {
    return taken(poseWait_, limit,
                 [&] { return takePoses(poseAnswers_, [&](const Pose& pose) { back = pose; }); });
  }
  bool answered(Blob& back, std::int64_t limit) {
    return taken(blobWait_, limit, [&] {
      return takeBlob(blobAnswers_, [&](const char* blob) { unpack(blob, back); });
    });
  }

  static void unpack(const char* memory, Blob& blob) {
    const BlobLead lead = leadOf(memory);
    const std::size_t bytes = lead.bytes - sizeof lead;
    blob.timestamp = lead.timestamp;
    blob.data.resize(bytes / sizeof(double));
    std::memcpy(blob.data.data(), memory + sizeof lead, bytes);
  }

  /// A wait may also end for what has been taken already.
  template <class Take>
  static bool taken(WaitSet<>& waits, std::int64_t limit, const Take& take) {
    const std::int64_t end = now() + limit;
    while (!take()) {
      const std::int64_t left = end - now();
      if (left <= 0) return false;
      waits.timedWait(iox::units::Duration::fromNanoseconds(left));
    }
    return true;
  }

  Publisher<PlainPose> poses_{topic("pose_request"), reliablePublisher()};
  Publisher<PlainPose> stream_{topic("stream"), reliablePublisher()};
  UntypedPublisher blobs_{topic("blob_request"), reliablePublisher()};
  PoseSubscriber poseAnswers_{topic("pose_answer"), reliableSubscriber()};
  UntypedSubscriber blobAnswers_{topic("blob_answer"), reliableSubscriber()};
  WaitSet<> poseWait_, blobWait_;
};

class IceoryxPeer final : public Peer {
 public:
  bool publishes() const override { return true; }

  void serve(const Options& options, const Sink& sink,
             const std::function<void()>& ready) override {
    beginRuntime("server" + std::to_string(options.server));
    Server server(sink, options.server);
    ready();
    server.run();
  }

  std::unique_ptr<Client> client(const Options&, int) override {
    beginRuntime("client");
    return std::make_unique<IceoryxClient>();
  }
};

std::unique_ptr<Peer> peerOf(const std::string& variant) {
  return variant == "waitset" ? std::make_unique<IceoryxPeer>() : nullptr;
}

}  // namespace
}  // namespace peers

int main(int count, char** arguments) { return peers::peerMain(count, arguments, peers::peerOf); }
