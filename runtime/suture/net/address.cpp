#include <arpa/inet.h>
#include <netinet/in.h>
#include <suture/net/address.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstring>

namespace suture::net {
namespace {

constexpr std::string_view kUnix = "unix:";
constexpr std::string_view kTcp = "tcp://";
constexpr std::string_view kTls = "tls://";
constexpr std::string_view kInsecure = "?insecure";

[[noreturn]] void refuse(const std::string& text, const std::string& found, const char* remedy) {
  throw SetupError("use the address '" + text + "'", found, remedy);
}

void requireFits(const std::string& text, const std::string& path) {
  const std::size_t room = sizeof(sockaddr_un::sun_path) - 1;
  if (path.size() <= room) return;
  refuse(text,
         "its path has " + std::to_string(path.size()) + " characters and a socket's may have " +
             std::to_string(room),
         "Choose a shorter directory for the manager's socket, for example under /tmp: processes "
         "listen there too.");
}

bool isLoopback(const std::string& host) {
  in_addr four;
  if (inet_pton(AF_INET, host.c_str(), &four) == 1) return (ntohl(four.s_addr) >> 24) == 127;
  return host == "::1";
}

bool isNumber(const std::string& host) {
  in6_addr any;
  return inet_pton(AF_INET, host.c_str(), &any) == 1 ||
         inet_pton(AF_INET6, host.c_str(), &any) == 1;
}

// Returns false for what inet_aton() takes for a number, such as 127.1 or 0x7f.1, because a name
// service takes it for one too.
bool isName(const std::string& host) {
  constexpr std::size_t kLongest = 253;
  const auto mayBe = [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '-' || c == '.' || c == '_';
  };
  const std::string_view last = std::string_view(host).substr(host.rfind('.') + 1);
  return !last.empty() && host.size() <= kLongest &&
         std::isalpha(static_cast<unsigned char>(last.front())) != 0 &&
         std::all_of(host.begin(), host.end(), mayBe);
}

Address parseUnix(const std::string& text) {
  Address address;
  address.path = text.substr(kUnix.size());
  if (address.path.empty()) refuse(text, "it has no path", "Write unix:/path/to/socket.");
  if (address.path.find(',') != std::string::npos) {
    refuse(text, "its path has a comma, which separates addresses", "Name one, without a comma.");
  }
  requireFits(text, address.path);
  return address;
}

void parsePort(Address& address, const std::string& text, std::string_view hostAndPort) {
  const std::size_t colon = hostAndPort.rfind(':');
  const char* const end = hostAndPort.data() + hostAndPort.size();
  const char* const digits = colon == std::string_view::npos ? end : hostAndPort.data() + colon + 1;
  const auto [stop, error] = std::from_chars(digits, end, address.port);
  if (error != std::errc{} || stop != end) {
    refuse(text, "it has no port between 0 and 65535", "Write tcp://127.0.0.1:7700.");
  }
  address.host = hostAndPort.substr(0, colon);
  if (address.host.starts_with('[') && address.host.ends_with(']')) {
    address.host = address.host.substr(1, address.host.size() - 2);
  }
  if (address.host == "localhost") address.host = "127.0.0.1";
  if (isNumber(address.host) || isName(address.host)) return;
  refuse(text, "its host is neither a number nor a name",
         "Use 127.0.0.1, the number or the name of the other machine, or unix:/path.");
}

Address parseTls(const std::string& text) {
  Address address;
  address.kind = Address::Kind::Tls;
  parsePort(address, text, std::string_view(text).substr(kTls.size()));
  return address;
}

Address parseTcp(const std::string& text) {
  Address address;
  address.kind = Address::Kind::Tcp;
  std::string_view rest = std::string_view(text).substr(kTcp.size());
  if (rest.ends_with(kInsecure)) {
    address.insecure = true;
    rest.remove_suffix(kInsecure.size());
  }
  parsePort(address, text, rest);
  if (address.insecure || isLoopback(address.host)) return address;
  refuse(text, "plain TCP carries no proof of who is talking, and this is not a loopback address",
         "Use tls:// with keys from suture keys, 127.0.0.1, or unix:/path. On a network that only "
         "you can reach, and where everybody may command the robot, add ?insecure.");
}

}  // namespace

Address Address::parse(const std::string& text) {
  if (text.starts_with(kUnix)) return parseUnix(text);
  if (text.starts_with(kTcp)) return parseTcp(text);
  if (text.starts_with(kTls)) return parseTls(text);
  refuse(text, "it begins with neither unix:, tls:// nor tcp://",
         "Write unix:/path, tls://host:7700 or tcp://127.0.0.1:7700.");
}

std::string Address::text() const {
  if (kind == Kind::Unix) return std::string(kUnix) + path;
  const bool six = host.find(':') != std::string::npos;
  return std::string(kind == Kind::Tls ? kTls : kTcp) + (six ? "[" + host + "]" : host) + ":" +
         std::to_string(port) + std::string(insecure ? kInsecure : "");
}

bool Address::isLoopback() const { return kind != Kind::Unix && net::isLoopback(host); }

bool Address::isNumeric() const { return kind == Kind::Unix || isNumber(host); }

std::vector<Address> parseAddresses(const std::string& text) {
  std::vector<Address> all;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    all.push_back(Address::parse(text.substr(begin, end - begin)));
    if (all.back().kind != all.front().kind || all.back().insecure != all.front().insecure) {
      refuse(text, "'" + all.front().text() + "' and '" + all.back().text() + "' differ in kind",
             "List addresses of one kind.");
    }
    begin = end + 1;
  }
  return all;
}

Address localAddress(const Address& far, int socket) {
  Address here = far;
  here.port = 0;
  sockaddr_storage bound{};
  socklen_t length = sizeof(bound);
  char host[INET6_ADDRSTRLEN] = "";
  if (far.kind == Address::Kind::Unix ||
      getsockname(socket, reinterpret_cast<sockaddr*>(&bound), &length) != 0) {
    return here;
  }
  const void* const number =
      bound.ss_family == AF_INET6
          ? static_cast<const void*>(&reinterpret_cast<sockaddr_in6&>(bound).sin6_addr)
          : &reinterpret_cast<sockaddr_in&>(bound).sin_addr;
  if (inet_ntop(bound.ss_family, number, host, sizeof(host)) != nullptr) here.host = host;
  return here;
}

SocketAddress::SocketAddress(const Address& address) {
  if (address.kind == Address::Kind::Unix) {
    requireFits(address.text(), address.path);
    auto& local = reinterpret_cast<sockaddr_un&>(storage);
    local.sun_family = AF_UNIX;
    std::memcpy(local.sun_path, address.path.c_str(), address.path.size() + 1);
    length = sizeof(local);
  } else if (auto& four = reinterpret_cast<sockaddr_in&>(storage);
             inet_pton(AF_INET, address.host.c_str(), &four.sin_addr) == 1) {
    four.sin_family = AF_INET;
    four.sin_port = htons(address.port);
    length = sizeof(four);
  } else {
    auto& six = reinterpret_cast<sockaddr_in6&>(storage);
    if (inet_pton(AF_INET6, address.host.c_str(), &six.sin6_addr) != 1) {
      refuse(address.text(), "its host is a name", "Use the host's number.");
    }
    six.sin6_family = AF_INET6;
    six.sin6_port = htons(address.port);
    length = sizeof(six);
  }
}

}  // namespace suture::net
