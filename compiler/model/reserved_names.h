#pragma once
// These are names that Cap'n Proto, its C++ or suturec itself needs on the wire. What has such a
// name in C++ gets a word more there, unless its name() says otherwise.

#include <string>
#include <string_view>

namespace suture::compiler::model {

enum class Named { Type, Contract, Enumerator, Command, Read, Parameter, Event };

/// Tells if nothing of that kind can have this name on the wire.
bool isReserved(Named kind, std::string_view wireName);

/// Turns "Text" into "TextType", "eof" into "eofValue"; a name that is not reserved is unchanged.
std::string freeName(Named kind, std::string wireName);

}  // namespace suture::compiler::model
