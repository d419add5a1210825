"""The images: a plain Debian 12 made of packages where none can be pulled, and Skein's, from the Containerfile.

Both are kept in the engine's store between runs. The base is named by what goes into it (release, packages, sources);
the engine's layer cache knows when Skein's is still the one of this tree. SKEIN_IMAGE and SKEIN_DISCOVERY_IMAGE name
images that are there already.
"""

import hashlib
import os
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BASE = "docker.io/library/debian:12"
_SUITE = "bookworm"
_PACKAGES = ("ca-certificates",)
_SOURCES = (
    "deb http://deb.debian.org/debian bookworm main",
    "deb http://deb.debian.org/debian bookworm-updates main",
    "deb http://deb.debian.org/debian-security bookworm-security main",
)


def say(text):
    print(f"container: {text}", file=sys.stderr, flush=True)


def base_key():
    """Names what goes into the base image."""
    return hashlib.sha256("\n".join((_SUITE, *_PACKAGES, *_SOURCES)).encode()).hexdigest()[:16]


def _packed_base(engine):
    """The base as a packed tree, made by mmdebstrap unless it is in the cache."""
    packed = engine.cache / f"debian-{base_key()}.tar"
    if packed.is_file():
        return packed
    if shutil.which("mmdebstrap") is None:
        raise RuntimeError("mmdebstrap is not here; deploy/setup.sh container installs it")
    say("the base image is made of Debian's packages")
    growing = packed.with_suffix(".growing.tar")
    subprocess.run(["mmdebstrap", "--quiet", "--variant=minbase", f"--include={','.join(_PACKAGES)}", _SUITE,
                    str(growing), *_SOURCES], check=True, stdin=subprocess.DEVNULL, timeout=900)
    growing.rename(packed)
    return packed


def ensure_base(engine):
    """The base image under the name that the Containerfile expects."""
    marked = f"localhost/skein-base:{base_key()}"
    if engine.name == "docker":
        if not engine.has_image(BASE):
            engine.run("pull", BASE, limit_s=900)
        return
    if not engine.has_image(marked):
        engine.run("import", _packed_base(engine), marked, limit_s=600)
    engine.run("tag", marked, BASE)


def _compiler_cache(engine):
    """Options of a build that let it use the compiler's cache of this machine, if there is one. Docker has none."""
    if engine.name != "podman" or shutil.which("ccache") is None:
        return ()
    folder = Path(subprocess.run(["ccache", "--get-config", "cache_dir"], check=True, capture_output=True, text=True,
                                 stdin=subprocess.DEVNULL).stdout.strip())
    folder.mkdir(parents=True, exist_ok=True)
    return ("--volume", f"{folder}:/ccache")


def _build(engine, target, name):
    ensure_base(engine)
    say(f"{name} is built from deploy/Containerfile")
    jobs = os.environ.get("SKEIN_JOBS", str(os.cpu_count() or 2))
    engine.run("build", "-f", ROOT / "deploy" / "Containerfile", "--target", target, "--build-arg", f"JOBS={jobs}",
               *_compiler_cache(engine), "-t", name, ROOT, limit_s=3000, merged=True)
    return name


def ensure_image(engine):
    """Skein's image of this tree. @return its name"""
    return os.environ.get("SKEIN_IMAGE") or _build(engine, "runtime", "localhost/skein:test")


def ensure_discovery_image(engine):
    """That of the discovery server. @return its name"""
    return os.environ.get("SKEIN_DISCOVERY_IMAGE") or _build(engine, "discovery", "localhost/skein-discovery:test")
