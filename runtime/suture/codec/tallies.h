#pragma once
// With these messages two processes tell each other of the commands of a connection.

#include <suture/component/channel/counts/ledger.h>
#include <suture/peer.capnp.h>

namespace suture::codec {

void toWire(const Tally& tally, wire::Tally::Builder out);
Tally fromWire(wire::Tally::Reader in);

void toWire(const Earlier& earlier, wire::Earlier::Builder out);
Earlier fromWire(wire::Earlier::Reader in);

}  // namespace suture::codec
