#pragma once
// This is the network between the processes of a run.

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

namespace demo {

/// Belongs to one thread. This is the network of one run.
class Network {
 public:
  /// `asked` is auto, unix, tcp, tls or namespaces; `lane` is that of all connections. With auto
  /// each process gets a network namespace of its own if this process may make them, else they use
  /// TCP on loopback; shared memory needs Unix sockets. Throws suture::SetupError for shared memory
  /// over anything else.
  Network(std::string asked, std::string lane);
  /// Call this if processes are to talk, before any process or thread is started, because
  /// namespaces move this process as well. Throws suture::SetupError for namespaces that cannot be
  /// made.
  void open();

  /// Returns the word by which it is asked for, such as "tcp"; "none" until it is open.
  std::string name() const;
  /// Returns the end of a sentence: what a message between two processes crosses.
  std::string description() const;
  /// Returns where the global manager is to listen. Port 0 lets it choose one.
  std::string managerAddress(const std::filesystem::path& folder) const;
  bool needsKeys() const { return kind_ == Kind::Tls || kind_ == Kind::Namespaces; }
  /// Returns the fastest lane between two processes.
  const char* fastestLane() const { return kind_ == Kind::Unix ? "shm" : "frame"; }

  bool hasNamespaces() const { return kind_ == Kind::Namespaces; }
  /// Lays a cable from the switch to a child, which is the process of that name and has a network
  /// namespace of its own. Throws suture::SetupError.
  void connect(const std::string& process, pid_t child);
  /// Pulls that cable, or puts it back. Throws suture::SetupError.
  void setCable(const std::string& process, bool plugged) const;

 private:
  enum class Kind : std::uint8_t { None, Unix, Tcp, Tls, Namespaces };

  const std::string asked_, lane_;
  Kind kind_ = Kind::None;
  std::string whyNoNamespaces_;
  std::map<std::string, std::string> cables_;  // by process: the switch's end
};

}  // namespace demo
