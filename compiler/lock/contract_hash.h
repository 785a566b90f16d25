#pragma once
// This sums up as one number what two ends of a connection must agree on.

#include <map>
#include <string>

#include "compiler/lock/schema/lock.h"

namespace suture::compiler::lock {

/// Returns a hash for each interface of the own headers, by qualified C++ name: 32 hexadecimal
/// digits (the first 128 bits of SHA-256) over its methods, events, state and all types they reach:
/// names, ids, ordinals, wire types, the annotations that change meaning, and what is a set.
/// Documentation, capacities, ranges and policies do not count. `schemas` come from upToDate().
std::map<std::string, std::string> contractHashes(const model::Model& model,
                                                  const std::map<std::string, Lock>& schemas);

/// Returns such hashes without optional commands: where these are equal, two ends may differ in
/// optional commands alone.
std::map<std::string, std::string> coreHashes(const model::Model& model,
                                              const std::map<std::string, Lock>& schemas);

}  // namespace suture::compiler::lock
