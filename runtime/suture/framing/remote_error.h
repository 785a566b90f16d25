#pragma once
// With this an Errc travels as an exception of a remote call.

#include <kj/exception.h>
#include <suture/base/errors.h>
#include <suture/base/field_path.h>

#include <string>

namespace suture::framing {

/// Returns the rejection that tells `error` to the caller, as a number and in words. `invalid` says
/// which part of a value it is about, if that is known.
kj::Exception remoteError(Errc error, const FieldPath& invalid = {});

/// Returns how a remote call ended. What neither remoteError() nor this build knows, as a broken
/// connection, is OutcomeUnknown: the call may have run.
Errc errcOf(const kj::Exception& exception);

/// Returns the same in words: the peer's own if it has said more than an Errc.
std::string reasonOf(const kj::Exception& exception);

}  // namespace suture::framing
