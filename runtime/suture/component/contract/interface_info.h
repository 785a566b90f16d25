#pragma once
// The runtime knows this of a contract: plain tables that suturec writes.

#include <suture/annotate.h>
#include <suture/base/field_path.h>
#include <suture/base/slots/bounded_level.h>
#include <suture/base/time.h>
#include <suture/component/contract/wire_numbers.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace suture::codec {
struct Codec;
}

namespace suture {

enum class CommandKind : std::uint8_t { Void, Write, Read, QualifiedRead, VoidReturn, WriteReturn };

/// Says how long within() waits for the answer of a command that states no deadline().
inline constexpr Duration kDefaultDeadline = std::chrono::seconds(1);

using StampShift = void (*)(std::byte* slot, Duration shift);

/// Returns false for a value that the contract does not admit: NaN, out of range(), an enumerator
/// that it does not declare. The slot may have any bytes. If `path` is not null, it gets the first
/// part of the value that is invalid.
using ValueCheck = bool (*)(const std::byte* slot, FieldPath* path);

struct CommandInfo {
  const char* name;  ///< as in C++: "servo_cp"
  CommandKind kind;
  std::uint32_t argumentsSize = 0;       ///< bytes of the arguments' slot; 0: none
  std::uint32_t resultSize = 0;          ///< bytes of the result's slot; 0: none
  std::uint32_t depth;                   ///< how many may wait at the provider
  bool latest = false;                   ///< the newest one wins
  Duration ttl{0};                       ///< discarded when older; 0: never
  int column = -1;                       ///< a read's column in the state table; -1: not a read
  Duration deadline = kDefaultDeadline;  ///< how long within() waits without a limit
  // A value that owns memory has a counted pointer in its record, see base/slots/shared_slot.h.
  bool sharedArguments = false, sharedResult = false;
  /// True for concurrent() and direct(): a client in the provider's process, without delay between
  /// the two, calls it in its own thread.
  bool inCallersThread = false;
  ValueCheck accepts = nullptr, acceptsResult = nullptr;  ///< null: it admits all
  // These shift the stamps in a slot, of any bytes, to another clock; null: it has none.
  StampShift shiftArguments = nullptr, shiftResult = nullptr;
  // These say what need not be copied of a slot with large lists.
  BoundedLevels argumentsLevels = {}, resultLevels = {};

  /// Returns true if a peer that may only read may call it.
  bool reads() const { return kind == CommandKind::Read || kind == CommandKind::QualifiedRead; }

  /// Checks the arguments; `path` then begins with the name of the command.
  bool admits(const std::byte* arguments, FieldPath* path = nullptr) const {
    return accepts == nullptr || accepts(arguments, path) || refusedAt(path, name);
  }
  bool admitsResult(const std::byte* result, FieldPath* path = nullptr) const {
    return acceptsResult == nullptr || acceptsResult(result, path) || refusedAt(path, name);
  }
};

/// An EventSet holds some of a contract's events, one bit each.
using EventSet = std::uint64_t;

struct EventInfo {
  const char* name;
  std::uint32_t payloadSize = 0;
  std::uint32_t depth;
  bool latest = false;
  bool latched = false;
  bool sharedPayload = false;         ///< as in CommandInfo
  ValueCheck accepts = nullptr;       ///< as in CommandInfo
  StampShift shiftPayload = nullptr;  ///< as in CommandInfo
  BoundedLevels payloadLevels = {};   ///< as in CommandInfo

  /// Checks the payload; `path` then begins with the name of the event.
  bool admits(const std::byte* payload, FieldPath* path = nullptr) const {
    return accepts == nullptr || accepts(payload, path) || refusedAt(path, name);
  }
};

/// Returns the table of a contract that derives from another, of N rows: the base's, then its own.
template <std::size_t N, class Row, std::size_t Own>
std::array<Row, N> extended(std::span<const Row> base, const Row (&own)[Own]) {
  std::array<Row, N> rows{};
  std::copy(std::begin(own), std::end(own), std::copy_n(base.begin(), N - Own, rows.begin()));
  return rows;
}

/// Describes one contract. All members have static storage.
struct InterfaceInfo {
  const char* name;         ///< qualified C++ name: "robots::Arm"
  const char* hash;         ///< the wire contract's; equal hashes are compatible
  const char* description;  ///< JSON: types, units, documentation
  std::span<const CommandInfo> commands;
  std::span<const EventInfo> events;
  const codec::Codec& (*codec)();  ///< how the contract travels as Cap'n Proto
  /// Returns the contract that this one derives from, or is null. That contract's commands, events
  /// and columns are the first of this one's.
  const InterfaceInfo& (*base)() = nullptr;
  void* (*toBase)(void* implementation) = nullptr;  ///< converts from this contract to its base
  WireNumbers wireEvents = {}, wireColumns = {};    ///< empty if they equal the places here
};

/// Returns the bytes of the largest slot of a contract that is copied whole; what counted pointers
/// lead to is not.
std::uint32_t largestSlot(const InterfaceInfo& info);

/// This makes the InterfaceInfo::toBase of a contract and its base.
template <class Contract, class Base>
void* castToBase(void* implementation) {
  return static_cast<Base*>(static_cast<Contract*>(implementation));
}

/// Returns the tables of `Contract`. Each contract's generated header "X.suture.h" declares its
/// own.
template <class Contract>
const InterfaceInfo& interfaceInfo() {
  return Generated<Contract>::template result<const InterfaceInfo&>();
}

}  // namespace suture
