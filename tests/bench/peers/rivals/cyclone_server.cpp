#include "rivals/cyclone_server.h"

#include <memory>
#include <vector>

#include "rivals/cyclone_values.h"

namespace peers::cyclone {
namespace {

/// It has the server's end of all topics.
class Responder {
 public:
  explicit Responder(const Sink& sink) : sink_(sink) {}

  void answerPoses(dds_entity_t reader) {
    takeAll<peersdds_Pose>(reader, [&](const peersdds_Pose& wire) {
      load(wire, pose_);
      const peersdds_Pose view = viewOf(pose_);
      write(poses_, &view);
    });
  }
  void answerBlobs(dds_entity_t reader) {
    takeAll<peersdds_Blob>(reader, [&](const peersdds_Blob& wire) { write(blobs_, &wire); });
  }
  void takeStream(dds_entity_t reader) {
    takeAll<peersdds_Pose>(reader, [&](const peersdds_Pose& wire) {
      load(wire, pose_);
      sink_(pose_);
    });
  }

  Node& node() { return node_; }

 private:
  const Sink sink_;
  Node node_;
  const dds_entity_t poses_ = node_.writer(Topic::PoseAnswer);
  const dds_entity_t blobs_ = node_.writer(Topic::BlobAnswer);
  Pose pose_;
};

/// It says what the responder does with what comes on a topic.
struct Inlet {
  Topic topic;
  void (Responder::*take)(dds_entity_t reader);
};

/// Answers come from the first server alone.
std::vector<Inlet> inletsOf(int server) {
  std::vector<Inlet> inlets{{Topic::Stream, &Responder::takeStream}};
  if (server == 0) {
    inlets.push_back({Topic::PoseRequest, &Responder::answerPoses});
    inlets.push_back({Topic::BlobRequest, &Responder::answerBlobs});
  }
  return inlets;
}

/// A listener is handed this.
struct Listening {
  Responder& responder;
  const Inlet inlet;
};

void dataAvailable(dds_entity_t reader, void* argument) {
  const auto& listening = *static_cast<const Listening*>(argument);
  (listening.responder.*listening.inlet.take)(reader);
}

}  // namespace

void serveByListeners(int server, const Sink& sink, const std::function<void()>& ready) {
  Responder responder(sink);
  std::vector<std::unique_ptr<Listening>> all;
  for (const Inlet& inlet : inletsOf(server)) {
    all.push_back(std::make_unique<Listening>(Listening{responder, inlet}));
    dds_listener_t* const listener = dds_create_listener(all.back().get());
    dds_lset_data_available(listener, dataAvailable);
    responder.node().reader(inlet.topic, listener);
    dds_delete_listener(listener);
  }
  ready();
  sink.control().exitWhenTold();
}

void serveByWaitset(int server, const Sink& sink, const std::function<void()>& ready) {
  Responder responder(sink);
  const std::vector<Inlet> inlets = inletsOf(server);
  const dds_entity_t waitset = responder.node().waitset();
  std::vector<dds_entity_t> readers;
  for (const Inlet& inlet : inlets) {
    readers.push_back(responder.node().reader(inlet.topic));
    attach(waitset, readers.back(), static_cast<dds_attach_t>(readers.size() - 1));
  }
  sink.control().exitWhenToldBeside();
  ready();
  for (std::vector<dds_attach_t> woken(inlets.size());;) {
    const dds_return_t count = dds_waitset_wait(waitset, woken.data(), woken.size(), DDS_INFINITY);
    for (int i = 0; i < count; ++i) {
      const auto which = static_cast<std::size_t>(woken[static_cast<std::size_t>(i)]);
      (responder.*inlets[which].take)(readers[which]);
    }
  }
}

}  // namespace peers::cyclone
