#pragma once
// These are the keys and the policy of one process of a deployment.

#include <suture/deploy/document/deployment.h>
#include <suture/names/security.h>

#include <string>
#include <vector>

namespace suture {

/// Set-up code only. Reads the policy, and the keys of `process`, where the file names them. Adds
/// a warning for keys that end soon. Throws DocumentError for files that cannot be used.
Security securityOf(const Deployment& deployment, const ProcessEntry& process,
                    std::vector<std::string>& warnings);

}  // namespace suture
