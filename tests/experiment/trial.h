#pragma once
// This is one trial of the experiment: what it varies.

#include <suture/base/time.h>
#include <suture/lane/delay/connection_delay.h>

#include <cstdint>
#include <vector>

namespace experiment {

/// Says what is between the console and the operating table.
struct Link {
  /// There and back again; each way takes half of it.
  suture::Duration roundTrip{0};
  /// Each message may take longer by this share of a way's time.
  double jitter = 0;
  /// Chance of each message to be lost once. A stream sends it again, so it comes late.
  double loss = 0;

  bool operator==(const Link&) const = default;
};

enum class Inputs : std::uint8_t {
  Two,  ///< each hand leads one of the slaves
  One,  ///< the left hand leads both
};

struct Trial {
  Link link;
  bool fixtures = true;
  Inputs inputs = Inputs::Two;
  std::uint32_t seed = 1;
};

/// A slave moves this many metres a master metre, in every trial.
constexpr double kScale = 0.4;

/// Says what crosses the link on a connection: a message each `period`. So many connections with as
/// much share a stream, where each waits for what another has lost.
struct Traffic {
  std::uint64_t stream = 0;  ///< the link's stream in which it travels
  suture::Duration period{0};
  int sharing = 1;
};

/// Returns how much longer a message takes that a stream has to repeat: README.md.
suture::Duration repetitionTime(const Link& link, const Traffic& traffic);

/// Returns the link as it is put on a connection. Equal seeds give equal faults, at the same
/// moments to all of a stream.
suture::ConnectionDelay delayOf(const Link& link, const Traffic& traffic, std::uint64_t seed);

/// Returns 0 to 500 ms by 50 ms, without and with 10 % of jitter, with 0, 1, 5 and 10 % of loss,
/// with and without fixtures, with two inputs and one.
std::vector<Trial> fullGrid();
/// Returns the delays that the literature names, and either jitter or loss, or none.
std::vector<Trial> quickGrid();

}  // namespace experiment
