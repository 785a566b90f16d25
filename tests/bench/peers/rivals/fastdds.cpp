// eProsima Fast DDS has reliable topics that keep all, by UDP on loopback, with and without its
// transport by shared memory.

#include <fastdds/rtps/common/SerializedPayload.h>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastdds/rtps/transport/shared_mem/SharedMemTransportDescriptor.h>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>

#include "harness/comes_back.h"
#include "harness/fail.h"
#include "harness/peer_main.h"
#include "rivals/fastdds_types.h"

namespace peers::fastdds {
namespace {

namespace dds = eprosima::fastdds::dds;
using eprosima::fastdds::rtps::SharedMemTransportDescriptor;
using eprosima::fastdds::rtps::UDPv4TransportDescriptor;

const eprosima::fastrtps::Duration_t kLongestAnswer{5, 0}, kFirstAnswer{0, 100'000'000};
constexpr int kDomain = 77;

enum class Carries { Poses, Blobs };

class Node {
 public:
  explicit Node(bool sharedMemory)
      : participant_(dds::DomainParticipantFactory::get_instance()->create_participant(
            kDomain, qualityOf(sharedMemory))) {
    if (participant_ == nullptr) fail("no participant");
    dds::TypeSupport(new PoseType).register_type(participant_);
    dds::TypeSupport(new BlobType).register_type(participant_);
    publisher_ = participant_->create_publisher(dds::PUBLISHER_QOS_DEFAULT);
    subscriber_ = participant_->create_subscriber(dds::SUBSCRIBER_QOS_DEFAULT);
  }
  ~Node() {
    participant_->delete_contained_entities();
    dds::DomainParticipantFactory::get_instance()->delete_participant(participant_);
  }
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;

  dds::DataWriter& writer(const char* name, Carries carries) {
    dds::DataWriterQos quality;
    quality.reliability().max_blocking_time = {10, 0};
    quality.durability().kind = dds::VOLATILE_DURABILITY_QOS;
    keepAll(quality, carries);
    auto* const made = publisher_->create_datawriter(topic(name, carries), quality);
    if (made == nullptr) fail("no writer");
    return *made;
  }
  dds::DataReader& reader(const char* name, Carries carries,
                          dds::DataReaderListener* listener = nullptr) {
    dds::DataReaderQos quality;
    keepAll(quality, carries);
    auto* const made = subscriber_->create_datareader(topic(name, carries), quality, listener);
    if (made == nullptr) fail("no reader");
    return *made;
  }

 private:
  static dds::DomainParticipantQos qualityOf(bool sharedMemory) {
    dds::DomainParticipantQos quality;
    auto& transport = quality.transport();
    transport.use_builtin_transports = false;
    if (sharedMemory) {
      transport.user_transports.push_back(std::make_shared<SharedMemTransportDescriptor>());
    }
    const auto udp = std::make_shared<UDPv4TransportDescriptor>();
    udp->interfaceWhiteList.push_back("127.0.0.1");
    transport.user_transports.push_back(udp);
    return quality;
  }

  /// Blobs are as large as they are, not as large as they may be.
  template <class Quality>
  static void keepAll(Quality& quality, Carries carries) {
    quality.reliability().kind = dds::RELIABLE_RELIABILITY_QOS;
    quality.history().kind = dds::KEEP_ALL_HISTORY_QOS;
    if (carries == Carries::Poses) return;
    quality.endpoint().history_memory_policy = rtps::DYNAMIC_REUSABLE_MEMORY_MODE;
    quality.resource_limits().allocated_samples = 4;
  }

  dds::Topic* topic(const char* name, Carries carries) {
    const char* const type = carries == Carries::Poses ? "Pose" : "Blob";
    return participant_->create_topic(name, type, dds::TOPIC_QOS_DEFAULT);
  }

  dds::DomainParticipant* const participant_;
  dds::Publisher* publisher_ = nullptr;
  dds::Subscriber* subscriber_ = nullptr;
};

bool tookOne(dds::DataReader& reader, void* value, bool& valid) {
  dds::SampleInfo info;
  const auto taken = reader.take_next_sample(value, &info);
  valid = info.valid_data;
  return taken == eprosima::fastrtps::types::ReturnCode_t::RETCODE_OK;
}

/// It hands on each value that arrives, in a thread of the library.
template <class Value, class HandOn>
class Listener final : public dds::DataReaderListener {
 public:
  explicit Listener(HandOn handOn) : handOn_(std::move(handOn)) {}

  void on_data_available(dds::DataReader* reader) override {
    for (bool valid = false; tookOne(*reader, &value_, valid);) {
      if (valid) handOn_(value_);
    }
  }

 private:
  Value value_;
  const HandOn handOn_;
};

template <class Value, class HandOn>
Listener<Value, HandOn> listenerOf(HandOn handOn) {
  return Listener<Value, HandOn>(std::move(handOn));
}

class FastClient final : public Client {
 public:
  explicit FastClient(bool sharedMemory) : node_(sharedMemory) {}

  void echo(const Pose& sent, Pose& back) override {
    write(poseRequest_, &sent);
    if (!answered(poseAnswer_, &back, kLongestAnswer)) fail("an answer is lost");
  }
  void echo(const Blob& sent, Blob& back) override {
    write(blobRequest_, &sent);
    if (!answered(blobAnswer_, &back, kLongestAnswer)) fail("an answer is lost");
  }
  bool reaches(const Pose& sent) override {
    write(poseRequest_, &sent);
    return comesBack(sent, [&](Pose& back) { return answered(poseAnswer_, &back, kFirstAnswer); });
  }
  bool reaches(const Blob& sent) override {
    write(blobRequest_, &sent);
    return comesBack(sent, [&](Blob& back) { return answered(blobAnswer_, &back, kFirstAnswer); });
  }
  void send(const Pose& pose) override { write(stream_, &pose); }

 private:
  static void write(dds::DataWriter& writer, const void* value) {
    if (!writer.write(const_cast<void*>(value))) fail("a sample was refused");
  }
  static bool answered(dds::DataReader& reader, void* value,
                       const eprosima::fastrtps::Duration_t& limit) {
    for (bool valid = false; !valid;) {
      if (tookOne(reader, value, valid)) continue;
      valid = false;
      if (!reader.wait_for_unread_message(limit)) return false;
    }
    return true;
  }

  Node node_;
  dds::DataWriter& poseRequest_ = node_.writer("pose_request", Carries::Poses);
  dds::DataWriter& blobRequest_ = node_.writer("blob_request", Carries::Blobs);
  dds::DataWriter& stream_ = node_.writer("stream", Carries::Poses);
  dds::DataReader& poseAnswer_ = node_.reader("pose_answer", Carries::Poses);
  dds::DataReader& blobAnswer_ = node_.reader("blob_answer", Carries::Blobs);
};

class FastPeer final : public Peer {
 public:
  explicit FastPeer(bool sharedMemory) : sharedMemory_(sharedMemory) {}

  bool publishes() const override { return true; }

  void serve(const Options& options, const Sink& sink,
             const std::function<void()>& ready) override {
    auto node = std::make_unique<Node>(sharedMemory_);
    auto& poses = node->writer("pose_answer", Carries::Poses);
    auto& blobs = node->writer("blob_answer", Carries::Blobs);
    auto echoPose = listenerOf<Pose>([&](Pose& pose) { poses.write(&pose); });
    auto echoBlob = listenerOf<Blob>([&](Blob& blob) { blobs.write(&blob); });
    auto count = listenerOf<Pose>([&](Pose& pose) { sink(pose); });
    if (options.server == 0) {
      node->reader("pose_request", Carries::Poses, &echoPose);
      node->reader("blob_request", Carries::Blobs, &echoBlob);
    }
    node->reader("stream", Carries::Poses, &count);
    ready();
    sink.control().awaitStop();
    node.reset();  // it goes before its listeners, and takes its shared memory with it
  }

  std::unique_ptr<Client> client(const Options&, int) override {
    return std::make_unique<FastClient>(sharedMemory_);
  }

  std::size_t convert(const Pose& pose, Pose& back) override {
    void* const value = const_cast<Pose*>(&pose);
    type_.getSerializedSizeProvider(value)();
    type_.serialize(value, &payload_);
    type_.deserialize(&payload_, &back);
    return payload_.length;
  }

 private:
  const bool sharedMemory_;
  PoseType type_;
  rtps::SerializedPayload_t payload_{256};
};

std::unique_ptr<Peer> peerOf(const std::string& variant) {
  if (variant == "shm+udp") return std::make_unique<FastPeer>(true);
  if (variant == "udp") return std::make_unique<FastPeer>(false);
  return nullptr;
}

}  // namespace
}  // namespace peers::fastdds

int main(int count, char** arguments) {
  return peers::peerMain(count, arguments, peers::fastdds::peerOf);
}
