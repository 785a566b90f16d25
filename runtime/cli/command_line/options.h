#pragma once
// This is what the command line said.

#include <suture/base/errors.h>
#include <suture/base/time.h>
#include <suture/deploy/keys_command.h>
#include <suture/net/secure.h>

#include <string>
#include <vector>

namespace suture::cli {

/// Says that the command line itself is wrong: exit status 2.
class UsageError : public SetupError {
 public:
  using SetupError::SetupError;
};

/// The certificate that this program shows has this name.
inline constexpr const char* kOwnName = "suture";

/// Holds the options of all verbs; each verb uses some.
struct Options {
  std::string manager;                ///< address of the global manager, or of several
  std::string keys;                   ///< folder with its own; "": none
  net::Trust trust;                   ///< those keys
  bool json = false;                  ///< JSON on standard output for programs, errors too
  Duration patience{0};               ///< how long each step may take
  std::string target;                 ///< the subject of the verb: "process:component/interface"
  std::string other;                  ///< the second subject
  std::string member;                 ///< name of a command or an event
  std::vector<std::string> targets;   ///< any number of subjects for the doctor
  std::vector<std::string> settings;  ///< "name=value" of arguments
  std::string arguments;              ///< all arguments as one JSON object
  double rate = 10;                   ///< Hz: how often a watched read is asked
  unsigned count = 0;                 ///< how many to watch; 0: no end
  Duration period{0};                 ///< how long to watch; 0: no end
  KeysRequest newKeys;                ///< the keys to make
  bool onlyReads = false;  ///< the name is of a read command, even if there is such an event
};

}  // namespace suture::cli
