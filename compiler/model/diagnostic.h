#pragma once
// This is a finding about the model. check/ and lock/ produce them; the frontend, which still has
// the source, prints them in clang's form with caret and help.

#include <string>
#include <vector>

#include "compiler/model/type.h"

namespace suture::compiler::model {

struct Note {
  Source source;
  std::string text;
};

/// Is a change of the header that settles a finding.
struct Fix {
  enum class Place { Before, After, Instead };  ///< of what `source` spans

  Source source;
  Place place = Place::Before;
  std::string text;
};

struct Diagnostic {
  enum class Severity { Error, Warning };

  Source source;
  std::string slug;  ///< "pointer-field": printed as [suture-pointer-field]
  std::string
      message;       ///< what was found: "field 'p' has pointer type 'int *'; ownership is unknown"
  std::string help;  ///< what to do; printed as a note
  std::vector<Note> notes;
  Severity severity = Severity::Error;
  std::vector<Fix> fixes{};  ///< all of them together
};

using Diagnostics = std::vector<Diagnostic>;

}  // namespace suture::compiler::model
