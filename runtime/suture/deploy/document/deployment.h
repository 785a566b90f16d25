#pragma once
// This is a system as data: which process runs which components, and how their interfaces are
// connected.

#include <suture/base/frames.h>
#include <suture/component/task/task.h>
#include <suture/deploy/document/json_document.h>
#include <suture/manager/manager.h>
#include <suture/names/security.h>
#include <suture/rt/scheduling.h>
#include <suture/session/connect_options.h>
#include <suture/wiring/endpoint.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace suture {

struct ComponentEntry {
  std::string name;
  std::string className;
  std::filesystem::path sharedLibrary;  ///< the file that has the class; "": the program
  nlohmann::json parameters;
  std::optional<RestartBudget> restart;
  std::optional<rt::Scheduling> scheduling;  ///< the thread's; none: as its class says
  std::map<std::string, Frames> frames;      ///< each interface's frames by its name
  std::string pointer;                       ///< where the document describes it
};

/// Says what a process keeps of its components (record/black_box.h).
struct BlackBoxEntry {
  std::filesystem::path folder;
  Duration last{}, period{};
  unsigned rows = 0;                    ///< 0: what each component asks for
  std::vector<std::string> components;  ///< their names; empty: all
  std::string pointer;                  ///< where the document describes it
};

struct ProcessEntry {
  std::string name;
  std::vector<ComponentEntry> components;
  std::optional<BlackBoxEntry> blackBox;
  std::optional<rt::Scheduling> scheduling;  ///< how threads that carry connections are scheduled
  std::uint16_t port = 0;  ///< where others reach it; 0: one that the kernel takes
  /// The connections of one peer, and of all, may take this memory, in bytes.
  framing::PeerBudget::Limits peerMemory = Security::kConnectionMemory;
  bool lockMemory = false;
  bool realTimeRequired = false;  ///< it is an error if the machine refuses any of it
  std::string pointer;            ///< where the document describes it
};

struct ConnectionEntry {
  Endpoint from;           ///< a required interface; its process is always named
  Endpoint to;             ///< a provided interface; its process is always named
  ConnectOptions options;  ///< except the patience
  std::string pointer;
};

/// Set-up code only. Holds a checked deployment file (schemas/deployment.schema.json) as a value.
class Deployment {
 public:
  /// Throws DocumentError with every problem of the file: of its syntax, of its schema, or of its
  /// names.
  explicit Deployment(JsonDocument document);
  /// Does the same, but adds the problems of names to `problems`, so that the rest of the file can
  /// be judged too.
  Deployment(JsonDocument document, std::vector<std::string>& problems);

  const JsonDocument& document() const { return document_; }
  /// Returns what the system is, for people; "" if the file does not say.
  std::string title() const { return document_.value().value("title", ""); }
  /// Returns the address of the global manager, or of several, separated by commas; "" if the file
  /// names none.
  const std::string& manager() const { return manager_; }
  /// Return the folder of keys and the policy file; "" if the file names none.
  std::filesystem::path keys() const {
    return document_.besideIt(document_.value().value("keys", ""));
  }
  std::filesystem::path policy() const {
    return document_.besideIt(document_.value().value("policy", ""));
  }
  const std::vector<ProcessEntry>& processes() const { return processes_; }
  const std::vector<ConnectionEntry>& connections() const { return connections_; }

  /// Returns the process of that name. Throws DocumentError that lists the processes that exist.
  const ProcessEntry& process(std::string_view name) const;

 private:
  /// Returns the problems that its schema does not know. Throws DocumentError with those that it
  /// does.
  std::vector<std::string> read();

  JsonDocument document_;
  std::string manager_;
  std::vector<ProcessEntry> processes_;
  std::vector<ConnectionEntry> connections_;
};

}  // namespace suture
