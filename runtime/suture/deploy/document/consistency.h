#pragma once
// This checks that the parts of a deployment fit each other.

#include <suture/deploy/document/deployment.h>
#include <suture/deploy/document/document_problems.h>

namespace suture {

/// Set-up code only. Reports names that are given twice or that nothing has, required interfaces of
/// two providers, what needs a global manager where none is named, and ports that two processes
/// want.
void checkConsistency(const Deployment& deployment, DocumentProblems& problems);

}  // namespace suture
