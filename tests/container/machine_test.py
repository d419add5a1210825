"""Faults of a machine: a full disk under the report, and clocks that differ."""

import os
from datetime import datetime
from pathlib import Path

from case import RENDEZVOUS, ContainerCase, note

_FAKETIME = Path("/usr/lib/x86_64-linux-gnu/faketime/libfaketimeMT.so.1")


def shifted(shift):
    """Options of a container whose wall clock is shifted; its monotonic one is not."""
    library = Path(os.environ.get("SKEIN_FAKETIME", _FAKETIME))
    if not library.is_file():
        raise RuntimeError(f"{library} is not here; deploy/setup.sh container installs it")
    return ("-v", f"{library}:/faketime.so:ro", "-e", "LD_PRELOAD=/faketime.so", "-e", f"FAKETIME={shift}",
            "-e", "FAKETIME_DONT_FAKE_MONOTONIC=1", "-e", "DONT_FAKE_MONOTONIC=1")


def clock_of(container):
    """The wall clock that its first line of log shows."""
    return datetime.fromisoformat(container.log()[:23])


class Machine(ContainerCase):
    def test_a_full_disk_under_the_report_is_named(self):
        swarm = self.swarm(RENDEZVOUS)
        world = swarm.start_world(options=("--tmpfs", "/small:rw,size=4k,mode=1777"), out="/small/out")
        agents = swarm.start_agents()
        self.assertEqual(world.wait(), 1, world.log())
        self.assertIn("cannot write", world.log())
        self.assertIn("report.json", world.log())
        for agent in agents:
            self.assertEqual(agent.wait(), 0, agent.log())
        note("a disk of 4 KiB under the world's report", "rendezvous-2d",
             "the run ends in formation, the agents with 0; the world with 1, naming the file")

    def test_clocks_that_differ_by_an_hour(self):
        swarm = self.swarm(RENDEZVOUS)
        world = swarm.start_world(options=shifted("-1h"))
        agents = [swarm.start_agent(options=shifted(shift)) for shift in ("+1h", "+0h", "-3h")]
        self.assert_undisturbed(world, swarm, RENDEZVOUS)
        hours = [round((clock_of(agent) - clock_of(agents[1])).total_seconds() / 3600) for agent in (world, *agents)]
        self.assertEqual(hours, [-1, 1, 0, -3])
        note("wall clocks an hour behind, right, an hour and three hours off (libfaketime)", "rendezvous-2d",
             "same state hash")
