"""Tells what the figures depend on besides the peers themselves."""

import datetime
import os
import pathlib
import platform
import subprocess

HERE = pathlib.Path(__file__).resolve().parent


def output(*command):
    """Returns what a command prints; "" if it fails or is missing."""
    try:
        return subprocess.run(command, capture_output=True, text=True, check=True).stdout.strip()
    except (OSError, subprocess.CalledProcessError):
        return ""


def processor():
    lines = pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
    names = [line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")]
    return names[0] if names else platform.machine()


def commit():
    changed = " and changes" if output("git", "-C", HERE, "status", "--porcelain") else ""
    return (output("git", "-C", HERE, "rev-parse", "--short", "HEAD") or "unknown") + changed


def packages(file):
    """Returns the packages of the file with their versions."""
    lines = file.read_text(encoding="utf-8").splitlines()
    names = [line for line in lines if line and not line.startswith("#")]
    versions = {name: output("dpkg-query", "-W", "-f=${Version}", name) or "missing" for name in names}
    return ", ".join(f"{name} {version}" for name, version in versions.items())


def description(packages_file):
    return {
        "measured": datetime.datetime.now(datetime.timezone.utc).strftime("%Y-%m-%d %H:%M UTC"),
        "Suture": commit(),
        "machine": f"{os.cpu_count()} x {processor()}, Linux {platform.release()}",
        "load before": " ".join(f"{load:.2f}" for load in os.getloadavg()),
        "packages": packages(packages_file),
    }
