"""Faults of the network: shorter than the lockstep's deadline nothing changes; longer, a roster change that replays."""

import random

import faults
from case import RENDEZVOUS, TRANSIT, ContainerCase, Mission, losses_of, note
from swarm import until

_COARSE = Mission("rendezvous-2d", 3, sets=("step_s=5", "planner.generations=20"))
_SHORT = Mission("rendezvous-2d", 3, sets=("lockstep.deadline_s=3",), realtime=25.0)


def pace_of(report):
    return f"discovery {report['discovery_s']:.1f} s, {report['steps_per_s']:.0f} steps/s"


class Network(ContainerCase):
    def lossy(self, mission, probability):
        swarm = self.swarm(mission)
        world = swarm.start_world()
        members = [world]
        faults.lose(world, probability)
        for _ in range(mission.agents):  # the run begins with the last one, and may be over in a second
            members.append(swarm.start_agent())
            faults.lose(members[-1], probability)
        until(lambda: not world.running() or world.progress()["phase"] == "flying", 120, "the flight")
        dropped = sum(faults.dropped_packets_if_running(member) for member in members)
        report = self.assert_undisturbed(world, swarm, mission, limit_s=300)
        note(f"{probability:.0%} of the packets to everybody lost", f"{mission.scenario}, {mission.agents} agents",
             f"same state hash; {dropped} packets lost until the flight began; {pace_of(report)}")

    def test_one_percent_of_the_packets_are_lost(self):
        self.lossy(_COARSE, 0.01)

    def test_ten_percent_of_the_packets_are_lost(self):
        self.lossy(_COARSE, 0.1)

    def test_thirty_percent_of_the_packets_are_lost(self):
        self.lossy(_COARSE, 0.3)

    def test_a_vehicle_on_250_kbit_per_second(self):
        for mission in (_COARSE, TRANSIT):
            with self.subTest(mission.scenario):
                swarm = self.swarm(mission)
                world = swarm.start_world()
                agents = swarm.start_agents()
                faults.throttle(agents[0])
                until(lambda: faults.held_back(agents[0]), 60, "the token bucket holds packets back")
                report = self.assert_undisturbed(world, swarm, mission, limit_s=300)
                note("one agent sends through a token bucket of 250 kbit/s",
                     f"{mission.scenario}, {mission.agents} agents", f"same state hash; {pace_of(report)}")

    def short(self, mission, phase, fault, name):
        """The fault holds for three seconds of the default deadline of ten."""
        swarm = self.swarm(mission)
        world = swarm.start_world(*mission.flags())
        agents = swarm.start_agents()
        world.reaches(phase, 200 if phase == "flying" and mission is RENDEZVOUS else 0)
        chosen = random.Random(mission.scenario + name).choice([world, *agents])
        with fault(chosen):
            self.goes_on_for(world, 3.0)
            if fault is faults.cut_off:
                self.assertGreater(faults.dropped_packets(chosen), 0)
        self.assert_undisturbed(world, swarm, mission)
        note(f"{name} of {'the world' if chosen is world else 'an agent'} for 3 s in {phase}, deadline 10 s",
             f"{mission.scenario}, {mission.agents} agents", "same state hash")

    def test_dropped_packets_shorter_than_the_deadline(self):
        self.short(RENDEZVOUS, "flying", faults.cut_off, "packets dropped")

    def test_dropped_packets_while_planning(self):
        self.short(Mission("rendezvous-2d", 3, sets=("planner.round_s=8",), realtime=80.0), "planning",
                   faults.cut_off, "packets dropped")

    def test_a_link_that_is_down_shorter_than_the_deadline(self):
        self.short(TRANSIT, "flying", faults.link_down, "link down")

    def long(self, fault, name):
        swarm = self.swarm(_SHORT)
        world = swarm.start_world(*_SHORT.flags())
        agents = swarm.start_agents()
        world.reaches("flying", 200)
        with fault(agents[1]):
            until(lambda: world.progress().get("live") == _SHORT.agents - 1, 30, "the agent is dropped")
        agents[1].says("rejoined at round")
        world.wait()
        report = world.report()
        self.assertEqual([change["reason"] for change in report["roster_changes"]], ["deadline", "rejoined"])
        self.assert_replays(swarm, report)
        note(f"{name} of an agent until it is dropped, deadline 3 s", "rendezvous-2d",
             f"{losses_of(report)}; exit code {report['exit_code']}; replays to the same state hash")

    def test_dropped_packets_longer_than_the_deadline(self):
        self.long(faults.cut_off, "packets dropped")

    def test_a_link_that_is_down_longer_than_the_deadline(self):
        self.long(faults.link_down, "link down")
