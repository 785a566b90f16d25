#include <fnmatch.h>
#include <suture/names/policy.h>

#include <algorithm>
#include <charconv>
#include <string_view>

namespace suture {
namespace {

using net::PeerIdentity;

constexpr std::string_view kProcess = "process:";
constexpr std::string_view kUser = "user:";

bool matches(const std::string& pattern, const std::string& name) {
  return fnmatch(pattern.c_str(), name.c_str(), FNM_NOESCAPE) == 0;
}

bool matchesAny(const std::vector<std::string>& patterns, const Endpoint& provided) {
  const std::string whole = provided.toString();
  const std::string here = provided.component + "/" + provided.interface;
  return std::any_of(patterns.begin(), patterns.end(), [&](const std::string& pattern) {
    return matches(pattern, pattern.find(':') == std::string::npos ? here : whole);
  });
}

std::optional<uid_t> userOf(const std::string& who) {
  uid_t user = 0;
  const char* const begin = who.data() + std::min(kUser.size(), who.size());
  const char* const end = who.data() + who.size();
  if (!who.starts_with(kUser)) return std::nullopt;
  const auto [stop, error] = std::from_chars(begin, end, user);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return user;
}

bool concerns(const std::string& who, const PeerIdentity& peer) {
  switch (peer.proof) {
    case PeerIdentity::Proof::None: return who == "tcp";
    case PeerIdentity::Proof::User:
      return who == "user:same" ? net::isTrusted(peer.user, {}) : userOf(who) == peer.user;
    case PeerIdentity::Proof::Certificate:
      return who.starts_with(kProcess) && matches(who.substr(kProcess.size()), peer.process);
  }
  return false;
}

}  // namespace

const Role* Policy::roleOf(const PeerIdentity& peer) const {
  const auto found = std::find_if(rules_->begin(), rules_->end(),
                                  [&](const Rule& rule) { return concerns(rule.who, peer); });
  return found == rules_->end() ? nullptr : &found->role;
}

bool Policy::admits(const PeerIdentity& peer) const { return !rules_ || roleOf(peer) != nullptr; }

Access Policy::access(const PeerIdentity& peer, const Endpoint& provided) const {
  if (!rules_) return Access::Full;
  const Role* const role = roleOf(peer);
  if (role == nullptr) return Access::None;
  if (matchesAny(role->full, provided)) return Access::Full;
  return matchesAny(role->read, provided) ? Access::Read : Access::None;
}

std::vector<uid_t> Policy::users() const {
  std::vector<uid_t> named;
  if (!rules_) return named;
  for (const Rule& rule : *rules_) {
    if (const auto user = userOf(rule.who)) named.push_back(*user);
  }
  return named;
}

}  // namespace suture
