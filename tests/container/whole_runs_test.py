"""Whole missions by containers: nothing goes wrong, and the state hash is that of one process."""

import re

from case import RENDEZVOUS, TRANSIT, ContainerCase, Mission, note
from swarm import until

_INTRODUCED = re.compile(r"agent (\d+) introduces itself")


class WholeRuns(ContainerCase):
    def whole(self, mission):
        swarm = self.swarm(mission)
        world = swarm.start_world()
        swarm.start_agents()
        report = self.assert_undisturbed(world, swarm, mission)
        ids = [int(_INTRODUCED.search(agent.log())[1]) for agent in swarm.agents]
        self.assertEqual(sorted(ids), list(range(1, mission.agents + 1)))
        note("nothing", f"{mission.scenario}, {mission.agents} agents",
             f"state hash {report['state_hash']} as in process")

    def test_rendezvous(self):
        self.whole(RENDEZVOUS)

    def test_transit(self):
        self.whole(TRANSIT)

    def test_a_ground_station_sees_it_end(self):
        swarm = self.swarm(RENDEZVOUS)
        world = swarm.start_world(*RENDEZVOUS.flags())
        station = swarm.start_station()
        swarm.start_agents()
        report = self.assert_undisturbed(world, swarm, RENDEZVOUS)
        self.assertEqual(station.wait(), 0, station.log())
        self.assertIn(report["state_hash"], station.log())

    def test_a_late_joiner_is_waited_for(self):
        swarm = self.swarm(RENDEZVOUS)
        world = swarm.start_world()
        for _ in range(RENDEZVOUS.agents - 1):
            swarm.start_agent()
        until(lambda: world.progress().get("introduced") == RENDEZVOUS.agents - 1, 60, "all but one are there")
        self.assertEqual(world.progress()["phase"], "waiting")
        swarm.start_agent()
        self.assert_undisturbed(world, swarm, RENDEZVOUS)
        note("an agent starts after all others wait", "rendezvous-2d", "same state hash")

    def test_two_swarms_in_one_domain_do_not_hear_each_other(self):
        missions = (RENDEZVOUS, Mission("rendezvous-2d", 3, seed=2))
        first, second = (self.swarm(mission) for mission in missions)
        second.mark, second.label = first.mark, first.label  # on one network; the names of their swarms differ
        second.made = 100
        worlds = [first.start_world(), second.start_world()]
        for _ in range(RENDEZVOUS.agents):
            first.start_agent()
            second.start_agent()
        for world, swarm, mission in zip(worlds, (first, second), missions):
            report = self.assert_undisturbed(world, swarm, mission)
            self.assertEqual(report["refused_samples"], 0)
        note("another swarm in the same DDS domain and network", "rendezvous-2d, twice",
             "both: same state hash, 0 samples refused")
