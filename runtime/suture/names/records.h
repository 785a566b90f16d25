#pragma once
// The global manager knows this of a process, as plain values.

#include <suture/base/frames.h>
#include <suture/codec/text.h>
#include <suture/manager.capnp.h>

#include <cstdint>
#include <string>
#include <vector>

namespace suture {

struct InterfaceRecord {
  std::string name;      ///< "Arm"
  std::string contract;  ///< "robots::Arm"
  std::string hash;      ///< the wire contract's
  Frames frames;
};

struct ComponentRecord {
  std::string name;
  std::vector<InterfaceRecord> provided, required;
};

struct ProcessRecord {
  std::string name;
  std::vector<std::string> addresses;  ///< best first
  std::int32_t pid = 0;
  std::string host;
  std::vector<ComponentRecord> components;
  std::uint64_t generation = 0;  ///< given by the manager; a name registered again has a higher one
  bool silent = false;           ///< given by the manager: it has not renewed its lease in time
};

/// Says why something did not happen, for a program and for a person.
struct Refusal {
  wire::Refusal::Kind kind;
  std::string text;  ///< what was asked, what was found, what to do
};

/// Return about how much memory a record takes.
std::size_t bytesOf(const std::vector<ComponentRecord>& components);
std::size_t bytesOf(const ProcessRecord& process);

void toWire(const std::vector<ComponentRecord>& components,
            capnp::List<wire::ComponentRecord>::Builder out);
void toWire(const ProcessRecord& process, wire::ProcessRecord::Builder out);
void toWire(const Frames& frames, wire::Frames::Builder out);
void toWire(const Refusal& refusal, wire::Refusal::Builder out);

std::vector<ComponentRecord> fromWire(capnp::List<wire::ComponentRecord>::Reader in);
ProcessRecord fromWire(wire::ProcessRecord::Reader in);
Frames fromWire(wire::Frames::Reader in);
Refusal fromWire(wire::Refusal::Reader in);
/// Returns a refusal as an exception that ends a promise.
kj::Exception refused(wire::Refusal::Reader in);

}  // namespace suture
