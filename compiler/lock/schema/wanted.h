#pragma once
// This is what a header asks of the wire before any lock has a say: nodes and members without
// ordinals.

#include <optional>
#include <string>
#include <vector>

#include "compiler/lock/schema/lock.h"
#include "compiler/model/lookup.h"

namespace suture::compiler::lock {

struct WantedMember {
  Member member;
  std::string title;  ///< "field 'robots::Pose::x'", as messages say it
  std::optional<std::string> was;
  model::Source source;
};

struct WantedNode {
  Node node;  ///< without members, which stand below
  std::string cxxName;
  std::string title;  ///< "struct 'robots::Pose'"
  std::vector<WantedMember> members;
  std::optional<std::string> was;  ///< the former C++ name, qualified
  model::Source source;
};

/// What travels with every command has this type, behind the parameters that it was first locked
/// with.
inline constexpr char kSent[] = "/suture/rpc.capnp:Sent";

/// Returns the nodes in the order enums, composites, structs, interfaces; each interface is
/// followed by its events and its state row.
std::vector<WantedNode> wanted(const model::Header& header, const model::Lookup& lookup);

/// Says that two composites of one header have one name and are not alike: the name tells what one
/// is made of, and not always where its parts end.
struct CompositeClash {
  WantedNode first, second;  ///< each with the source of what has it
};

/// Returns what wanted() has only the first of.
std::vector<CompositeClash> compositeClashes(const model::Header& header,
                                             const model::Lookup& lookup);

/// Says what value `index` of an event's payload is called on the wire: "value", "value2",
/// "value3".
std::string payloadName(std::size_t index);

/// Returns the id that a new thing receives.
std::uint64_t freshId(const std::string& project, const std::string& name);

/// Returns what makes two nodes the same thing in header and lock: "cxx \"robots::Pose\"".
std::string identity(const Node& node);

/// Returns the identity that a node had under the name of its was(), or "" if it has none.
std::string formerIdentity(const WantedNode& wanted);

}  // namespace suture::compiler::lock
