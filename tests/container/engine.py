"""The container engine as the tests use it: podman, or docker, driven over its command line.

Environment: SKEIN_ENGINE (podman or docker; default: the first that works), SKEIN_ENGINE_OPTIONS (words before each
command), SKEIN_CONTAINER_CACHE (folder; default ~/.cache/skein/containers). What podman needs on such a machine stands
in files of the tests' own, in the cache: nothing of the host's configuration is read or written, and images and
containers are in a store of their own.
"""

import json
import os
import shlex
import shutil
import subprocess
from pathlib import Path

_CONTAINERS_CONF = """# made by tests/container/engine.py
[containers]
default_ulimits = ["nofile=1024:2048", "nproc=4096:8192"]
log_driver = "k8s-file"
[engine]
runtime = "runc"
cgroup_manager = "cgroupfs"
events_logger = "file"
lock_type = "file"
tmp_dir = "{cache}/run/libpod"
[network]
network_backend = "cni"
network_config_dir = "{cache}/networks"
"""
_STORAGE_CONF = """# made by tests/container/engine.py
[storage]
driver = "overlay"
graphroot = "{cache}/storage"
runroot = "{cache}/run"
"""


class EngineError(RuntimeError):
    """A command of the engine failed; the text is the command and what it said."""


def cache_folder():
    default = Path(os.environ.get("XDG_CACHE_HOME", Path.home() / ".cache")) / "skein" / "containers"
    return Path(os.environ.get("SKEIN_CONTAINER_CACHE", default)).resolve()


def _podman_environment(cache):
    for name in ("run/libpod", "networks", "storage", "build"):
        (cache / name).mkdir(parents=True, exist_ok=True)
    files = {"CONTAINERS_CONF": ("containers.conf", _CONTAINERS_CONF),
             "CONTAINERS_STORAGE_CONF": ("storage.conf", _STORAGE_CONF)}
    environment = {"TMPDIR": str(cache / "build")}
    for variable, (name, text) in files.items():
        (cache / name).write_text(text.format(cache=cache), encoding="utf-8")
        environment[variable] = str(cache / name)
    return environment


class Engine:
    def __init__(self):
        self.cache = cache_folder()
        self.name = os.environ.get("SKEIN_ENGINE") or self._first_there()
        self.options = shlex.split(os.environ.get("SKEIN_ENGINE_OPTIONS", ""))
        self.environment = dict(os.environ)
        if self.name == "podman":
            self.environment.update(_podman_environment(self.cache))

    @staticmethod
    def _first_there():
        if shutil.which("podman"):
            return "podman"
        works = shutil.which("docker") and subprocess.run(["docker", "info"], capture_output=True, check=False)
        if works and works.returncode == 0:
            return "docker"
        raise EngineError("neither podman nor a docker that runs is here; deploy/setup.sh container installs podman")

    def command(self, *words):
        return [self.name, *self.options, *map(str, words)]

    def start(self, *words, **keywords):
        """A process of the engine that goes on."""
        return subprocess.Popen(self.command(*words), env=self.environment, stdin=subprocess.DEVNULL, **keywords)

    def run(self, *words, limit_s=120, check=True, merged=False):
        """What a command printed on its standard output; `merged`: and on its standard error.

        Raises EngineError when it fails (unless not `check`), subprocess.TimeoutExpired after `limit_s`.
        """
        done = subprocess.run(self.command(*words), env=self.environment, stdin=subprocess.DEVNULL, timeout=limit_s,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT if merged else subprocess.PIPE,
                              check=False)
        output = done.stdout.decode(errors="replace")
        if check and done.returncode != 0:
            said = output if merged else done.stderr.decode(errors="replace")
            raise EngineError(f"{shlex.join(self.command(*words))} ended with {done.returncode}: {said[-3000:]}")
        return output

    def has_image(self, name):
        return subprocess.run(self.command("image", "inspect", name), env=self.environment, capture_output=True,
                              check=False).returncode == 0

    def inspect(self, container):
        return json.loads(self.run("inspect", container))[0]

    def labels_of_networks(self, label):
        """The values of that label, one for each network that has it."""
        networks = self.run("network", "ls", "-q", "--filter", f"label={label}").split()
        listed = json.loads(self.run("network", "inspect", *networks)) if networks else []
        return [(network.get("labels") or network.get("Labels"))[label] for network in listed]

    def remove_all(self, label):
        """Ends and removes every container and network that carries the label."""
        containers = self.run("ps", "-aq", "--filter", f"label={label}").split()
        if containers:
            self.run("rm", "-f", "-v", *containers)
        networks = self.run("network", "ls", "-q", "--filter", f"label={label}").split()
        for network in networks:
            self.run("network", "rm", network)
