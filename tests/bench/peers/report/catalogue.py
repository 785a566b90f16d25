"""Lists the peers that are measured. A peer is a program of this project, in one of its variants."""

import dataclasses


@dataclasses.dataclass(frozen=True)
class Peer:
    name: str
    program: str
    variant: str
    companion: tuple = ()  # the command of a process that the peer waits for; {place} and {port} are those of the run

    @property
    def spins(self):
        """Its waits keep a processor busy, so it needs one for each process."""
        return self.variant == "spin"

    @property
    def is_ours(self):
        return self.program == "peer_suture"

    @property
    def is_floor(self):
        return self.program == "peer_floor"


RIVALS = (
    Peer("floor shm+spin", "peer_floor", "spin"),
    Peer("floor shm+futex", "peer_floor", "futex"),
    Peer("floor unix", "peer_floor", "unix"),
    Peer("floor tcp", "peer_floor", "tcp"),
    Peer("capnp unix", "peer_capnp", "unix"),
    Peer("capnp tcp", "peer_capnp", "tcp"),
    Peer("ice tcp", "peer_ice", "tcp"),
    Peer("cyclone listener", "peer_cyclone", "listener"),
    Peer("cyclone waitset", "peer_cyclone", "waitset"),
    Peer("fastdds shm+udp", "peer_fastdds", "shm+udp"),
    Peer("fastdds udp", "peer_fastdds", "udp"),
    Peer("iceoryx waitset", "peer_iceoryx", "waitset", ("iox-roudi", "--log-level", "warning")),
    Peer("grpc unix", "peer_grpc", "unix"),
    Peer("grpc tcp", "peer_grpc", "tcp"),
    Peer("grpc tcp callback", "peer_grpc", "tcp-callback"),
    Peer("zmq ipc", "peer_zmq", "ipc"),
    Peer("zmq tcp", "peer_zmq", "tcp"),
)


def ours(lane):
    address = "tcp://127.0.0.1:{port}" if "tcp" in lane else "unix:{place}.suture/manager"
    return Peer(f"suture {lane}", "peer_suture", lane, ("suture-manager", "--listen", address))


OURS = tuple(map(ours, ("shm", "frame-unix", "frame-tcp", "rpc-unix", "rpc-tcp")))
# The answer of a round trip is a return value, not an event.
OURS_BY_RETURN = tuple(map(ours, ("shm-return", "frame-tcp-return", "rpc-unix-return")))
# These have a serializer.
CONVERTERS = (
    Peer("hand packer", "peer_floor", "packer"),
    Peer("capnp", "peer_capnp", "unix"),
    Peer("ice", "peer_ice", "tcp"),
    Peer("cyclone cdr", "peer_cyclone", "waitset"),
    Peer("fastdds cdr", "peer_fastdds", "udp"),
    Peer("grpc protobuf", "peer_grpc", "tcp"),
    Peer("suture slot", "peer_suture", "shm"),
    Peer("suture message", "peer_suture", "rpc-unix"),
)
