#pragma once
// What was said on the command line.

#include <suture/base/errors.h>
#include <suture/base/time.h>
#include <suture/deploy/keys_command.h>
#include <suture/net/secure.h>

#include <string>
#include <vector>

namespace suture::cli {

/// The command line itself cannot be meant: exit status 2.
class UsageError : public SetupError {
 public:
  using SetupError::SetupError;
};

/// The name in the certificate that this program shows.
inline constexpr const char* kOwnName = "suture";

/// The options of all verbs; each verb uses some.
struct Options {
  std::string manager;                ///< address of the global manager, or of several
  std::string keys;                   ///< folder with its own; "": none
  rpc::Trust trust;                   ///< those keys
  bool json = false;                  ///< for programs: JSON on standard output, errors too
  Duration patience{0};               ///< for each step
  std::string target;                 ///< what the verb is about: "process:component/interface"
  std::string other;                  ///< the second of two such
  std::string member;                 ///< name of a command or an event
  std::vector<std::string> targets;   ///< of the doctor, any number
  std::vector<std::string> settings;  ///< "name=value" of arguments
  std::string arguments;              ///< all arguments as one JSON object
  double rate = 10;                   ///< of a watched read, Hz
  unsigned count = 0;                 ///< how many to watch; 0: no end
  Duration period{0};                 ///< how long to watch; 0: no end
  KeysRequest newKeys;                ///< those that are to be made
  bool onlyReads = false;  ///< the name is of a read command, also if there is such an event
};

}  // namespace suture::cli
