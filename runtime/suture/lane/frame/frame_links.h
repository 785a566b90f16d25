#pragma once
// The frame links of a process that is a client, by which its connections find each other.

#include <suture/loop/kj_comparisons.h>  // first

#include <kj/async.h>
#include <suture/lane/frame/lane_thread.h>
#include <suture/net/byte_stream.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace suture {

/// Belongs to the control thread. Knows each link by the provider's process and by what that calls
/// it, its epoch.
class FrameLinks {
 public:
  using Link = std::shared_ptr<frame::Link>;

  explicit FrameLinks(frame::LaneThread& lane) : lane_(lane) {}

  /// Rung by clients for what goes out.
  std::shared_ptr<rt::Doorbell> doorbell() { return lane_.doorbell(); }

  /// Returns the name that this process tells that provider: connections with the same one may
  /// share a link. It holds the bound of silence, as their socket has one only. No other process
  /// can know it, and it changes once a link has ended, since the provider may not have noticed
  /// that. Throws SetupError if the kernel refuses.
  std::string client(const std::string& provider, Duration silence);
  /// Changes that name, so that no link that the provider knows is joined any more.
  void rename(const std::string& provider) { providers_[provider].name.reset(); }

  /// While this lives, no link ends for want of connections, since an answer may name it.
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
  /// Resolves to a link that there is, or once it is there; never, if it never will be.
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
