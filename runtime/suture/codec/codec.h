#pragma once
// This says how the messages of a contract travel as Cap'n Proto: suturec writes it for each
// contract. Any thread may use a Codec, and all that one leads to has static storage.

#include <suture/loop/kj_comparisons.h>  // first

#include <capnp/any.h>
#include <capnp/schema.h>
#include <suture/base/errors.h>
#include <suture/base/slots/shared_slot.h>
#include <suture/base/time.h>
#include <suture/component/contract/wire_numbers.h>
#include <suture/rpc.capnp.h>
#include <suture/rt/state/state_table.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace suture::codec {

/// Converts a message that carries one slot, or nothing.
struct MessageCodec {
  void (*encode)(const std::byte* slot, capnp::AnyPointer::Builder out) =
      [](const std::byte*, capnp::AnyPointer::Builder) {};
  /// Fills a record's memory for the slot, which holds none. `shift` is added to stamps of the
  /// sender's steady clock to have them on this process's.
  Errc (*decode)(capnp::AnyPointer::Reader in, std::byte* slot, Duration shift) =
      [](capnp::AnyPointer::Reader, std::byte*, Duration) { return Errc{}; };
};

/// Finds where the parameters of a command say when it was sent, and whether it wants an answer.
struct SentCodec {
  wire::Sent::Builder (*in)(capnp::AnyPointer::Builder parameters);
  wire::Sent::Reader (*of)(capnp::AnyPointer::Reader parameters);
};

/// Finds the stamp of a message: the results of a read say when the value was produced, and the
/// parameters of an event when it was emitted. Results of other commands have no stamp. Stamps are
/// of the sender's steady clock, in ns.
struct StampCodec {
  void (*set)(capnp::AnyPointer::Builder message,
              std::int64_t stamp) = [](capnp::AnyPointer::Builder, std::int64_t) {};
  /// Returns 0 if the message does not say it.
  std::int64_t (*of)(capnp::AnyPointer::Reader message) = [](capnp::AnyPointer::Reader) {
    return std::int64_t{0};
  };
};

/// A command is a method of the interface of the contract that declares it.
struct CommandCodec {
  std::uint64_t interface;  ///< the id of that interface
  std::uint16_t method;
  SentCodec sent;
  MessageCodec arguments = {}, result = {};
  StampCodec stamp = {};
};

/// An event is a method of the events interface of each contract that has it.
struct EventCodec {
  std::uint16_t method;
  StampCodec stamp;
  MessageCodec payload = {};
};

/// Converts the state: method 0 of the events interface.
struct RowCodec {
  /// `slots[i]` is that of column i; columns without a value are skipped.
  void (*encode)(const rt::StateTable::Row& row, std::span<const std::byte* const> slots,
                 WireNumbers numbers, capnp::AnyPointer::Builder out);
  /// Fills the drafts of the columns that have come, and says which these are.
  rt::RowColumns (*decode)(capnp::AnyPointer::Reader in, WireNumbers numbers, Duration shift,
                           rt::StateTable& mirror);
  std::int64_t (*stamp)(capnp::AnyPointer::Reader in);  ///< by the sender's clock, ns
};

/// A Codec is what suturec writes for one contract.
struct Codec {
  capnp::InterfaceSchema (*schema)();
  std::uint64_t contract;                  ///< the id of its interface
  std::uint64_t subscriber;                ///< the id of the interface that hears its events
  std::span<const CommandCodec> commands;  ///< in the order of the contract's
  std::span<const EventCodec> events;
  RowCodec row;
};

// --- what the generated tables are made of

/// Makes the codec of a slot that is a message of its own struct.
template <class Struct, class Slot, void (*kEncode)(const Slot&, typename Struct::Builder),
          Errc (*kDecode)(typename Struct::Reader, Slot&, Duration)>
inline constexpr MessageCodec messageOf{
    .encode =
        [](const std::byte* slot, capnp::AnyPointer::Builder out) {
          kEncode(slotIn<Slot>(slot), out.initAs<Struct>());
        },
    .decode =
        [](capnp::AnyPointer::Reader in, std::byte* slot, Duration shift) {
          return kDecode(in.getAs<Struct>(), newSlot<Slot>(slot), shift);
        }};

template <class Parameters>
inline constexpr SentCodec sentIn{
    .in = [](capnp::AnyPointer::Builder out) { return out.getAs<Parameters>().initSent(); },
    .of = [](capnp::AnyPointer::Reader in) { return in.getAs<Parameters>().getSent(); }};

template <class Message>
inline constexpr StampCodec stampIn{
    .set = [](capnp::AnyPointer::Builder out,
              std::int64_t stamp) { out.getAs<Message>().setStamp(stamp); },
    .of = [](capnp::AnyPointer::Reader in) { return in.getAs<Message>().getStamp(); }};

/// A contract without reads has no columns.
template <class Row>
void encodeNoColumn(unsigned, const std::byte*, typename Row::Builder) {}
template <class Row>
Errc decodeNoColumn(typename Row::Reader, unsigned, std::byte*, Duration) {
  return Errc::Invalid;
}

/// `Parameters` is that of the method; each column's slot is a member of `Row`. A message has two
/// sets of columns: a column with a value that the contract does not admit is in both, because
/// older receivers know no third.
template <class Parameters, class Row,
          void (*kEncode)(unsigned, const std::byte*, typename Row::Builder) = encodeNoColumn<Row>,
          Errc (*kDecode)(typename Row::Reader, unsigned, std::byte*, Duration) =
              decodeNoColumn<Row>>
inline constexpr RowCodec rowOf{
    .encode =
        [](const rt::StateTable::Row& row, std::span<const std::byte* const> slots,
           WireNumbers numbers, capnp::AnyPointer::Builder message) {
          auto out = message.initAs<Parameters>().initRow();
          out.setStamp(toNanoseconds(row.stamp));
          out.setEvaluated(toWireNumbers(numbers, row.valid | row.invalid));
          out.setTooLarge(toWireNumbers(numbers, row.tooLarge | row.invalid));
          for (unsigned i = 0; i < slots.size(); ++i) {
            if (row.hasValue(i)) kEncode(i, slots[i], out);
          }
        },
    .decode =
        [](capnp::AnyPointer::Reader message, WireNumbers numbers, Duration shift,
           rt::StateTable& mirror) {
          const auto in = message.getAs<Parameters>().getRow();
          const rt::ColumnSet evaluated = fromWireNumbers(numbers, in.getEvaluated());
          const rt::ColumnSet tooLarge = fromWireNumbers(numbers, in.getTooLarge());
          rt::RowColumns columns{.valid = evaluated & ~tooLarge,
                                 .tooLarge = tooLarge & ~evaluated,
                                 .invalid = evaluated & tooLarge};
          for (unsigned i = 0; i < mirror.columns(); ++i) {
            if (columns.hasValue(i)) columns.enter(i, kDecode(in, i, mirror.draft(i), shift));
          }
          return columns;
        },
    .stamp =
        [](capnp::AnyPointer::Reader in) { return in.getAs<Parameters>().getRow().getStamp(); }};

template <class Contract>
capnp::InterfaceSchema schemaOf() {
  return capnp::Schema::from<Contract>();
}

}  // namespace suture::codec
