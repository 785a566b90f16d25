#include "rivals/grpc_services.h"

#include <grpcpp/grpcpp.h>

#include <algorithm>

#include "harness/fail.h"

namespace peers {
namespace {

void echo(const protobuf::Pose& sent, protobuf::Pose& back) {
  Pose pose;
  load(sent, pose);
  store(pose, back);
}

grpc::ServerUnaryReactor* finished(grpc::CallbackServerContext& context) {
  grpc::ServerUnaryReactor* const reactor = context.DefaultReactor();
  reactor->Finish(grpc::Status::OK);
  return reactor;
}

/// It lives as long as its stream.
class StreamReader final : public grpc::ServerReadReactor<protobuf::Pose> {
 public:
  StreamReader(const Sink& sink, protobuf::Received& received) : sink_(sink), received_(received) {
    StartRead(&wire_);
  }

  void OnReadDone(bool read) override {
    if (!read) return Finish(grpc::Status::OK);
    load(wire_, pose_);
    sink_(pose_);
    received_.set_count(received_.count() + 1);
    StartRead(&wire_);
  }
  void OnDone() override { delete this; }

 private:
  const Sink sink_;
  protobuf::Received& received_;
  protobuf::Pose wire_;
  Pose pose_;
};

}  // namespace

void store(const Pose& pose, protobuf::Pose& wire) {
  wire.mutable_rotation()->Resize(9, 0);
  std::copy(pose.rotation.begin(), pose.rotation.end(), wire.mutable_rotation()->begin());
  wire.mutable_position()->Resize(3, 0);
  std::copy(pose.position.begin(), pose.position.end(), wire.mutable_position()->begin());
  wire.set_timestamp(pose.timestamp);
  wire.set_valid(pose.valid);
  wire.set_frame(pose.frame);
  wire.set_reference(pose.reference);
}

void load(const protobuf::Pose& wire, Pose& pose) {
  if (wire.rotation_size() != 9 || wire.position_size() != 3) fail("a message that is no pose");
  std::copy(wire.rotation().begin(), wire.rotation().end(), pose.rotation.begin());
  std::copy(wire.position().begin(), wire.position().end(), pose.position.begin());
  pose.timestamp = wire.timestamp();
  pose.valid = wire.valid();
  pose.frame = wire.frame();
  pose.reference = wire.reference();
}

grpc::Status BlockingService::Ping(grpc::ServerContext*, const protobuf::Pose* sent,
                                   protobuf::Pose* back) {
  echo(*sent, *back);
  return grpc::Status::OK;
}

grpc::Status BlockingService::PingBlob(grpc::ServerContext*, const protobuf::Blob* sent,
                                       protobuf::Blob* back) {
  *back = *sent;
  return grpc::Status::OK;
}

grpc::Status BlockingService::Push(grpc::ServerContext*, grpc::ServerReader<protobuf::Pose>* poses,
                                   protobuf::Received* received) {
  protobuf::Pose wire;
  Pose pose;
  while (poses->Read(&wire)) {
    load(wire, pose);
    sink_(pose);
    received->set_count(received->count() + 1);
  }
  return grpc::Status::OK;
}

grpc::ServerUnaryReactor* CallbackService::Ping(grpc::CallbackServerContext* context,
                                                const protobuf::Pose* sent, protobuf::Pose* back) {
  echo(*sent, *back);
  return finished(*context);
}

grpc::ServerUnaryReactor* CallbackService::PingBlob(grpc::CallbackServerContext* context,
                                                    const protobuf::Blob* sent,
                                                    protobuf::Blob* back) {
  *back = *sent;
  return finished(*context);
}

grpc::ServerReadReactor<protobuf::Pose>* CallbackService::Push(grpc::CallbackServerContext*,
                                                               protobuf::Received* received) {
  return new StreamReader(sink_, *received);
}

}  // namespace peers
