#pragma once
// The explorer runs these. Each uses one part from a few threads, and is so small that every order
// of their steps can be tried.

#include <functional>

#include "rt/model/explorer.h"

namespace model {

Run spscRing();
Run mpscRing();
Run latestCell();
Run mailboxOrder();
Run mailboxCredits();
Run mailboxRoom();
Run stateRow();
Run stateOrder();
Run snapshot();
Run eventQueue();
Run eventQueueOfTwo();
Run eventQueueOfOne();
Run eventQueueLatched();
Run eventQueueLarge();
Run eventQueueLargeOfOne();
Run doorbell();
Run doorbellForTwo();

}  // namespace model
