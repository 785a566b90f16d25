#pragma once
// These are programs of a few lines of which it is known what can come out: what the explorer must
// show, and what it must not.

#include "rt/model/explorer.h"

namespace model::litmus {

Run twoWritersOfOnePlace();
Run twoWritersOfTwoPlaces();
Run lostUpdate();
Run noLostUpdate();
Run messageReleased();
Run messageNotReleased();
Run storeBuffering();
Run storeBufferingSequential();
Run readTwice();

}  // namespace model::litmus
