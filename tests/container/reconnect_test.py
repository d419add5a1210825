"""The network disconnected and connected again: another interface to the kernel, for which a participant is made anew."""

import random

import faults
from case import RENDEZVOUS, ContainerCase, Mission, losses_of, note

_ANEW = "DDS participant made anew"
_PLANNING = Mission("rendezvous-2d", 3, sets=("planner.round_s=8",), realtime=80.0)
_QUICK = Mission("rendezvous-2d", 3, sets=("lockstep.deadline_s=3",), realtime=25.0)
_THOUGHTFUL = Mission("rendezvous-2d", 3, sets=("lockstep.deadline_s=3", "planner.round_s=2.5"), realtime=25.0)


class Reconnect(ContainerCase):
    def start(self, mission, **keywords):
        swarm = self.swarm(mission)
        return swarm, swarm.start_world(*mission.flags()), swarm.start_agents(**keywords)

    def short(self, mission, phase, whose):
        """Disconnected for two seconds of the default deadline of ten."""
        swarm, world, agents = self.start(mission)
        world.reaches(phase, 200 if phase == "flying" else 0)
        chosen = world if whose == "the world" else random.Random(phase).choice(agents)
        with faults.disconnected(swarm, chosen):
            self.assertFalse(faults.has_network(chosen))
            self.goes_on_for(world, 2.0)
        chosen.says(_ANEW, 10)
        self.assert_undisturbed(world, swarm, mission)
        note(f"network disconnect and connect of {whose}, 2 s apart, in {phase}, deadline 10 s",
             f"{mission.scenario}, {mission.agents} agents", "participant made anew; same state hash")

    def test_an_agent_in_flight_shorter_than_the_deadline(self):
        self.short(RENDEZVOUS, "flying", "an agent")

    def test_an_agent_that_plans_shorter_than_the_deadline(self):
        self.short(_PLANNING, "planning", "an agent")

    def test_the_world_in_flight_shorter_than_the_deadline(self):
        self.short(RENDEZVOUS, "flying", "the world")

    def test_the_world_while_all_plan_shorter_than_the_deadline(self):
        self.short(_PLANNING, "planning", "the world")

    def long(self, mission, phase):
        swarm, world, agents = self.start(mission)
        world.reaches(phase, 200 if phase == "flying" else 10)
        with faults.disconnected(swarm, agents[1]):
            world.says("goes on at round", 30)
        agents[1].says(_ANEW, 10)
        agents[1].says("rejoined at round", 15)
        world.wait()
        report = world.report()
        self.assertEqual([change["reason"] for change in report["roster_changes"]], ["deadline", "rejoined"])
        self.assert_replays(swarm, report)
        note(f"network disconnect of an agent in {phase}, connect once it is dropped, deadline 3 s", mission.scenario,
             f"participant made anew; {losses_of(report)}; exit code {report['exit_code']}; "
             "replays to the same state hash")

    def test_an_agent_in_flight_longer_than_the_deadline(self):
        self.long(_QUICK, "flying")

    def test_an_agent_that_plans_longer_than_the_deadline(self):
        self.long(_THOUGHTFUL, "planning")

    def test_the_world_longer_than_the_deadline(self):
        """Nobody is left to the world: it says whom it lost, and ends; so do the agents that it leaves behind."""
        swarm, world, agents = self.start(_QUICK, options=("-e", "SKEIN_WORLD_TIMEOUT=8"))
        world.reaches("flying", 200)
        with faults.disconnected(swarm, world):
            code = world.wait(30)
        report = world.report()
        self.assertEqual(code, 4, world.log()[-2000:])
        self.assertEqual([change["reason"] for change in report["roster_changes"]], ["deadline"] * _QUICK.agents)
        self.assert_replays(swarm, report)
        for agent in agents:
            self.assertEqual(agent.wait(30), 3)
            self.assertIn("no tick of a world for 8 s", agent.log())
        note("network disconnect of the world for longer than the deadline of 3 s", "rendezvous-2d",
             f"the world ends with 4 ({report['reason']}), the agents with 3, naming it; replays to the same state hash")
