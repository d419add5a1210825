"""Faults of a container's network and machine, injected from outside, in its own network namespace."""

import contextlib
import os
import re
import signal
import subprocess


def _inside(container, *words):
    """Runs a command of the host in the container's network namespace. @return what it printed"""
    done = subprocess.run(["nsenter", "-t", str(container.pid()), "-n", *words], capture_output=True, text=True,
                          stdin=subprocess.DEVNULL, timeout=30, check=False)
    if done.returncode != 0:
        raise RuntimeError(f"{' '.join(words)} in {container.name}: {done.stderr.strip()}")
    return done.stdout


_CHAINS = (("INPUT", "-i"), ("OUTPUT", "-o"))


@contextlib.contextmanager
def cut_off(container):
    """Every packet from and to the container is dropped."""
    rules = [[chain, flag, "eth0", "-j", "DROP"] for chain, flag in _CHAINS]
    for rule in rules:
        _inside(container, "iptables", "-w", "-A", *rule)
    try:
        yield
    finally:
        for rule in rules:
            _inside(container, "iptables", "-w", "-D", *rule)


@contextlib.contextmanager
def link_down(container):
    """The container's interface is down."""
    _inside(container, "ip", "link", "set", "eth0", "down")
    try:
        yield
    finally:
        _inside(container, "ip", "link", "set", "eth0", "up")


@contextlib.contextmanager
def disconnected(swarm, *containers):
    """The containers are not in the swarm's network; afterwards each gets another interface, maybe another address."""
    for container in containers:
        container.engine.run("network", "disconnect", swarm.mark, container.name)
    try:
        yield
    finally:
        for container in containers:
            if container.running():
                container.engine.run("network", "connect", swarm.mark, container.name)


def has_network(container):
    """Whether the container has an interface besides loopback."""
    return any(not line.startswith("lo ") for line in _inside(container, "ip", "-br", "link").splitlines())


@contextlib.contextmanager
def partition(left, right):
    """No packet goes from one half to the other, neither way."""
    rules = [(container, ["INPUT", "-s", other.address(), "-j", "DROP"])
             for here, there in ((left, right), (right, left)) for container in here for other in there]
    for container, rule in rules:
        _inside(container, "iptables", "-w", "-A", *rule)
    try:
        yield
    finally:
        for container, rule in rules:
            if container.running():
                _inside(container, "iptables", "-w", "-D", *rule)


def lose(container, probability):
    """From now on each packet that arrives at the container is lost with this probability."""
    _inside(container, "iptables", "-w", "-A", "INPUT", "-i", "eth0", "-m", "statistic", "--mode", "random",
            "--probability", str(probability), "-j", "DROP")


def throttle(container, rate="250kbit"):
    """From now on what the container sends passes a token bucket."""
    _inside(container, "tc", "qdisc", "add", "dev", "eth0", "root", "tbf", "rate", rate, "burst", "4kb",
            "latency", "200ms")


def dropped_packets(container):
    """How many packets the rules of the container's namespace have dropped so far."""
    listed = _inside(container, "iptables", "-w", "-nvxL")
    return sum(int(line.split()[0]) for line in listed.splitlines() if " DROP " in line)


def dropped_packets_if_running(container):
    """The same; 0 of a container that has ended, be it while it is asked."""
    try:
        return dropped_packets(container)
    except RuntimeError:
        if container.running():
            raise
        return 0


def held_back(container):
    """How often the token bucket had to let a packet wait so far."""
    return int(re.search(r"overlimits (\d+)", _inside(container, "tc", "-s", "qdisc", "show", "dev", "eth0"))[1])


def kill_process(container):
    """SIGKILL to the process, past the engine: as a crash is."""
    os.kill(container.pid(), signal.SIGKILL)
