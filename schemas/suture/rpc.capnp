@0xa621ff1bb11163d2;
# What every generated contract schema shares.

using Cxx = import "/capnp/c++.capnp";
$Cxx.namespace("suture::wire");

struct Sent {
  # The receipt of a command.
  stamp @0 :Int64;  # the provider's steady clock when it took the command, ns
}
