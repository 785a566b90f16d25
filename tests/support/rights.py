"""Tells which rights to processor time and locked memory this user has, and how to start a program with or without them."""

import ctypes
import os

# Limits are for everybody; root has these rights by its capabilities, too.
WITHOUT_REAL_TIME = [
    "prlimit", "--rtprio=0:0", "--memlock=65536:65536",
    *(["setpriv", "--bounding-set=-sys_nice,-ipc_lock", "--inh-caps=-all"] if os.geteuid() == 0 else [])]

# Goes before WITHOUT_REAL_TIME, since it needs the right that is taken there. A program that holds arms at their rates is judged by how well
# it does; what other tests compile meanwhile must not decide that.
BEFORE_COMPILERS = ["nice", "-n", "-10"] if os.geteuid() == 0 else []


def may_be_real_time(priority):
    """Returns true if this process may have that priority and lock all of its memory. A child asks, since the rights that it takes end with
    it."""
    child = os.fork()
    if child == 0:
        status = 1  # also of a child that fails otherwise: it must never go on as a second test
        try:
            os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(priority))
            status = ctypes.CDLL(None).mlockall(3) != 0
        finally:
            os._exit(status)
    return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 0
