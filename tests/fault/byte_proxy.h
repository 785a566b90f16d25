#pragma once
// This stands between two processes and breaks what they say, by the byte.

#include <suture/base/time.h>
#include <suture/net/address.h>
#include <suture/net/descriptor_passing.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <list>
#include <mutex>
#include <random>
#include <string>
#include <thread>
#include <vector>

namespace suture {

/// Listens at one address and passes each connection on to another, with the descriptors that it
/// carries between two Unix sockets. Any thread may use it.
class ByteProxy {
 public:
  enum class Mode : std::uint8_t {
    Forward,
    HalfOpen,   ///< nothing passes, in either direction; all sockets stay open, bytes wait in them
    OnlyThere,  ///< the caller's bytes pass, those for it wait
    OnlyBack,   ///< the reverse
    Throttle,   ///< a trickle passes
  };
  enum class Strike : std::uint8_t {
    Strand,    ///< nothing passes on present connections until set() is called, their end never;
               ///< later ones work
    Cut,       ///< all connections are closed
    Reset,     ///< the same, by a reset
    Truncate,  ///< half of what the caller says next passes, then its connection is closed
    BitFlip,   ///< one bit of what either says next is wrong; the first words of a connection are
               ///< spared, as they may agree on another lane
  };

  /// `here` is a Unix socket, or TCP with a number, where port 0 is any.
  ByteProxy(const net::Address& here, const net::Address& target, unsigned seed);
  ~ByteProxy();
  ByteProxy(const ByteProxy&) = delete;
  ByteProxy& operator=(const ByteProxy&) = delete;

  const std::string& address() const { return address_; }  ///< where it listens
  /// Sets the mode from now on, for connections present and to come.
  void set(Mode mode);
  /// Lets bytes pass so much later from now on, each way, as over a long distance.
  void delay(Duration each);
  /// Strikes now; returns when it has been done, or at the latest with what the callers say next.
  void strike(Strike strike);

  /// Returns how many connections, or chunks of bytes, have been hurt.
  std::uint64_t injected() const { return injected_; }

 private:
  /// A Chunk has been read and not yet been written.
  struct Chunk {
    Time due{};
    std::vector<std::byte> bytes;
    net::Descriptors descriptors;  // which go with those
  };
  struct Stream {
    int from = -1, to = -1;
    std::deque<Chunk> waiting;
    bool ended = false;
  };
  struct Link {
    Stream there, back;
    bool held = false;  // counted in this mode
    bool stranded = false;
    bool endless = false;  // it has been stranded
    unsigned said = 0;     // chunks, either way
  };

  void run();
  void wake();
  void accept();
  bool passes(const Stream& stream, bool there) const;
  bool mayTake(const Stream& stream) const;
  bool serve(Link& link);
  bool take(Link& link, bool there);
  static bool give(Stream& stream);
  void hurt(Link& link, bool there);
  void closeAll(bool reset);
  static void close(Link& link, bool reset);

  const net::Address target_;
  std::mutex mutex_;  // it guards the members below
  std::mt19937 random_;
  Mode mode_ = Mode::Forward;
  Duration delay_{0};
  bool truncates_ = false, flips_ = false, stopping_ = false;
  std::list<Link> links_;
  std::atomic<std::uint64_t> injected_{0};
  int listener_ = -1, bell_ = -1;
  std::string address_;
  std::thread thread_;
};

}  // namespace suture
