#pragma once
// These convert texts of messages to and from this process's own.

#include <capnp/blob.h>

#include <string>

namespace suture::codec {

/// Refers to `text`, which must outlive it.
inline kj::StringPtr textOf(const std::string& text) { return {text.c_str(), text.size()}; }
inline std::string stringOf(capnp::Text::Reader text) { return {text.begin(), text.size()}; }

}  // namespace suture::codec
