#include <suture/peer.capnp.h>
#include <suture/session/provider/admission.h>

#include <algorithm>

namespace suture {
namespace {

using Kind = wire::Refusal::Kind;

constexpr std::size_t kLongestName = 256;

}  // namespace

std::optional<Refusal> Admission::whyNotNames(Names names) const {
  const auto longest = std::max_element(
      names.begin(), names.end(), [](auto one, auto other) { return one.size() < other.size(); });
  if (longest->size() <= kLongestName) return std::nullopt;
  return Refusal{Kind::LIMIT_REACHED,
                 "talk to process '" + process_ + "': the caller gives a name of " +
                     std::to_string(longest->size()) + " bytes, and none may have more than " +
                     std::to_string(kLongestName) + ". Choose a shorter one."};
}

std::optional<Refusal> Admission::whyNotVersion(std::uint16_t theirs) const {
  if (theirs == wire::PROTOCOL_VERSION) return std::nullopt;
  return Refusal{Kind::VERSION_MISMATCH, "talk to process '" + process_ + "': it speaks version " +
                                             std::to_string(wire::PROTOCOL_VERSION) +
                                             " of the protocol, the caller version " +
                                             std::to_string(theirs) +
                                             ". Build both from the same release."};
}

std::optional<Refusal> Admission::whyNotProcess(const std::string& name) const {
  if (who_.mayBe(name)) return std::nullopt;
  return Refusal{Kind::NOT_PERMITTED, "talk to process '" + process_ +
                                          "': the caller says that it is '" + name +
                                          "' and has the certificate of " + who_.text() +
                                          ". Give it its own name or its own keys."};
}

std::optional<Refusal> Admission::whyNotInterface(const Endpoint& endpoint) const {
  if (policy_.access(who_, endpoint) != Access::None) return std::nullopt;
  return Refusal{Kind::NOT_PERMITTED, "use '" + endpoint.toString() + "': the policy of process '" +
                                          endpoint.process + "' does not give it to " +
                                          who_.text() + ". Add it to the role of that rule."};
}

bool Admission::mayOnlyRead(const Endpoint& endpoint) const {
  return policy_.access(who_, endpoint) == Access::Read;
}

}  // namespace suture
