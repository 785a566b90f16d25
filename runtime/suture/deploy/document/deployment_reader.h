#pragma once
// This reads the values of a deployment file.

#include <suture/deploy/document/deployment.h>
#include <suture/deploy/document/document_problems.h>

#include <string>
#include <vector>

namespace suture {

/// Set-up code only. Reads a document that its schema admits. A value that the schema cannot judge,
/// such as a time that is too long, is a problem; the rest is read all the same.
class DeploymentReader {
 public:
  /// Both outlive it.
  DeploymentReader(const JsonDocument& document, DocumentProblems& problems)
      : document_(document), problems_(problems) {}

  std::string manager();
  std::vector<ProcessEntry> processes();
  std::vector<ConnectionEntry> connections();

 private:
  ComponentEntry readComponent(const nlohmann::json& component, const std::string& pointer);
  std::optional<RestartBudget> readRestart(const nlohmann::json& component,
                                           const std::string& pointer);
  std::optional<BlackBoxEntry> readBlackBox(const nlohmann::json& process,
                                            const std::string& pointer);
  framing::PeerBudget::Limits readPeerMemory(const nlohmann::json& process,
                                             const std::string& pointer);
  std::optional<rt::Scheduling> readScheduling(const nlohmann::json& owner,
                                               const std::string& pointer);
  Endpoint readEndpoint(const nlohmann::json& connection, const std::string& pointer,
                        const char* end);
  ConnectOptions readOptions(const nlohmann::json& connection, const std::string& pointer);
  ConnectionDelay readDelay(const nlohmann::json& connection, const std::string& pointer);
  FaultPlan readFaults(const nlohmann::json& connection, const std::string& pointer);
  ConnectionContract readContract(const nlohmann::json& connection, const std::string& pointer);
  Duration readSilence(const nlohmann::json& contract, const std::string& pointer);
  Duration readDuration(const std::string& text, const std::string& pointer,
                        Duration longest = std::chrono::seconds(60));
  /// Returns the duration at `key` of `object`, which must not be zero; `otherwise` if there is
  /// none.
  Duration readLength(const nlohmann::json& object, const char* key, const char* otherwise,
                      const std::string& pointer);

  const JsonDocument& document_;
  DocumentProblems& problems_;
};

}  // namespace suture
