#pragma once
// This is a contract, learnt from the process that has it.

#include <capnp/schema-loader.h>
#include <capnp/schema.h>
#include <suture/peer.capnp.h>
#include "cli/values/json.h"

#include <string>
#include <vector>

namespace suture::cli {

/// A Member is one command or event.
struct Member {
  std::string name;  ///< as in C++
  std::string kind;  ///< "read"
  Json description;
  capnp::InterfaceSchema::Method method;
};

/// A Contract is what a process says of one of its interfaces. It may say anything: this refuses
/// what cannot be used.
class Contract {
 public:
  /// `title` is like "provider:Tally/Counter". Throws SetupError.
  Contract(std::string title, wire::Explanation::Reader explanation);

  const std::string& title() const { return title_; }
  /// Returns "counting::Counter".
  std::string name() const { return textAt(description_, "name"); }
  const Json& description() const { return description_; }
  /// Returns the text as it came.
  const std::string& descriptionText() const { return descriptionText_; }
  /// Returns the texts of the contracts that it derives from, the nearest first.
  const std::vector<std::string>& baseTexts() const { return baseTexts_; }

  capnp::InterfaceSchema interface() const { return interface_; }
  capnp::InterfaceSchema eventsInterface() const { return eventsInterface_; }

  const std::vector<Member>& commands() const { return commands_; }
  const std::vector<Member>& events() const { return events_; }
  /// Returns the bit by which a subscription asks for it; 0 if it has none.
  std::uint64_t bitOf(const Member& event) const;
  /// Returns null if there is none.
  const Member* findEvent(const std::string& name) const;
  /// These throw SetupError, with what there is.
  const Member& command(const std::string& name) const;
  const Member& event(const std::string& name) const;

 private:
  void takeTexts(wire::Explanation::Reader explanation);
  void loadSchema(wire::Explanation::Reader explanation);
  [[noreturn]] void refuseSchema(const std::string& fault) const;
  std::vector<Member> membersOf(const char* list, capnp::InterfaceSchema schema) const;
  [[noreturn]] void refuse(const char* word, const std::string& name,
                           const std::vector<Member>& existing) const;

  const std::string title_;
  std::string descriptionText_;
  Json description_;
  std::vector<std::string> baseTexts_;
  capnp::SchemaLoader loader_;
  capnp::InterfaceSchema interface_, eventsInterface_;
  std::vector<Member> commands_, events_;
};

}  // namespace suture::cli
