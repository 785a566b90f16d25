#pragma once
// A history says what clients asked and providers did, as each wrote it down; rules say what must
// hold of it.

#include <suture/base/errors.h>
#include <suture/base/time.h>

#include <cstdint>
#include <string>
#include <vector>

namespace suture {

/// Says what one end's report tells of the commands of a client. All are words of 64 bits, since
/// they travel so in a log.
struct HistorySums {
  std::uint64_t accepted = 0;
  std::uint64_t executed = 0;  ///< also those whose handler threw
  std::uint64_t others = 0;    ///< with any other outcome that is known
  std::uint64_t lost = 0, unknown = 0, underWay = 0;
  std::uint64_t heard = 0;    ///< the client's end: how many of `executed` and `others` the process
                              ///< at the other end has told
  std::uint64_t process = 0;  ///< the incarnation of the process that counts
  std::uint64_t other = 0;    ///< that of the process at the other end

  bool operator==(const HistorySums&) const = default;
};

/// A HistoryEntry is one line of a log. All steady clocks are this machine's.
struct HistoryEntry {
  enum class Kind : std::uint8_t {
    Sent,   ///< the client is about to send a command; `limit`: the deadline of its call, 0: none
    Ended,  ///< the client knows how that ended: `error`
    Executed,   ///< the provider executed it; `limit`: its ttl, 0: none
    Heard,      ///< the client's handler got an event; `id`: its number
    Killed,     ///< the client was, by the test: what is under way needs no end
    Connected,  ///< the client found a new connection: `epoch`, over `lane`
    Told,       ///< the client was told that its connection `epoch` is lost: `error`
    Counted,    ///< the client says in the end what became of its commands: `sums`; `id`: how many
                ///< were executed that are in no history
    Served,     ///< so does a provider; `id`: how many of them its handlers have begun
    Awaits,   ///< the client's commands await its operator: it was told of a loss, or read what was
              ///< stale
    Resumed,  ///< its operator lets them through again
  };

  Kind kind = Kind::Sent;
  Time at{};
  std::uint32_t client = 0;  ///< the client that commanded, or that heard
  std::uint64_t id = 0;      ///< the command's; it counts up over all connections of a client
  std::uint64_t epoch = 0;   ///< which connection of the client; heard: which provider
  Duration limit{0};
  Errc error{};
  std::int64_t wall = 0;  ///< the wall clock of who wrote it down, ns: no rule is about it
  Duration age{0};        ///< executed: what the runtime compared with the ttl
  std::string lane = {};  ///< the lane's name
  HistorySums sums = {};
};

/// One thread may use it. Writes each entry at once, so that it survives a SIGKILL.
class HistoryLog {
 public:
  explicit HistoryLog(const std::string& file);
  ~HistoryLog();
  HistoryLog(const HistoryLog&) = delete;
  HistoryLog& operator=(const HistoryLog&) = delete;

  /// Writes it with the wall clock of this moment.
  void write(const HistoryEntry& entry);

 private:
  int file_;
};

/// Reads what HistoryLog wrote to these files, in the order of time; entries of one file keep
/// theirs. A last line that a kill cut off is left out.
std::vector<HistoryEntry> readHistory(const std::vector<std::string>& files);

/// Says what the rules allow.
struct Tolerance {
  Duration lateness;  ///< how long after its deadline a call may end
  /// Says how long a provider may not have heard of a loss that its client has been told of: on
  /// `frame` and `rpc`, of one by a broken link.
  Duration unheard{0};
  /// Says how many commands of a connection may begin after its client was told of the loss,
  /// because they had been judged an instant before: none on a stepped clock, one in a thread that
  /// the machine may hold up between the two.
  int justJudged = 0;
};

/// Tells where a history breaks one of these rules:
///  - each call ends, soon after its deadline at the latest;
///  - no command is executed twice, and none is that the runtime found older than its ttl, or whose
///    sender was told that it was not executed;
///  - no command begins to be executed after its sender was told that its connection is lost, and
///    its provider has heard of it, but for what had just been judged;
///  - no command is let through that was sent while its client's commands awaited their operator;
///  - the commands of a client are executed in the order in which it sent them, so that none of an
///    older connection comes after one of a newer;
///  - as many of a client's commands were executed as its ledger says, or as may have been by it;
///  - in the ledger of either end each command that was accepted is in one place, and a client has
///    heard of no more than the process that it was connected to last, started once, has counted;
///  - a client hears the events of one provider in their order, each once, and none of an older
///    provider after one of a newer.
std::vector<std::string> violations(const std::vector<HistoryEntry>& history,
                                    const Tolerance& tolerance);

}  // namespace suture
