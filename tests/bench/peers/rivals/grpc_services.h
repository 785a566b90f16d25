#pragma once
// gRPC has two kinds of server: one gives each call a thread, the other is called back.

#include "harness/pose.h"
#include "harness/sink.h"
#include "pose.grpc.pb.h"

namespace peers {

void store(const Pose& pose, protobuf::Pose& wire);
/// Ends the process if the message is no pose.
void load(const protobuf::Pose& wire, Pose& pose);

class BlockingService final : public protobuf::Echo::Service {
 public:
  explicit BlockingService(const Sink& sink) : sink_(sink) {}

  grpc::Status Ping(grpc::ServerContext*, const protobuf::Pose* sent,
                    protobuf::Pose* back) override;
  grpc::Status PingBlob(grpc::ServerContext*, const protobuf::Blob* sent,
                        protobuf::Blob* back) override;
  grpc::Status Push(grpc::ServerContext*, grpc::ServerReader<protobuf::Pose>* poses,
                    protobuf::Received* received) override;

 private:
  const Sink sink_;
};

class CallbackService final : public protobuf::Echo::CallbackService {
 public:
  explicit CallbackService(const Sink& sink) : sink_(sink) {}

  grpc::ServerUnaryReactor* Ping(grpc::CallbackServerContext* context, const protobuf::Pose* sent,
                                 protobuf::Pose* back) override;
  grpc::ServerUnaryReactor* PingBlob(grpc::CallbackServerContext* context,
                                     const protobuf::Blob* sent, protobuf::Blob* back) override;
  grpc::ServerReadReactor<protobuf::Pose>* Push(grpc::CallbackServerContext*,
                                                protobuf::Received* received) override;

 private:
  const Sink sink_;
};

}  // namespace peers
