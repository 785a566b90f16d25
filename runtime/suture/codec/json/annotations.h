#pragma once
// This is what a locked schema says beyond Cap'n Proto: schemas/suture/meta.capnp.

#include <capnp/schema.h>

#include <string>

namespace suture::codec {

/// Return the name in the annotated header: "moving_frame", where the wire has "movingFrame".
std::string nameOf(capnp::StructSchema::Field field);
std::string nameOf(capnp::EnumSchema::Enumerant value);
/// Returns "m", or "".
std::string unitOf(capnp::StructSchema::Field field);
/// Returns "Float64" where bytes are such numbers, else "".
std::string bulkOf(capnp::StructSchema::Field field);
/// Returns the interface that a subscriber of the contract implements.
capnp::InterfaceSchema eventsOf(capnp::InterfaceSchema contract);
/// Returns true for what travels with every command, beside its arguments.
bool isSent(capnp::StructSchema::Field field);
/// Returns true for a field that only keeps the place of what is no longer declared.
bool isRemoved(capnp::StructSchema::Field field);

}  // namespace suture::codec
