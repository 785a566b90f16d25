#pragma once

namespace peers {

/// Peers that discover their servers implement Client::reaches() by this. `answered(back)` waits
/// for an answer and returns false if none came: answers to what was sent earlier are passed over.
template <class Value, class Answered>
bool comesBack(const Value& sent, const Answered& answered) {
  Value back;
  while (answered(back)) {
    if (back.timestamp == sent.timestamp) return true;
  }
  return false;
}

}  // namespace peers
