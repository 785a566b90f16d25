#pragma once
// This goes over the wire of a frame link: headers, each with a payload behind it.

#include <suture/base/words.h>
#include <suture/rt/state/row_columns.h>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace suture::frame {

enum class Kind : std::uint8_t {
  // client to provider
  Command,    ///< number: which; payload: its arguments' slot
  Subscribe,  ///< payload: Subscription
  // provider to client
  Reply,  ///< call, error; payload: the result's slot, if there is no error
  Event,  ///< number: which; call: of which subscription; payload: its slot
  Row,    ///< payload: RowColumns, and the slots of those that are valid, each filled up to words
  Taken,  ///< number: a command; call: how many more of it may be sent
  Tally,  ///< payload: suture::Tally, the outcomes of all commands so far
  // both
  Acknowledge,  ///< nothing but `acknowledged`
  Piece,  ///< kMostPayload bytes of the payload of the connection's next frame of another kind,
          ///< which brings the end of it; number: that kind; call: bytes of the whole payload
};
inline constexpr unsigned kKinds = 9;

/// No frame has a larger payload: a larger one travels in pieces, between which the link's other
/// connections send.
inline constexpr std::size_t kMostPayload = std::size_t{64} << 10;

/// A Header is little-endian, as is every machine that this runs on.
struct Header {
  std::uint32_t checksum = 0;      ///< CRC-32C of the rest of the header and of the payload
  std::uint32_t size = 0;          ///< the payload's bytes, without the padding to whole words
  std::uint32_t epoch = 0;         ///< the link's epoch
  std::uint32_t sequence = 0;      ///< 1, 2, ... in each direction
  std::uint32_t acknowledged = 0;  ///< how many frames of the connection its sender has taken,
                                   ///< except
                                   ///< Acknowledge
  Kind kind{};
  std::uint8_t error = 0;  ///< an Errc
  std::uint16_t number = 0;
  std::uint32_t call = 0;
  std::uint32_t connection = 0;  ///< the connection's number on the link
  std::int64_t stamp = 0;        ///< the sender's steady clock, ns
};
static_assert(sizeof(Header) == 40 && std::is_trivially_copyable_v<Header>);
static_assert(sizeof(rt::RowColumns) == 24 && std::is_trivially_copyable_v<rt::RowColumns>);
static_assert(std::endian::native == std::endian::little);

struct Subscription {
  std::uint64_t events;   ///< one bit for each
  std::uint64_t joining;  ///< those of which the last value comes first, if they are latched
  std::uint64_t columns;  ///< those of the state that the client reads
};

/// The largest frame has this many bytes.
inline constexpr std::size_t kMostFrame = sizeof(Header) + kMostPayload;
static_assert(kMostPayload == wordBytes(kMostPayload));

/// Says why a link no longer accepts frames of its peer.
enum class Fault : std::uint8_t { None, Checksum, Size, Epoch, Sequence, Kind };

/// Returns "a frame is damaged", ...
const char* toString(Fault fault);

}  // namespace suture::frame
