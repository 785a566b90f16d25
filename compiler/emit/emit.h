#pragma once
// This turns the checked model into the text of every generated file.

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/lock/schema/lock.h"
#include "compiler/model/artefact.h"
#include "compiler/model/model.h"

namespace suture::compiler::emit {

using model::Artefact;

/// An Output is a file that is generated for each header: X.SUFFIX for X.h.
struct Output {
  const char* suffix;  ///< "suture.h"
  const char* use;     ///< "include", "compile", or only "read": what a build does with it

  bool isSource() const { return std::string_view(use) == "compile"; }
};

/// A schema has as many parts as there are sources of a kind, if these are several.
inline constexpr Output kPart = {"wire.capnp", "part"};

/// Says how many sources of each kind a big header gives, by its path: X.suture.cpp, then
/// X.suture.2.cpp. Any other gives one.
using Sources = std::map<std::string, unsigned>;

/// Generates the files of the model's own headers: for each header, all of outputs() in that order.
/// Foreign headers (own = false) serve as declarations only. The model must have passed check/ and
/// lock::check: nothing is verified again here. Equal input gives equal bytes.
std::vector<Artefact> emit(const model::Model& model, const lock::Locks& locks,
                           const Sources& sources = {});

/// Returns all kinds of file that emit() writes for any header, which kPart is not among.
std::vector<Output> outputs();

}  // namespace suture::compiler::emit
