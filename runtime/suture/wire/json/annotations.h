#pragma once
// What a locked schema says beyond Cap'n Proto: schemas/suture/meta.capnp.

#include <capnp/schema.h>

#include <string>

namespace suture {

/// The name in the annotated header: "moving_frame", where the wire has "movingFrame".
std::string nameOf(capnp::StructSchema::Field field);
std::string nameOf(capnp::EnumSchema::Enumerant value);
/// "m", or "".
std::string unitOf(capnp::StructSchema::Field field);
/// "Float64" where bytes are such numbers, else "".
std::string bulkOf(capnp::StructSchema::Field field);
/// Returns the interface that a subscriber of the contract implements.
capnp::InterfaceSchema eventsOf(capnp::InterfaceSchema contract);
/// True for what travels with every command, beside its arguments.
bool isSent(capnp::StructSchema::Field field);
/// True for a field that only keeps the place of what is no longer declared.
bool isRemoved(capnp::StructSchema::Field field);

}  // namespace suture
