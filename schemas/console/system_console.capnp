@0x901b4ceb8df80bf8;
# The wire contract of console/system_console.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("console/system_console.h");

struct SystemConsoleParameters @0xff4a2484b55948bb $Meta.cxx("robots::SystemConsoleParameters") {
  period @0 :Int64 = 10000000 $Meta.period("1/1000000000");
  system @1 :List(Text) $Meta.capacity([8, 15]);
  # The system has these parts, and brings them up in this order: names of required interfaces of
  # this console. All arms come before what moves them.
  patience @2 :Int64 = 10000000000 $Meta.period("1/1000000000");
  # Each of these may take this long: to enable a part, to home all arms, to disable a part.
  bringUpByItself @3 :Bool $Meta.cxx("bring_up_by_itself");
  # If it is true, the console brings the system up once, without being asked, when everything is
  # there. It does not if an arm has homed before: then the console was restarted, and somebody
  # may have brought the system down.
}
