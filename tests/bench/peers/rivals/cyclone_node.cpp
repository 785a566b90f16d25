#include "rivals/cyclone_node.h"

#include <cstdlib>

namespace peers::cyclone {
namespace {

constexpr const char* kConfiguration =
    "<General><Interfaces><NetworkInterface name=\"lo\"/></Interfaces>"
    "<AllowMulticast>false</AllowMulticast></General>"
    "<Discovery><ParticipantIndex>auto</ParticipantIndex>"
    "<MaxAutoParticipantIndex>40</MaxAutoParticipantIndex>"
    "<Peers><Peer Address=\"127.0.0.1\"/></Peers></Discovery>";

const char* nameOf(Topic topic) {
  switch (topic) {
    case Topic::PoseRequest: return "pose_request";
    case Topic::PoseAnswer: return "pose_answer";
    case Topic::BlobRequest: return "blob_request";
    case Topic::BlobAnswer: return "blob_answer";
    case Topic::Stream: return "stream";
  }
  return "";
}

const dds_topic_descriptor_t* typeOf(Topic topic) {
  const bool blob = topic == Topic::BlobRequest || topic == Topic::BlobAnswer;
  return blob ? &peersdds_Blob_desc : &peersdds_Pose_desc;
}

}  // namespace

dds_return_t checked(dds_return_t result, const char* what) {
  if (result < 0) fail(std::string(what) + ": " + dds_strretcode(result));
  return result;
}

Node::Node() : quality_(dds_create_qos()) {
  setenv("CYCLONEDDS_URI", kConfiguration, 0);
  participant_ = checked(dds_create_participant(0, nullptr, nullptr), "participant");
  dds_qset_reliability(quality_, DDS_RELIABILITY_RELIABLE, DDS_SECS(10));
  dds_qset_resource_limits(quality_, DDS_LENGTH_UNLIMITED, DDS_LENGTH_UNLIMITED,
                           DDS_LENGTH_UNLIMITED);
}

Node::~Node() {
  dds_delete_qos(quality_);
  dds_delete(participant_);
}

// Requests and answers keep the last sample, as in the library's own example of a round trip; a
// stream keeps all.
dds_entity_t Node::made(Topic topic) {
  if (topic == Topic::Stream) {
    dds_qset_history(quality_, DDS_HISTORY_KEEP_ALL, 0);
  } else {
    dds_qset_history(quality_, DDS_HISTORY_KEEP_LAST, 1);
  }
  return checked(dds_create_topic(participant_, typeOf(topic), nameOf(topic), quality_, nullptr),
                 "topic");
}

dds_entity_t Node::writer(Topic topic) {
  const dds_entity_t about = made(topic);
  return checked(dds_create_writer(participant_, about, quality_, nullptr), "writer");
}

dds_entity_t Node::reader(Topic topic, const dds_listener_t* listener) {
  const dds_entity_t about = made(topic);
  return checked(dds_create_reader(participant_, about, quality_, listener), "reader");
}

dds_entity_t Node::waitset() { return checked(dds_create_waitset(participant_), "waitset"); }

void write(dds_entity_t writer, const void* sample) { checked(dds_write(writer, sample), "write"); }

void attach(dds_entity_t waitset, dds_entity_t reader, dds_attach_t token) {
  const dds_entity_t condition =
      checked(dds_create_readcondition(reader, DDS_ANY_STATE), "condition");
  checked(dds_waitset_attach(waitset, condition, token), "waitset");
}

}  // namespace peers::cyclone
