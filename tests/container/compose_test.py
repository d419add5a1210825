"""The compositions of deploy/: what the README shows."""

import subprocess
import uuid

from case import ContainerCase, Mission, Suite, note
from image import ROOT, ensure_discovery_image
from swarm import Container, World, until

PROJECT = "com.docker.compose.project"
_COMMANDS = {"podman": ["podman-compose"], "docker": ["docker", "compose"]}


class Composition:
    """One project of podman-compose or docker compose; gone with its scope."""

    def __init__(self, files, agents):
        self.project = f"skeintest{uuid.uuid4().hex[:8]}"
        self.words = list(_COMMANDS[Suite.engine.name])
        for name in files:
            self.words += ["-f", str(ROOT / "deploy" / name)]
        self.words += ["-p", self.project]
        self.environment = dict(Suite.engine.environment, AGENTS=str(agents))

    def __enter__(self):
        Suite.engine.run("tag", Suite.image, "localhost/skein:latest")
        return self

    def __exit__(self, *_):
        self._compose("down", "-v")
        Suite.engine.remove_all(f"{PROJECT}={self.project}")  # Debian's podman-compose leaves the network

    def _compose(self, *words):
        done = subprocess.run([*self.words, *words], env=self.environment, stdin=subprocess.DEVNULL, timeout=300,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
        return done.stdout.decode()

    def up(self):
        return self._compose("up", "-d")

    def members(self, service, kind=Container):
        names = Suite.engine.run("ps", "-a", "--format", "{{.Names}}", "--filter",
                                 f"label={PROJECT}={self.project}").split()
        return [kind(Suite.engine, name) for name in names if service in name.replace("-", "_").split("_")]


class Compositions(ContainerCase):
    def whole(self, files, agents):
        mission = Mission("rendezvous-ring", agents, sets=(f"vehicles.ring.agents={agents}",))
        with Composition(files, agents) as composition:
            said = composition.up()
            worlds = until(lambda: composition.members("world", World), 10, f"a world:\n{said}")
            self.assertEqual(len(composition.members("agent")), agents, said)
            self.assertEqual(worlds[0].wait(180), 0, worlds[0].log()[-3000:])
            report = worlds[0].report()
            station = composition.members("station")[0]
            self.assertEqual(station.wait(60), 0, station.log())
            for agent in composition.members("agent"):
                self.assertEqual(agent.wait(60), 0, agent.log())
        self.assertEqual(len(report["vehicles"]), agents)
        self.assertEqual(report["state_hash"], self.reference(mission)["state_hash"])
        return report

    def test_six_agents(self):
        self.whole(["compose.yaml"], 6)
        note("nothing: AGENTS=6, deploy/compose.yaml", "rendezvous-ring, 6 agents", "same state hash as in process")

    def test_a_discovery_server_instead_of_multicast(self):
        Suite.engine.run("tag", ensure_discovery_image(Suite.engine), "localhost/skein-discovery:latest")
        self.whole(["compose.yaml", "compose.discovery.yaml"], 4)
        note("no multicast: a discovery server, deploy/compose.discovery.yaml", "rendezvous-ring, 4 agents",
             "same state hash as in process")
