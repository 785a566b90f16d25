#include <suture/base/errors.h>
#include <suture/names/peer_address.h>
#include <suture/net/listener.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <csignal>
#include <filesystem>
#include <set>
#include <string_view>
#include <system_error>

namespace suture {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kEnd = ".sock";

constexpr pid_t kLargestNumber = 4'194'304;  // the kernel's PID_MAX_LIMIT

net::Address socketAt(const fs::path& path) {
  net::Address address;
  address.path = path.string();
  return address;
}

// Peers may run in another folder, for which a relative path leads elsewhere.
fs::path directoryOf(const net::Address& manager) {
  return fs::absolute(manager.path).parent_path();
}

net::Address socketOf(const fs::path& directory, const std::string& process, pid_t number) {
  return socketAt(directory / (process + "." + std::to_string(number) + std::string(kEnd)));
}

/// Returns the process that a socket named `name` belongs to; 0 if that is none of ours.
pid_t ownerOf(std::string_view name, std::string_view process) {
  if (name.size() < process.size() + kEnd.size()) return 0;
  if (!name.starts_with(process) || !name.ends_with(kEnd)) return 0;
  name.remove_prefix(process.size());
  name.remove_suffix(kEnd.size());
  if (!name.starts_with('.')) return 0;
  name.remove_prefix(1);
  pid_t owner = 0;
  const auto [stop, error] = std::from_chars(name.data(), name.data() + name.size(), owner);
  return error == std::errc{} && stop == name.data() + name.size() ? owner : 0;
}

/// Returns the path of the socket that a file belongs to.
fs::path socketBehind(const fs::path& file) {
  return file.extension() == net::Listener::kLockEnd ? fs::path(file).replace_extension() : file;
}

bool isGone(pid_t process) { return process > 0 && kill(process, 0) != 0 && errno == ESRCH; }

// A process that this one cannot see may have that number and live: then its socket answers, or its
// lock is held, and both stay.
void removeLeftovers(const fs::path& directory, const std::string& process) {
  std::error_code ignored;
  std::set<fs::path> left;
  for (const fs::directory_entry& entry : fs::directory_iterator(directory, ignored)) {
    const fs::path socket = socketBehind(entry.path());
    if (isGone(ownerOf(socket.filename().string(), process))) left.insert(socket);
  }
  for (const fs::path& socket : left) net::Listener::removeLeftover(socketAt(socket));
}

}  // namespace

net::Address longestPeerAddress(const net::Address& manager, const std::string& process) {
  return socketOf(directoryOf(manager), process, kLargestNumber);
}

std::string portAsked(const std::string& process, std::uint16_t port) {
  return "give process '" + process + "' port " + std::to_string(port);
}

void requireHasPorts(const net::Address& manager, const std::string& process, std::uint16_t port) {
  if (port == 0 || manager.kind != net::Address::Kind::Unix) return;
  throw SetupError(portAsked(process, port),
                   "the global manager is at " + manager.text() +
                       ", where a process listens at a file and has no port",
                   "Leave the port out, or give the manager a tls:// address.");
}

net::Address peerAddress(const ManagerLink& link, const std::string& process, std::uint16_t port) {
  const net::Address& manager = link.address();
  if (manager.kind != net::Address::Kind::Unix) {
    net::Address here = link.here();
    here.port = port;
    return here;
  }
  const fs::path directory = directoryOf(manager);
  removeLeftovers(directory, process);
  return socketOf(directory, process, getpid());
}

net::Address addressOf(const ProcessRecord& process, const net::Address& manager) {
  if (process.addresses.empty()) {
    throw SetupError("reach process '" + process.name + "'", "it has no address", "Restart it.");
  }
  const auto address = net::Address::parse(process.addresses.front());
  const bool leavesTls = manager.kind == net::Address::Kind::Tls && address.kind != manager.kind;
  if (!leavesTls && (manager.insecure || !address.insecure)) return address;
  throw SetupError("connect to process '" + process.name + "'",
                   "it listens at " + address.text() + ", and the global manager is reached at " +
                       manager.text(),
                   "Start that process with the same address.");
}

}  // namespace suture
