#pragma once
// A peer implements this. All that is timed or counted is in the harness, so that every peer does
// the same work and is measured by the same code.

#include <cstddef>
#include <functional>
#include <memory>
#include <string>

#include "harness/options.h"
#include "harness/pose.h"
#include "harness/sink.h"

namespace peers {

/// It belongs to one server, or to all of them where the peer publishes. Its waits block, and end
/// the process when they take too long.
class Client {
 public:
  virtual ~Client() noexcept(false) = default;  // objects of Cap'n Proto may throw

  /// The server turns what arrives into a Pose, and that into what it sends back.
  virtual void echo(const Pose& sent, Pose& back) = 0;
  virtual void echo(const Blob& sent, Blob& back) = 0;
  /// Sends one way, and waits only while there is no room. In a fan-out the pose leaves at once;
  /// else it may wait for others, or for flush().
  virtual void send(const Pose& pose) = 0;
  virtual void flush() {}

  /// Returns true if what is sent comes back, false if it does not within 100 ms: a peer that
  /// discovers its servers loses what is sent before they have found each other.
  virtual bool reaches(const Pose& sent) { return echoes(sent); }
  virtual bool reaches(const Blob& sent) { return echoes(sent); }

 private:
  template <class Value>
  bool echoes(const Value& sent) {
    Value back;
    echo(sent, back);
    return true;
  }
};

class Peer {
 public:
  virtual ~Peer() noexcept(false) = default;

  /// Serves echoes, and hands to `sink` what is sent one way, until the control block says stop.
  /// Calls ready() as soon as clients can reach it. It need not return.
  virtual void serve(const Options& options, const Sink& sink,
                     const std::function<void()>& ready) = 0;
  virtual std::unique_ptr<Client> client(const Options& options, int server) = 0;

  /// Returns true if one client reaches all servers.
  virtual bool publishes() const { return false; }
  /// Says why it echoes no blobs; "" if it does.
  virtual std::string lacksBlobs() const { return ""; }
  /// Runs `work`, which makes a client and uses it, in the thread that may.
  virtual void inClientThread(const Options&, const std::function<void()>& work) { work(); }

  /// Turns a pose into the bytes of a message and back, within this process. Returns how many
  /// bytes those are; 0 if the peer has no serializer.
  virtual std::size_t convert(const Pose&, Pose&) { return 0; }
};

}  // namespace peers
