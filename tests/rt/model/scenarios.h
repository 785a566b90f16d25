#pragma once
// These are explored: small uses of each part between threads, in which every order can be tried.

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
Run eventQueue();
Run eventQueueOfTwo();
Run eventQueueOfOne();
Run eventQueueLatched();
Run eventQueueLarge();
Run eventQueueLargeOfOne();
Run doorbell();
Run doorbellForTwo();

}  // namespace model
