"""Processes that die at a seeded moment, and others that take their place."""

import random

import faults
from case import RENDEZVOUS, ContainerCase, Mission, losses_of, note

_QUICK = Mission("rendezvous-2d", 3, sets=("lockstep.deadline_s=3",), realtime=25.0)


_THOUGHTFUL = Mission("rendezvous-2d", 3, sets=("lockstep.deadline_s=3", "planner.round_s=2.5"), realtime=25.0)


def seeded_step(seed):
    """A step of the flight, as the world's log tells them."""
    return random.Random(seed).choice(range(200, 1001, 200))


class Deaths(ContainerCase):
    def test_an_agent_is_killed_and_another_container_takes_its_place(self):
        swarm = self.swarm(_QUICK)
        world = swarm.start_world(*_QUICK.flags())
        agents = swarm.start_agents()
        step = seeded_step(2)
        world.reaches("flying", step)
        faults.kill_process(agents[0])
        self.assertEqual(agents[0].wait(), 137)
        newcomer = swarm.start_agent()
        newcomer.says("rejoined at round")
        self.assertEqual(newcomer.wait(), 0)
        world.wait()
        report = world.report()
        self.assertEqual([change["reason"] for change in report["roster_changes"]], ["deadline", "rejoined"])
        self.assert_replays(swarm, report)
        note(f"kill -9 of an agent after step {step}; a new container without id", "rendezvous-2d",
             f"{losses_of(report)}; exit code {report['exit_code']}; replays to the same state hash")

    def test_an_agent_that_dies_while_planning_comes_back_by_its_restart_policy(self):
        swarm = self.swarm(_THOUGHTFUL)
        world = swarm.start_world(*_THOUGHTFUL.flags())
        agents = [swarm.start_agent(options=("--restart", "on-failure")) for _ in range(_THOUGHTFUL.agents)]
        world.reaches("planning", 20)
        faults.kill_process(agents[1])
        world.wait()
        report = world.report()
        self.assertEqual([change["reason"] for change in report["roster_changes"]], ["deadline", "rejoined"])
        self.assertEqual(report["roster_changes"][0]["step"], 0)
        self.assert_replays(swarm, report)
        note("kill -9 of an agent while it plans; its container is restarted", "rendezvous-2d",
             f"{losses_of(report)}; exit code {report['exit_code']}; replays to the same state hash")

    def test_a_ground_station_is_killed_and_another_one_attaches(self):
        swarm = self.swarm(RENDEZVOUS)
        world = swarm.start_world(*RENDEZVOUS.flags())
        first = swarm.start_station()
        swarm.start_agents()
        step = seeded_step(3)
        world.reaches("flying", step)
        first.kill()
        self.assertEqual(first.wait(), 137)
        second = swarm.start_station()
        report = self.assert_undisturbed(world, swarm, RENDEZVOUS)
        self.assertEqual(second.wait(), 0, second.log())
        self.assertIn(report["state_hash"], second.log())
        note(f"kill -9 of the ground station after step {step}; another one attaches", "rendezvous-2d",
             "same state hash; the second one ends with the run's exit code")

    def test_a_world_is_killed_and_everybody_starts_again(self):
        swarm = self.swarm(RENDEZVOUS)
        impatient = ("--restart", "on-failure", "-e", "SKEIN_WORLD_TIMEOUT=5")
        world = swarm.start_world(*RENDEZVOUS.flags())
        station = swarm.start_station()
        agents = swarm.start_agents(options=impatient)
        step = seeded_step(4)
        world.reaches("flying", step)
        faults.kill_process(world)
        self.assertEqual(world.wait(), 137)
        self.assertEqual(station.wait(), 4, station.log())
        for agent in agents:
            agent.says("no tick of a world for 5 s")
        again = swarm.start_world()
        report = self.assert_undisturbed(again, swarm, RENDEZVOUS)
        self.assertEqual(report["roster_changes"], [])
        note(f"kill -9 of the world after step {step}; another one starts", "rendezvous-2d",
             "agents and ground station say so (exit codes 3 and 4); restarted, the whole run has the same state hash")

    def test_a_world_is_killed_and_goes_on_from_its_checkpoint(self):
        swarm = self.swarm(RENDEZVOUS)
        world = swarm.start_world(*RENDEZVOUS.flags(), "--checkpoint", "/runs/checkpoint",
                                  options=("--restart", "on-failure"))
        swarm.start_agents()
        step = seeded_step(5)
        world.reaches("flying", step)
        faults.kill_process(world)
        world.says("goes on with the run from its checkpoint")
        report = self.assert_undisturbed(world, swarm, RENDEZVOUS)
        self.assertEqual(report["world_restarts"], 1)
        note(f"kill -9 of the world with a checkpoint after step {step}; its container is restarted", "rendezvous-2d",
             "it goes on; same state hash")
