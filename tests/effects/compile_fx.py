"""Compiles one entry point of an effect with the D3DCompile of Wine 10.

    compile_fx.py FILE ENTRY PROFILE      e.g. table1.fx LumaDiffusePS ps_2_0

Prints the disassembly and its instruction slots; those without copies (mov) are closer to what
an optimising compiler needs, which Wine's is not. Exit status 0: compiled; 1: refused, with the
compiler's messages; 2: Wine failed; 3: not installed, with the reason.

Wine runs in the Debian 13 folder that `scripts/install-extras trixie` creates: in namespaces of its
own for mounts and processes, so that nothing stays mounted or running.
LUMAKNOT_TRIXIE names the folder when it is not the default.
"""

import contextlib
import fcntl
import hashlib
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

import d3d9_slots

CROSS_COMPILER = "x86_64-w64-mingw32-gcc"
SOURCE = Path(__file__).with_name("compile_fx.c")
WINE = "/usr/lib/wine/wine64"
HOME = "/var/lib/lumaknot"  # inside the Debian 13 folder
LONGEST = 200  # entry points in one start: Windows ends a command line at 32767 characters
DEADLINE = 300.0  # seconds for everything: half a second of compiling, ten of a first start


class WineFailed(Exception):
    """Wine did not start, did not end in time, or printed something unexpected."""


@dataclass
class Compiled:
    """The result of D3DCompile for one entry point."""
    ok: bool
    disassembly: str  # empty when refused
    messages: str  # the compiler's errors and warnings, one line each

    @property
    def slots(self):
        """The d3d9_slots.Slots of the disassembly."""
        return d3d9_slots.count(self.disassembly)


def trixie_folder():
    """The Debian 13 folder, whether it exists or not."""
    cache = os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache"
    return Path(os.environ.get("LUMAKNOT_TRIXIE") or Path(cache) / "lumaknot" / "trixie").resolve()


def why_not_installed(folder):
    """Why nothing can be compiled here, or an empty text."""
    if not os.path.exists(f"{folder}{WINE}"):
        return f"no Wine 10 in {folder}; scripts/install-extras trixie puts it there"
    if os.geteuid() != 0:
        return f"only root can enter {folder}"
    if not shutil.which(CROSS_COMPILER):
        return f"no {CROSS_COMPILER}; scripts/install-extras trixie installs it"
    if not shutil.which("unshare"):
        return "no unshare (package util-linux)"
    probe = subprocess.run(["unshare", "--mount", "--pid", "--fork", "true"],
                           capture_output=True, check=False)
    return "" if probe.returncode == 0 else "no right to make namespaces (CAP_SYS_ADMIN)"


def compile_entries(requests, folder=None):
    """Compiles each (file, entry, profile) of a list, many in one start of Wine.

    folder: the Debian 13 to use. Returns a Compiled for each. A hundred cost little more than one.
    """
    folder = folder or trixie_folder()
    deadline = time.monotonic() + DEADLINE
    with exclusive(folder, deadline):
        program = build_program(folder)
        make_prefix(folder, deadline)
        return [result for first in range(0, len(requests), LONGEST)
                for result in compile_some(requests[first:first + LONGEST], folder, program,
                                           deadline)]


def compile_entry(file, entry, profile, folder=None):
    """Compiles the function `entry` of the effect `file`."""
    return compile_entries([(file, entry, profile)], folder)[0]


def compile_some(requests, folder, program, deadline):
    """compile_entries for as many as one command line holds."""
    with tempfile.TemporaryDirectory(prefix="fx-", dir=folder / "tmp") as work:
        shutil.copy(program, work)
        triples = [word for index, (file, entry, profile) in enumerate(requests)
                   for word in (copy_in(file, work, index), entry, profile)]
        done = run(folder, f"/tmp/{Path(work).name}", deadline, [WINE, program.name, *triples])
    return read_results(requests, done)


def copy_in(file, work, index):
    """Copies a file under a unique name into `work`; returns the name, seen from there."""
    folder = Path(work, str(index))
    folder.mkdir()
    return shutil.copy(file, folder).removeprefix(f"{work}/")


def read_results(requests, done):
    """The Compiled of each request, from the output of compile_fx.exe."""
    assembly = done.stdout.replace("\r", "").split("\f")
    messages = [re.sub(rf"^{index}/", "", said, flags=re.MULTILINE)
                for index, said in enumerate(done.stderr.replace("\r", "").split("\f"))]
    results = [Compiled(text[:3] in ("vs_", "ps_"), text, said)
               for _, text, said in zip(requests, assembly, messages)]
    believable = all(result.ok or "D3DCompile failed" in result.messages for result in results)
    expected = 0 if all(result.ok for result in results) else 1
    if len(results) != len(requests) or not believable or done.returncode != expected:
        raise WineFailed(f"Wine ended with {done.returncode}: {done.stderr or done.stdout}")
    return results


@contextlib.contextmanager
def exclusive(folder, deadline):
    """One Wine at a time: two would share a server that ends with the first of them."""
    with open(f"{folder}.lock", "w", encoding="utf-8") as lock:
        while True:
            try:
                fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
                break
            except BlockingIOError:
                if time.monotonic() > deadline:
                    raise WineFailed(f"{lock.name} stayed locked") from None
                time.sleep(0.1)
        yield


def build_program(folder):
    """compile_fx.exe next to the Debian 13 folder; built again when its source changes."""
    digest = hashlib.sha256(SOURCE.read_bytes()).hexdigest()[:16]
    program = folder.with_name(f"compile_fx-{digest}.exe")
    if not program.exists():
        for old in folder.parent.glob("compile_fx-*"):
            old.unlink()
        part = program.with_suffix(".part")
        command = [CROSS_COMPILER, "-O2", "-s", "-DCOBJMACROS", "-Wall", "-Wextra", "-Werror",
                   str(SOURCE), "-o", str(part), "-ld3dcompiler_47"]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise WineFailed(f"{SOURCE.name} does not compile: {done.stderr}")
        part.rename(program)
    return program


def make_prefix(folder, deadline):
    """Wine's own files, created once. Hard links instead of copies save three quarters of a GB."""
    home = Path(f"{folder}{HOME}")
    if (home / "ready").exists():
        return
    shutil.rmtree(home, ignore_errors=True)
    home.mkdir(parents=True)
    script = (f"{WINE} wineboot --init && /usr/lib/wine/wineserver64 -w && "
              f"hardlink --content --quiet {HOME} /usr/lib/x86_64-linux-gnu/wine")
    done = run(folder, HOME, deadline, ["/bin/sh", "-c", script])
    if done.returncode != 0:
        raise WineFailed(f"wineboot ended with {done.returncode}: {done.stderr}")
    (home / "ready").touch()


def run(folder, work, deadline, command):
    """Runs a command in the Debian 13 folder, without a display; its process group ends with it."""
    environment = {
        "PATH": "/usr/sbin:/usr/bin:/sbin:/bin", "HOME": HOME, "LC_ALL": "C",
        "WINEPREFIX": f"{HOME}/wine", "WINEDEBUG": "-all",
        # neither .NET nor HTML nor a window
        "WINEDLLOVERRIDES": "mscoree,mshtml,winex11.drv,winewayland.drv=",
    }
    inside = [shutil.which("unshare"), "--mount", "--pid", "--fork", "--kill-child",
              f"--root={folder}", f"--wd={work}", "--mount-proc"]
    process = subprocess.Popen(
        inside + command, env=environment, encoding="utf-8", errors="replace",
        stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
        start_new_session=True)
    try:
        out, err = process.communicate(timeout=max(deadline - time.monotonic(), 0))
    except subprocess.TimeoutExpired:
        raise WineFailed(f"{command[0]} did not end within {DEADLINE:.0f} s") from None
    finally:
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)
        process.wait()
    return subprocess.CompletedProcess(command, process.returncode, out, err)


def main(arguments):
    """The command line."""
    if len(arguments) != 3:
        sys.exit(__doc__)
    if not re.fullmatch("[vp]s_[23]_[0-9ab]", arguments[2]):
        sys.exit(f"{arguments[2]} is not a profile of Direct3D 9 such as vs_2_0, ps_2_0 or ps_3_0")
    reason = why_not_installed(trixie_folder())
    if reason:
        print(f"not installed: {reason}", file=sys.stderr)
        return 3
    try:
        compiled = compile_entry(*arguments)
    except OSError as error:
        sys.exit(str(error))
    except WineFailed as failure:
        print(failure, file=sys.stderr)
        return 2
    sys.stderr.write(compiled.messages)
    if not compiled.ok:
        return 1
    sys.stdout.write(compiled.disassembly)
    print(f"slots: {compiled.slots.total}")
    print(f"slots without copies: {compiled.slots.without_copies}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
