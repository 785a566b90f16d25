#pragma once
// These make exceptions for promises. What they say may reach a peer, so it is only our text: no
// source path, no failed expression.

#include <kj/exception.h>

#include <string>

namespace suture::loop {

/// Returns a rejection with a text for people.
kj::Exception failure(kj::Exception::Type type, const std::string& text);

/// Returns a rejection that says that the peer is gone, or must go.
inline kj::Exception disconnected(const std::string& text) {
  return failure(kj::Exception::Type::DISCONNECTED, text);
}

/// Returns true if the peer sent the rejection, and this process did not make it.
bool isRemote(const kj::Exception& exception);

/// Returns what went wrong, without the library's prefixes ("remote exception: ").
std::string describe(const kj::Exception& exception);

}  // namespace suture::loop
