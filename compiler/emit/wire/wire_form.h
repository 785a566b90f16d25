#pragma once
// This is the C++ of one value's way between its slot and its Cap'n Proto form.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "compiler/emit/text/code.h"
#include "compiler/emit/text/context.h"

namespace suture::compiler::emit {

/// A WireValue is a value that is a field, a parameter or a result, and says where it lies on both
/// sides.
struct WireValue {
  const model::Type& type;
  std::string wireName;  ///< capnp's: "measuredCp"
  std::string slot;      ///< an lvalue: "slot.measured_cp"
  std::optional<std::pair<double, double>> range{};
  /// A receiver takes this, as C++ says it, where the sender does not know the value. Where it is
  /// empty, the receiver takes what the type gives.
  std::string preset{};
  /// Says that every sender knows it: where a struct or an array is missing, the message is wrong.
  bool isNeeded = false;
  /// Says how C++ calls it within the whole; empty where it is the whole, or a base class of it.
  std::string member{};
};

/// Returns what a type is made of, as the members of `slot`.
std::vector<WireValue> fieldValues(const model::Struct& type, const Context& context);

/// Returns what a command carries, as the members of `slot`.
std::vector<WireValue> argumentValues(const model::Command& command);

/// Returns what a command that has a result answers: it lies in the slot "slot".
std::vector<WireValue> resultValues(const model::Command& command);

/// Returns what an event carries, in the slot "slot".
std::vector<WireValue> payloadValues(const model::Event& event);

/// Returns a statement without its end: "toWire(slot.pose, out.initPose())". `out` is a struct
/// builder.
std::string encode(const WireValue& value, const std::string& out, const Context& context);

/// Emits how `values` are read from struct reader `in`. Returns what there is to say about the
/// outcome: an expression of type Errc, "Errc{}" when it cannot fail. `shift` is an expression of
/// type Duration.
std::string emitDecode(Code& code, const std::vector<WireValue>& values, const std::string& in,
                       const std::string& shift, const Context& context);

/// Does the same, and emits that the outcome is returned.
void emitDecodeAndReturn(Code& code, const std::vector<WireValue>& values, const std::string& in,
                         const std::string& shift, const Context& context);

/// Emits "const Errc error = ...;" of what emitDecode() returned, unless it is called so already.
void emitError(Code& code, const std::string& outcome);

/// Tells if decoding the type needs the shift of steady stamps.
bool usesShift(const model::Type& type);

/// Names the function from an enum's slot to capnp's enum: "wireMode", qualified where it is
/// another namespace's than the header's.
std::string enumEncoder(const std::string& enumName, const Context& context);
/// Returns "2" for the second level of nested lambdas, whose parameters must not hide the first's.
std::string depthSuffix(unsigned depth);

/// Returns the body of a lambda, to stand between its braces.
std::string lambdaBody(const std::string& statements);

}  // namespace suture::compiler::emit
