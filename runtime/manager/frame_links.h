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
#include <optional>
#include <string>
#include <vector>

namespace suture {

/// By the provider's process, and by what that calls each link, its epoch. Belongs to the control
/// thread.
class FrameLinks {
 public:
  using Link = std::shared_ptr<frame::Link>;

  explicit FrameLinks(frame::LaneThread& lane) : lane_(lane) {}

  /// Rung by clients for what goes out.
  std::shared_ptr<rt::Doorbell> doorbell() { return lane_.doorbell(); }

  /// What that provider is told: connections of this process for which the same bound of silence
  /// holds may share a link, as their socket has one bound only. Nobody else can know it, and it is
  /// another one when a link has ended: the provider may not have noticed. Throws SetupError if the
  /// kernel refuses.
  std::string client(const std::string& provider, Duration silence);
  /// Another one from now on: no link that the provider knows is joined any more.
  void rename(const std::string& provider) { providers_[provider].name.reset(); }

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
  Hold hold(const std::string& provider);

  /// The socket of a new link has come. Whoever has one of its connections lets that join.
  Link open(const std::string& provider, std::uint32_t epoch, rpc::ByteStream bytes);
  /// A link that there is, or will be; never resolves if there will not.
  kj::Promise<Link> find(const std::string& provider, std::uint32_t epoch);

 private:
  struct Known {
    bool isOver() const;

    std::weak_ptr<frame::Link> link;  // none until its socket has come
    std::vector<kj::Own<kj::PromiseFulfiller<Link>>> awaiting;
  };
  struct Provider {
    std::optional<std::array<char, 16>> name;
    std::map<std::uint32_t, Known> links;
  };

  frame::LaneThread& lane_;
  std::map<std::string, Provider> providers_;
};

}  // namespace suture
