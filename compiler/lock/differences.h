#pragma once
// This tells two versions of a schema apart, and is the only place that judges an edit: a build,
// `--update-lock` and `suturec diff` say what stands here.

#include <string>
#include <vector>

#include "compiler/lock/schema/lock.h"

namespace suture::compiler::lock {

/// Says what peers of the two versions meet.
enum class Effect {
  None,      ///< nothing: they understand each other
  Refusals,  ///< they understand each other, and refuse some values
  Break      ///< they misread or miss something
};

/// Says what kind of thing an edit has changed.
enum class Change {
  New,
  Removed,
  Renamed,  ///< on the wire
  Kind,     ///< a struct became an enum, say
  Type,
  Meaning,    ///< an annotation that says what bytes mean (kMeaningful)
  Limit,      ///< a range, a capacity
  Policy,     ///< any other annotation: a queue, `latest()`, the name in C++
  Default,    ///< as C++ has it; the schema's own default never changes while the type stays
  Parameter,  ///< one is gone
  Base,
  Version,
  Identity  ///< what no header can cause: a place, an id or a major is another
};

/// Points to where a schema says it; null where it says nothing.
struct LockPlace {
  const Node* node = nullptr;
  const Member* member = nullptr;
};

/// Points into both locks, which must outlive it.
struct Difference {
  Change change = Change::New;
  Effect effect = Effect::None;
  LockPlace before, now;
  std::string part;     ///< of a parameter or result: "'speed'"; else ""
  std::string what;     ///< the annotation: "unit"
  std::string subject;  ///< "'x' of struct Pose"
  std::string detail;   ///< ": unit \"mm\" instead of \"m\"", or " is new"
  std::string hint;     ///< what to do if something else was meant

  /// "'x' of struct Pose: unit \"mm\" instead of \"m\"".
  std::string text() const { return subject + detail + (hint.empty() ? "" : "; " + hint); }
  /// What `suturec diff` and `--update-lock` print: "breaks:  " and the text.
  std::string line() const;
};

/// In the order of the old version's text, what is new behind it.
std::vector<Difference> differences(const Lock& old, const Lock& now);

}  // namespace suture::compiler::lock
