#include <suture/codec/tallies.h>

namespace suture::codec {

void toWire(const Tally& tally, wire::Tally::Builder out) {
  out.setExecuted(tally.executed);
  out.setLate(tally.late);
  out.setRefused(tally.refused);
  out.setFailed(tally.failed);
  out.setReplaced(tally.replaced);
  out.setSuperseded(tally.superseded);
  out.setCancelled(tally.cancelled);
  out.setEventsDropped(tally.eventsDropped);
}

Tally fromWire(wire::Tally::Reader in) {
  return {.executed = in.getExecuted(),
          .late = in.getLate(),
          .refused = in.getRefused(),
          .failed = in.getFailed(),
          .replaced = in.getReplaced(),
          .superseded = in.getSuperseded(),
          .cancelled = in.getCancelled(),
          .eventsDropped = in.getEventsDropped()};
}

void toWire(const Earlier& earlier, wire::Earlier::Builder out) {
  toWire(earlier.tally, out.initTally());
  out.setEnded(earlier.ended);
}

Earlier fromWire(wire::Earlier::Reader in) { return {fromWire(in.getTally()), in.getEnded()}; }

}  // namespace suture::codec
