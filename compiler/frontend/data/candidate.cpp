#include "compiler/frontend/data/candidate.h"

#include <clang/AST/DeclFriend.h>

#include <algorithm>

#include "compiler/frontend/ast/names.h"

namespace suture::compiler::frontend {
namespace {

/// Tells if the class has SUTURE_FRIEND().
bool hasFriend(const clang::CXXRecordDecl* record) {
  for (const clang::FriendDecl* one : record->friends()) {
    const clang::NamedDecl* name = one->getFriendDecl();
    if (name && qualifiedName(name) == "suture::Members") return true;
  }
  return false;
}

/// Tells if each member of an anonymous union or struct is skipped by its own name.
bool isSkippedWhole(const clang::FieldDecl* field, const std::vector<Candidate>& listed) {
  const clang::RecordDecl* const record = field->getType()->getAsRecordDecl();
  if (!field->isAnonymousStructOrUnion() || record == nullptr) return false;
  return std::all_of(record->field_begin(), record->field_end(), [&](const clang::FieldDecl* part) {
    return isSkippedWhole(part, listed) ||
           std::any_of(listed.begin(), listed.end(), [&](const Candidate& one) {
             return one.field == part && one.annotation.skip;
           });
  });
}

/// Returns the members that SUTURE_EXTERNAL_TYPE means; findings about those that it lists appear
/// there.
std::vector<Candidate> externalCandidates(const DataDeclaration& declared, Mapping& mapping) {
  std::vector<Candidate> listed;
  for (const ExternalMember& member : declared.external->members) {
    mapping.addForeign(member.field, member.place, nullptr);
    listed.push_back({member.field, member.annotation, true, false});
  }
  if (!meansAll(*declared.external)) return listed;
  std::vector<Candidate> all;
  for (const clang::FieldDecl* field : declared.record->fields()) {
    if (field->isUnnamedBitField()) continue;  // it has no value
    const auto own = std::find_if(listed.begin(), listed.end(),
                                  [&](const Candidate& one) { return one.field == field; });
    if (own != listed.end()) {
      all.push_back(*own);
    } else if (field->getAccess() == clang::AS_public && !isSkippedWhole(field, listed)) {
      mapping.addForeign(field, field->getLocation(), declared.place);
      all.push_back({field, {}, true, false});
    }
  }
  return all;
}

}  // namespace

bool meansAll(const Annotation& external) { return external.all || external.members.empty(); }

std::vector<Candidate> candidatesOf(const DataDeclaration& declared, Mapping& mapping) {
  if (declared.external) return externalCandidates(declared, mapping);
  std::vector<Candidate> all;
  const bool reachable = hasFriend(declared.record);
  for (const clang::FieldDecl* field : declared.record->fields()) {
    if (field->isUnnamedBitField()) continue;  // it has no value
    all.push_back({field, mapping.annotationOf(field, Kind::Field), false, reachable});
  }
  return all;
}

}  // namespace suture::compiler::frontend
