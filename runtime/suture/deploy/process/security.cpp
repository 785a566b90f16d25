#include <suture/deploy/document/policy_file.h>
#include <suture/deploy/process/security.h>
#include <suture/net/tls/keys.h>

#include <memory>

namespace suture {

Security securityOf(const Deployment& deployment, const ProcessEntry& process,
                    std::vector<std::string>& warnings) {
  Security ours;
  ours.connectionMemory = process.peerMemory;
  if (!deployment.policy().empty()) ours.policy = readPolicy(deployment.policy());
  if (deployment.keys().empty()) return ours;
  try {
    const auto keys = std::make_shared<const tls::Keys>(deployment.keys(), process.name);
    if (!keys->warning().empty()) {
      warnings.push_back(deployment.document().warn("/keys", keys->warning()));
    }
    ours.keys = keys;
  } catch (const SetupError& error) {
    throw DocumentError({deployment.document().locate("/keys", error.what())});
  }
  return ours;
}

}  // namespace suture
