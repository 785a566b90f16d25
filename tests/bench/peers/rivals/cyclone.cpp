// Eclipse Cyclone DDS is used by its C interface: reliable topics on the loopback interface alone.

#include <dds/ddsi/ddsi_serdata.h>
#include <dds/ddsi/ddsi_sertype.h>

#include "harness/clock.h"
#include "harness/comes_back.h"
#include "harness/fail.h"
#include "harness/peer_main.h"
#include "rivals/cyclone_node.h"
#include "rivals/cyclone_server.h"
#include "rivals/cyclone_values.h"

namespace peers {
namespace {

using namespace std::chrono_literals;
using cyclone::Node;
using cyclone::Topic;

constexpr dds_duration_t kLongestAnswer = DDS_SECS(5), kFirstAnswer = DDS_MSECS(100);

class CycloneClient final : public Client {
 public:
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
  void send(const Pose& pose) override {
    const peersdds_Pose view = cyclone::viewOf(pose);
    cyclone::write(stream_, &view);
  }

 private:
  dds_entity_t waitsetFor(dds_entity_t reader) {
    const dds_entity_t waitset = node_.waitset();
    cyclone::attach(waitset, reader, 0);
    return waitset;
  }

  void request(const Pose& pose) {
    const peersdds_Pose view = cyclone::viewOf(pose);
    cyclone::write(poseRequest_, &view);
  }
  void request(const Blob& blob) {
    const peersdds_Blob view = cyclone::viewOf(blob);
    cyclone::write(blobRequest_, &view);
  }

  bool answered(Pose& back, dds_duration_t limit) {
    return taken<peersdds_Pose>(poseWait_, poseAnswer_, back, limit);
  }
  bool answered(Blob& back, dds_duration_t limit) {
    return taken<peersdds_Blob>(blobWait_, blobAnswer_, back, limit);
  }
  template <class Wire, class Value>
  static bool taken(dds_entity_t waitset, dds_entity_t reader, Value& value, dds_duration_t limit) {
    for (int count = 0; count == 0;) {
      dds_attach_t woken;
      if (dds_waitset_wait(waitset, &woken, 1, limit) <= 0) return false;
      count = cyclone::takeAll<Wire>(reader, [&](const Wire& wire) { cyclone::load(wire, value); });
    }
    return true;
  }

  Node node_;
  const dds_entity_t poseRequest_ = node_.writer(Topic::PoseRequest);
  const dds_entity_t blobRequest_ = node_.writer(Topic::BlobRequest);
  const dds_entity_t stream_ = node_.writer(Topic::Stream);
  const dds_entity_t poseAnswer_ = node_.reader(Topic::PoseAnswer);
  const dds_entity_t blobAnswer_ = node_.reader(Topic::BlobAnswer);
  const dds_entity_t poseWait_ = waitsetFor(poseAnswer_);
  const dds_entity_t blobWait_ = waitsetFor(blobAnswer_);
};

/// It goes the library's own way from a sample to serialized data and back.
class Converter {
 public:
  std::size_t convert(const Pose& pose, Pose& back) {
    const peersdds_Pose view = cyclone::viewOf(pose);
    if (type_ == nullptr) learnType(view);
    ddsi_serdata* const data = ddsi_serdata_from_sample(type_, SDK_DATA, &view);
    ddsrt_iovec_t bytes;
    const std::uint32_t size = ddsi_serdata_size(data);
    ddsi_serdata* const reference = ddsi_serdata_to_ser_ref(data, 0, size, &bytes);
    // It copies and checks, as what arrives is.
    ddsi_serdata* const arrived = ddsi_serdata_from_ser_iov(type_, SDK_DATA, 1, &bytes, size);
    if (arrived == nullptr || !ddsi_serdata_to_sample(arrived, &sample_, nullptr, nullptr)) {
      fail("a pose that cannot be read back");
    }
    cyclone::load(sample_, back);
    ddsi_serdata_to_ser_unref(reference, &bytes);
    ddsi_serdata_unref(data);
    ddsi_serdata_unref(arrived);
    return size;
  }

 private:
  /// Takes the object that stands for the type from a sample that has been through a topic.
  void learnType(const peersdds_Pose& view) {
    const dds_entity_t writer = node_.writer(Topic::Stream), reader = node_.reader(Topic::Stream);
    cyclone::write(writer, &view);
    ddsi_serdata* sample = nullptr;
    dds_sample_info_t info;
    const auto arrived = [&] { return dds_takecdr(reader, &sample, 1, &info, DDS_ANY_STATE) > 0; };
    if (!eventually(arrived, 1s)) fail("a sample did not arrive in its own process");
    type_ = sample->type;
  }

  Node node_;
  const ddsi_sertype* type_ = nullptr;
  peersdds_Pose sample_{};
};

class CyclonePeer final : public Peer {
 public:
  explicit CyclonePeer(bool listens) : listens_(listens) {}

  bool publishes() const override { return true; }
  std::string lacksBlobs() const override {
    return listens_ ? "a listener stalls: its thread has to read acknowledgements as well" : "";
  }

  void serve(const Options& options, const Sink& sink,
             const std::function<void()>& ready) override {
    if (listens_) cyclone::serveByListeners(options.server, sink, ready);
    cyclone::serveByWaitset(options.server, sink, ready);
  }

  std::unique_ptr<Client> client(const Options&, int) override {
    return std::make_unique<CycloneClient>();
  }

  std::size_t convert(const Pose& pose, Pose& back) override {
    if (converter_ == nullptr) converter_ = std::make_unique<Converter>();
    return converter_->convert(pose, back);
  }

 private:
  const bool listens_;
  std::unique_ptr<Converter> converter_;
};

std::unique_ptr<Peer> peerOf(const std::string& variant) {
  if (variant == "waitset") return std::make_unique<CyclonePeer>(false);
  if (variant == "listener") return std::make_unique<CyclonePeer>(true);
  return nullptr;
}

}  // namespace
}  // namespace peers

int main(int count, char** arguments) { return peers::peerMain(count, arguments, peers::peerOf); }
