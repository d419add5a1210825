"""What the test cases share: the engine and the image of the suite, checks of a run, and the table of what happened."""

import time
import unittest
from dataclasses import dataclass

from swarm import Swarm, until


@dataclass
class Mission:
    """A run as the tests know it. `realtime` paces the flight, so that there is time for a fault; it is in no hash."""

    scenario: str
    agents: int
    seed: int = 1
    sets: tuple = ()
    realtime: float | None = None

    def flags(self):
        return () if self.realtime is None else ("--realtime", self.realtime)


RENDEZVOUS = Mission("rendezvous-2d", 3, realtime=80.0)
TRANSIT = Mission("transit-partition", 6, realtime=8.0)


class Suite:
    """Set once by suite.py."""

    engine = None
    image = None
    rows = []
    references = {}


def note(injected, run, happened):
    """A row of the table that the suite prints at its end."""
    Suite.rows.append((injected, run, happened))


class ContainerCase(unittest.TestCase):
    maxDiff = None

    def swarm(self, mission):
        return self.enterContext(
            Swarm(Suite.engine, Suite.image, mission.scenario, mission.agents, mission.seed, mission.sets))

    def reference(self, mission):
        """The report of the same run in one process, without any fault."""
        key = (mission.scenario, mission.seed, mission.sets)
        if key not in Suite.references:
            swarm = Swarm(Suite.engine, Suite.image, mission.scenario, mission.agents, mission.seed, mission.sets)
            with swarm as alone:
                Suite.references[key] = alone.in_process()
        return Suite.references[key]

    def goes_on_for(self, world, seconds):
        """The world is still there when so much time has passed."""
        end_s = time.monotonic() + seconds
        until(lambda: time.monotonic() >= end_s, seconds + 1.0, "the clock goes on")
        self.assertTrue(world.running(), world.log()[-3000:])

    def assert_undisturbed(self, world, swarm, mission, limit_s=120):
        """The run ends well, with the state hash of the run in one process, and every agent ends with 0."""
        code = world.wait(limit_s)
        self.assertEqual(code, 0, world.log()[-3000:])
        report = world.report()
        self.assertEqual(report["state_hash"], self.reference(mission)["state_hash"])
        self.assertEqual(report["roster_changes"], [])
        for agent in swarm.agents:
            self.assertEqual(agent.wait(60), 0, agent.log()[-3000:])
        return report

    def assert_replays(self, swarm, report):
        """In one process, with the losses and returns of the report, the run is the same."""
        again = swarm.in_process(roster=report)
        for key in ("state_hash", "exit_code", "reason", "roster_changes"):
            self.assertEqual(again[key], report[key], key)


def losses_of(report):
    """The roster's changes in a few words."""
    return ", ".join(f"agent {change['agent']} {change['reason']} at step {change['step']}"
                     for change in report["roster_changes"])
