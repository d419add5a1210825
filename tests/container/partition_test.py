"""A swarm of two halves that do not hear each other for 30 s: when that is over the mission goes on, with equal maps."""

import time

import faults
from case import ContainerCase, Mission, note
from swarm import until

_PARTITION_S = 30.0
_SOON_S = 5.0
_HELD = Mission("transit-partition", 6, sets=("lockstep.deadline_s=60",), realtime=4.0)
_MAPS = Mission("transit-partition", 6, sets=("lockstep.deadline_s=3",), realtime=0.8)
_ONWARD = Mission("swarm-crossing", 6, sets=("lockstep.deadline_s=3", "vehicles.on_agent_loss=continue",
                                         "vehicles.swap.agents=6"), realtime=0.15)
_PATIENT = ("-e", "SKEIN_WORLD_TIMEOUT=90")


def passed_since(start_s):
    return time.monotonic() - start_s


def takes_part_again(agent):
    """A transit without cells needs nothing of its former life, and flies on; else it says that it rejoined."""
    _, _, since = agent.log().rpartition("no tick from the world")
    return "rejoined at round" in since or "flying at round" in since


class Partition(ContainerCase):
    def start(self, mission):
        """World and agents in flight, and the agents that the partition takes away."""
        swarm = self.swarm(mission)
        world = swarm.start_world(*mission.flags())
        agents = swarm.start_agents(options=_PATIENT)
        world.reaches("flying", 0)
        return swarm, world, agents[:len(agents) // 2], agents[len(agents) // 2:]

    def held(self, fault, name):
        """The lockstep waits for the other half, which loses nothing."""
        swarm, world, near, far = self.start(_HELD)
        with fault(swarm, world, near, far):
            world.says("holding at round", 20)
            self.goes_on_for(world, _PARTITION_S)
            self.assertNotIn("goes on at round", world.log())
        healed_s = time.monotonic()
        world.says("goes on at round", 60)
        held_s = passed_since(healed_s)
        report = self.assert_undisturbed(world, swarm, _HELD)
        self.assertTrue(report["map_equal"])
        self.assertLess(held_s, _SOON_S)
        note(f"{name} in flight for 30 s, deadline 60 s", f"{_HELD.scenario}, {_HELD.agents} agents",
             f"next step {held_s:.1f} s after it healed; all maps equal; same state hash")

    def dropped(self, mission, fault, name, happened):
        """The world goes on without the other half, which comes back."""
        swarm, world, near, far = self.start(mission)
        with fault(swarm, world, near, far):
            world.says("goes on at round", 30)
            self.goes_on_for(world, _PARTITION_S)
        healed_s = time.monotonic()
        for agent in far:
            until(lambda: takes_part_again(agent), 60, lambda: agent.log()[-2000:])
        back_s = passed_since(healed_s)
        world.wait(300)
        report = world.report()
        reasons = [change["reason"] for change in report["roster_changes"]]
        self.assertEqual(reasons, ["deadline"] * len(far) + ["rejoined"] * len(far))
        self.assertEqual(report["collisions"], 0)
        self.assertTrue(report["map_equal"])
        self.assert_replays(swarm, report)
        for agent in swarm.agents:
            self.assertEqual(agent.wait(60), 0, agent.log()[-3000:])
        self.assertLess(back_s, _SOON_S)
        arrived = sum(vehicle["status"] == "arrived" for vehicle in report["vehicles"])
        note(f"{name} in flight for 30 s, deadline 3 s", f"{mission.scenario}, {mission.agents} agents",
             f"{len(far)} agents dropped, all back {back_s:.1f} s after it healed; {arrived} arrive; {happened}; "
             "replays to the same state hash")

    @staticmethod
    def cut(_, world, near, far):
        return faults.partition([world, *near], far)

    @staticmethod
    def unplug(swarm, _world, _near, far):
        return faults.disconnected(swarm, *far)

    def test_halves_that_the_lockstep_waits_for(self):
        self.held(self.cut, "two halves that do not hear each other")

    def test_a_half_disconnected_that_the_lockstep_waits_for(self):
        self.held(self.unplug, "network disconnect of half of the agents")

    def test_halves_that_the_world_goes_on_without(self):
        self.dropped(_MAPS, self.cut, "two halves that do not hear each other", "the maps of those who fly are equal")

    def test_a_half_disconnected_that_the_world_goes_on_without(self):
        self.dropped(_ONWARD, self.unplug, "network disconnect of half of the agents", "who came back flew on")
