"""Builds the images, runs the container tests, two at a time, and prints at its end what was injected and what happened.

usage: suite.py [--only PATTERN ...]     PATTERN as in python3 -m unittest -k
       suite.py --environment            makes the base image, prints what podman and podman-compose need, for eval
"""

import argparse
import fcntl
import shlex
import sys
import time
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from case import Suite
from compose_test import PROJECT
from engine import Engine
from image import ensure_base, ensure_image
from swarm import LABEL

_MODULES = ("partition_test", "compose_test", "whole_runs_test", "deaths_test", "network_test", "reconnect_test",
            "machine_test")  # the longest first
_LANES = 2  # a test waits more than it computes, and is alone in its own network


def table(rows):
    """The rows in Markdown."""
    lines = ["| injected | run | what happened |", "| --- | --- | --- |"]
    return "\n".join(lines + [f"| {' | '.join(row)} |" for row in rows])


def remove_leftovers(engine):
    """What a suite that was killed has left behind."""
    engine.remove_all(LABEL)
    for project in engine.labels_of_networks(PROJECT):
        if project.startswith("skeintest"):
            engine.remove_all(f"{PROJECT}={project}")


def print_environment():
    engine = Engine()
    engine.cache.mkdir(parents=True, exist_ok=True)
    ensure_base(engine)
    for name in ("CONTAINERS_CONF", "CONTAINERS_STORAGE_CONF", "TMPDIR"):
        if name in engine.environment:
            print(f"export {name}={shlex.quote(engine.environment[name])}")
    return 0


def cases_of(tests):
    """The single tests of a suite of suites."""
    for test in tests:
        yield from cases_of(test) if isinstance(test, unittest.TestSuite) else (test,)


def run_one(case):
    """Runs one test. @return what its failures say, subtests' too: none, if it held"""
    result = unittest.TestResult()
    begin_s = time.monotonic()
    case.run(result)
    said = [text for _, text in result.failures + result.errors]
    print(f"{case.id()} {'FAILED' if said else 'held'} in {time.monotonic() - begin_s:.0f} s", *said, sep="\n",
          file=sys.stderr, flush=True)
    return said


def run_all(cases):
    """Whether all of them held."""
    with ThreadPoolExecutor(_LANES) as lanes:
        failed = sum(bool(said) for said in lanes.map(run_one, cases))
    print(f"container: {len(cases) - failed} of {len(cases)} tests held", file=sys.stderr)
    return failed == 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", action="append", default=[], metavar="PATTERN")
    parser.add_argument("--environment", action="store_true")
    arguments = parser.parse_args()
    if arguments.environment:
        return print_environment()
    sys.path.insert(0, str(Path(__file__).parent))
    loader = unittest.TestLoader()
    if arguments.only:
        loader.testNamePatterns = [f"*{pattern}*" for pattern in arguments.only]
    cases = list(cases_of(loader.loadTestsFromNames(_MODULES)))
    if not cases:
        parser.error("no test has such a name")
    engine = Engine()
    engine.cache.mkdir(parents=True, exist_ok=True)
    with open(engine.cache / "lock", "w", encoding="utf-8") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)  # one suite at a time: what carries the label is of one that was killed
        remove_leftovers(engine)
        Suite.engine, Suite.image = engine, ensure_image(engine)
        held = run_all(cases)
        remove_leftovers(engine)
    print(table(sorted(Suite.rows)))
    return 0 if held else 1


if __name__ == "__main__":
    sys.exit(main())
