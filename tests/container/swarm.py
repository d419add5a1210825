"""A swarm of containers on a network of its own: a world, agents, ground stations; gone with its scope."""

import json
import re
import subprocess
import tempfile
import threading
import uuid
from pathlib import Path

LABEL = "skein-container-test"
_PROGRESS = re.compile(r"progress (\{.*\})")


def until(condition, limit_s, what):
    """Polls until `condition` gives something true, and gives that back.

    After `limit_s` an AssertionError names `what`, which is a text or gives one.
    """
    pause = threading.Event()
    for _ in range(int(limit_s / 0.1) + 1):
        found = condition()
        if found:
            return found
        pause.wait(0.1)
    raise AssertionError(f"not within {limit_s} s: {what() if callable(what) else what}")


class Container:
    """One process of the swarm in its container."""

    def __init__(self, engine, name):
        self.engine = engine
        self.name = name

    def log(self):
        return self.engine.run("logs", self.name, merged=True)

    def pid(self):
        return self.engine.inspect(self.name)["State"]["Pid"]

    def address(self):
        """In the swarm's network."""
        networks = self.engine.inspect(self.name)["NetworkSettings"]["Networks"]
        return next(network["IPAddress"] for network in networks.values())

    def running(self):
        return self.engine.inspect(self.name)["State"]["Running"]

    def wait(self, limit_s=120):
        """Its exit code, once it has ended."""
        try:
            return int(self.engine.run("wait", self.name, limit_s=limit_s).split()[-1])
        except subprocess.TimeoutExpired:
            state = self.engine.inspect(self.name)["State"]["Status"]
            raise AssertionError(f"{self.name} did not end within {limit_s} s, it is {state}:\n"
                                 f"{self.log()[-3000:]}") from None

    def kill(self):
        self.engine.run("kill", "-s", "KILL", self.name)

    def says(self, text, limit_s=60):
        """Waits until its log contains the text."""
        until(lambda: text in self.log(), limit_s, lambda: f"'{text}' in the log of {self.name}:\n{self.log()[-2000:]}")

    def file(self, path):
        """The text of a file in it, running or not."""
        with tempfile.TemporaryDirectory() as folder:
            place = Path(folder) / "file"
            self.engine.run("cp", f"{self.name}:{path}", place)
            return place.read_text(encoding="utf-8")


class World(Container):
    def progress(self):
        """What it said of its progress last."""
        said = _PROGRESS.findall(self.log())
        return json.loads(said[-1]) if said else {"phase": "none", "step": 0, "round": 0}

    def reaches(self, phase, at, limit_s=90):
        """Waits for a planning round or a flight step; the log names every tenth round and every 200th step."""
        counter = "round" if phase == "planning" else "step"

        def there():
            said = self.progress()
            return said["phase"] == "finished" or (said["phase"] == phase and said[counter] >= at) or (
                phase == "planning" and said["phase"] == "flying")
        until(there, limit_s, lambda: f"{phase} {at} of {self.name}:\n{self.log()[-2000:]}")

    def report(self):
        return json.loads(self.file("/runs/out/report.json"))


class Swarm:
    """Starts containers of the image on one network, and removes all of it at the end."""

    def __init__(self, engine, image, scenario, agents, seed=1, sets=()):
        self.engine, self.image, self.agents_number = engine, image, agents
        self.arguments = [f"/scenarios/{scenario}.yaml", "--seed", str(seed)]
        for pair in sets:
            self.arguments += ["--set", pair]
        self.mark = f"skein-{uuid.uuid4().hex[:8]}"
        self.label = f"{LABEL}={self.mark}"
        self.swarm = self.mark
        self.agents = []
        self.made = 0

    def __enter__(self):
        self.engine.run("network", "create", "--label", self.label, self.mark)
        return self

    def __exit__(self, *_):
        self.engine.remove_all(self.label)

    def container(self, kind, role, *words, options=()):
        """Starts a process in a container of its own. `kind` is the class that stands for it."""
        self.made += 1
        name = f"{self.mark}-{role}-{self.made}"
        self.engine.run("run", "-d", "--name", name, "--label", self.label, "--network", self.mark,
                        "-e", f"SKEIN_SWARM={self.swarm}", *options, self.image, *words)
        return kind(self.engine, name)

    def start_world(self, *flags, options=(), out="/runs/out"):
        return self.container(World, "world", "skein-simworld", *self.arguments, "--out", out, *flags, options=options)

    def start_agent(self, *flags, options=()):
        agent = self.container(Container, "agent", "skein-agent", *flags, options=options)
        self.agents.append(agent)
        return agent

    def start_agents(self, **keywords):
        return [self.start_agent(**keywords) for _ in range(self.agents_number)]

    def start_station(self, options=()):
        return self.container(Container, "station", "skein", "run", "--attach", "--json", options=options)

    def in_process(self, *flags, roster=None):
        """The same run in one process in memory. @return its report; `roster`: a report whose losses are repeated"""
        name = f"{self.mark}-alone-{self.made}"
        self.made += 1
        words = ["skein", "run", *self.arguments, "--in-process", "--json", "--out", "/tmp/alone", *flags]
        if roster is not None:
            words += ["--roster", "/tmp/roster.json"]
        self.engine.run("create", "--name", name, "--label", self.label, "--network", "none", self.image, *words)
        if roster is not None:
            with tempfile.TemporaryDirectory() as folder:
                place = Path(folder) / "roster.json"
                place.write_text(json.dumps(roster), encoding="utf-8")
                place.chmod(0o644)
                self.engine.run("cp", place, f"{name}:/tmp/roster.json")
        self.engine.run("start", name)
        Container(self.engine, name).wait()
        report = json.loads(Container(self.engine, name).file("/tmp/alone/report.json"))
        self.engine.run("rm", name)
        return report
