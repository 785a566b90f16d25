#include <capnp/message.h>
#include <capnp/serialize.h>
#include <fmt/format.h>
#include <suture/base/errors.h>

#include <array>
#include <cstring>
#include <stdexcept>

#include "bench/compiler/fast_cdr.h"
#include "bench/compiler/handwritten/record_conversions.h"
#include "bench/compiler/parts.h"
#include "bench/figures/table.h"
#include "bench/table2/sample_pose.h"
#include "bench/timed_loops.h"
#include "robot_types/pose.suture.h"
#include "support/allocations.h"

// These are the generated converters, which only generated code calls otherwise.
namespace robots {
void toWire(const PosePrmSlot& slot, wire::PosePrm::Builder out);
suture::Errc fromWire(wire::PosePrm::Reader in, PosePrmSlot& slot, suture::Duration shift);
void toWire(const PoseSampleSlot& slot, wire::PoseSample::Builder out);
suture::Errc fromWire(wire::PoseSample::Reader in, PoseSampleSlot& slot, suture::Duration shift);
}  // namespace robots

namespace bench {
namespace {

constexpr std::size_t kLength = 10000;
/// Loops of the contestants take turns, so that what disturbs the machine disturbs all alike.
constexpr std::size_t kTurn = 5;

using Scratch = std::array<capnp::word, 64>;

/// A Codec is one way to turn a record into the bytes of a message and back.
template <class Value, class Wire, class Conversion>
class RecordCodec {
 public:
  void encode(const Value& value) {
    capnp::MallocMessageBuilder message(kj::arrayPtr(scratch_.data(), scratch_.size()));
    Conversion::write(value, message.initRoot<Wire>());
    const auto segments = message.getSegmentsForOutput();
    bytes_ = segments[0].size();
    std::memcpy(message_.data(), segments[0].begin(), segments[0].asBytes().size());
  }
  void decode(Value& value) {
    const kj::ArrayPtr<const capnp::word> segments[] = {kj::arrayPtr(message_.data(), bytes_)};
    capnp::SegmentArrayMessageReader message(kj::arrayPtr(segments, 1));
    Conversion::read(message.getRoot<Wire>(), value);
  }

 private:
  Scratch scratch_{}, message_{};
  std::size_t bytes_ = 0;  // in words
};

template <class Slot>
struct Generated {
  static void write(const auto& value, auto out) {
    Slot slot;
    if (!store(value, slot)) throw std::logic_error("the record exceeds its own capacity");
    toWire(slot, out);
  }
  static void read(auto in, auto& value) {
    Slot slot;
    if (fromWire(in, slot, suture::Duration{0}) != suture::Errc{}) {
      throw std::logic_error("the record does not survive its own wire form");
    }
    load(slot, value);
  }
};

struct ByHand {
  static void write(const auto& value, auto out) { handwritten::write(value, out); }
  static void read(auto in, auto& value) { handwritten::read(in, value); }
};

void append(std::vector<double>& to, const Statistics& loops) { to.push_back(loops.p50); }

/// Compares both ways of both contestants: medians over turns.
template <class Value, class Slot, class Wire>
void compare(const char* title, const char* figure, const Value& value, std::size_t loops,
             Report& report, Table& table) {
  RecordCodec<Value, Wire, Generated<Slot>> generated;
  RecordCodec<Value, Wire, ByHand> byHand;
  Value target;
  const auto timed = [&](auto& codec) {
    return timedLoops(kTurn, kLength, [&] {
      keep(value);
      codec.encode(value);
      keep(codec);
      codec.decode(target);
      keep(target);
    });
  };
  std::vector<double> ours, theirs;
  timed(generated);  // what it owns is allocated once
  const std::uint64_t before = suture::allocations();
  generated.encode(value);
  generated.decode(target);
  const std::uint64_t allocated = suture::allocations() - before;
  for (std::size_t turn = 0; turn < loops / kTurn; ++turn) {
    append(ours, timed(generated));
    append(theirs, timed(byHand));
  }
  const Statistics mine = statisticsOf(ours), hand = statisticsOf(theirs);
  const std::string name = std::string("codec.") + figure;
  report.add(name + ".generated", "ns", mine);
  report.add(name + ".handwritten", "ns", hand);
  report.add(name + ".ratio", "x", mine.p50 / hand.p50);
  if (suture::countsAllocations()) {
    report.add(name + ".allocations", "allocations", static_cast<double>(allocated));
  } else {
    report.addUnavailable(name + ".allocations", "a sanitizer has malloc for itself");
  }
  table.row({title, number(mine.p50, 0), number(hand.p50, 0), number(mine.p50 / hand.p50, 2),
             suture::countsAllocations() ? std::to_string(allocated) : "?"});
}

robots::PoseSample sampleRecord() {
  robots::PoseSample record;
  record.position = {0.1, -0.02, 0.3};
  record.stamp = suture::now();
  record.sequence = 7;
  return record;
}

std::string slotRow(std::size_t loops, Report& report) {
  const robots::PosePrm value = samplePose();
  robots::PosePrmSlot slot;
  robots::PosePrm back;
  const auto copied = [&] {
    return timedLoops(kTurn, kLength, [&] {
      keep(value);
      if (!store(value, slot)) throw std::logic_error("the pose exceeds its own capacity");
      keep(slot);
      load(slot, back);
      keep(back);
    });
  };
  std::vector<double> ours, theirs;
  for (std::size_t turn = 0; turn < loops / kTurn; ++turn) {
    append(ours, copied());
    const auto rival = fastCdrBothWays(value, kTurn, kLength);
    if (!rival) {
      const char* const reason =
          "Fast CDR was not there when this program was built: run .ci/install tests, configure "
          "and build again";
      report.addUnavailable("slot", reason);
      return fmt::format("The slot copy cannot be compared: {}\n", reason);
    }
    append(theirs, *rival);
  }
  const Statistics mine = statisticsOf(ours), fastCdr = statisticsOf(theirs);
  report.add("slot.copy", "ns", mine);
  report.add("slot.fast_cdr", "ns", fastCdr);
  report.add("slot.gain", "x", fastCdr.p50 / mine.p50);
  return fmt::format("PosePrm both ways: slot {:.0f} ns, Fast CDR {:.0f} ns, {:.1f} x faster\n",
                     mine.p50, fastCdr.p50, fastCdr.p50 / mine.p50);
}

}  // namespace

std::string codecRows(const CompilerOptions& options, Report& report) {
  Table table(1);
  table.row({"encode + decode, ns", "generated", "by hand", "ratio", "allocations"});
  table.line();
  compare<robots::PoseSample, robots::PoseSampleSlot, robots::wire::PoseSample>(
      "PoseSample", "pose_sample", sampleRecord(), options.codecLoops(), report, table);
  compare<robots::PosePrm, robots::PosePrmSlot, robots::wire::PosePrm>(
      "PosePrm", "pose_prm", samplePose(), options.codecLoops(), report, table);
  return table.toString() + slotRow(options.codecLoops(), report);
}

}  // namespace bench
