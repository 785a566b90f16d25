#pragma once
// These are the lanes that rows measure one after the other.

#include <suture/manager/manager.h>

#include <string>

#include "bench/table2/setup.h"

namespace bench {

/// Another process of this machine can be reached by these; they are part of the figures' names.
inline const suture::Lane kLanes[] = {suture::Lane::Shm, suture::Lane::Frame, suture::Lane::Rpc};

/// A LaneOverSocket is a lane, over one kind of socket.
struct LaneOverSocket {
  const char* title;
  const char* figure;  ///< part of the figures' names
  Transport transport;
  suture::Lane lane;
};

inline const LaneOverSocket kLanesOverSockets[] = {
    {"shm", "shm", Transport::Unix, suture::Lane::Shm},
    {"frame, Unix socket", "frame.unix", Transport::Unix, suture::Lane::Frame},
    {"frame, TCP", "frame.tcp", Transport::Tcp, suture::Lane::Frame},
    {"rpc, Unix socket", "rpc.unix", Transport::Unix, suture::Lane::Rpc},
    {"rpc, TCP", "rpc.tcp", Transport::Tcp, suture::Lane::Rpc},
};

/// This is `frame` as between builds that differ, in a process that has had addEncodedFrames().
inline const suture::Lane kEncodedFrames{"frame-encoded"};
void addEncodedFrames(suture::Manager& manager);

/// Does as Manager::connect(). Throws SetupError too if the connection has another lane.
void connectBy(const suture::Lane& lane, suture::Manager& manager, const std::string& required,
               const std::string& provided, const suture::ConnectionContract& contract = {});

}  // namespace bench
