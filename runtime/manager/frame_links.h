#pragma once
// The frame links of a process that is a client, by which its connections find each other.

#include <suture/transport/rpc/kj_comparisons.h>  // first

#include <kj/async.h>
#include <suture/transport/frame/lane_thread.h>
#include <suture/transport/rpc/byte_stream.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace suture {

/// Belongs to the control thread.
class FrameLinks {
 public:
  using Link = std::shared_ptr<frame::Link>;
  /// The provider's process and what it calls the link.
  using Name = std::pair<std::string, std::uint32_t>;

  /// Throws SetupError if the kernel refuses.
  explicit FrameLinks(frame::LaneThread& lane);

  /// Rung by clients for what goes out.
  std::shared_ptr<rt::Doorbell> doorbell() { return lane_.doorbell(); }

  /// What a provider is told: connections of this process for which the same bound of silence holds
  /// may share a link, as their socket has one bound only.
  std::string client(Duration silence) const;

  /// While this lives no link ends for want of connections: an answer may name it.
  class Hold {
   public:
    Hold(std::vector<Link> links, std::shared_ptr<rt::Doorbell> bell)
        : links_(std::move(links)), bell_(std::move(bell)) {}
    Hold(Hold&&) = default;
    ~Hold();

   private:
    std::vector<Link> links_;
    std::shared_ptr<rt::Doorbell> bell_;
  };
  Hold hold();

  /// The socket of a new link has come. Whoever has one of its connections lets that join.
  Link open(const Name& name, rpc::ByteStream bytes);
  /// A link that there is, or will be; rejects never.
  kj::Promise<Link> find(const Name& name);

 private:
  struct Known {
    std::weak_ptr<frame::Link> link;
    std::vector<kj::Own<kj::PromiseFulfiller<Link>>> awaiting;
  };

  frame::LaneThread& lane_;
  std::array<char, 16> id_;  // no other process's
  std::map<Name, Known> links_;
};

}  // namespace suture
