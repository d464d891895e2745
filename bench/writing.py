#!/usr/bin/env python3
"""Time and memory to write a long list of patterns, and the time from a signal to the end.

    bench/writing.py KUSABI FILE MU PATTERNS [--ranks N] [--term] [option of kusabi patterns ...]

Without --term the search stops at PATTERNS patterns; with it, SIGTERM is sent (SIGUSR2 to mpirun)
when so many are in the progress lines. Prints patterns, seconds of the search, seconds from its end
(or the signal) to the exit, MB written, and the peak memory of each rank in MB.
"""
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import threading
import time


def option(words, name, otherwise):
    if name not in words:
        return otherwise
    at = words.index(name)
    value = words[at + 1]
    del words[at:at + 2]
    return value


def descendants(pid):
    """A process and all below it."""
    try:
        children = pathlib.Path(f"/proc/{pid}/task/{pid}/children").read_text().split()
    except OSError:
        return []
    return [pid] + [each for child in children for each in descendants(int(child))]


def note_memory(root, peaks):
    """Largest resident memory of each kusabi process, in MB, by process number."""
    for pid in descendants(root):
        try:
            text = pathlib.Path(f"/proc/{pid}/status").read_text()
        except OSError:
            continue
        high = re.search(r"VmHWM:\s+(\d+)", text)
        if high and text.startswith("Name:\tkusabi"):
            peaks[pid] = max(peaks.get(pid, 0), int(high[1]) / 1024)


def main():
    words = sys.argv[1:]
    ranks, by_signal = int(option(words, "--ranks", 1)), "--term" in words
    words = [word for word in words if word != "--term"]
    kusabi, file, mu, patterns, *more = words
    with tempfile.TemporaryDirectory(dir=os.environ.get("TMPDIR")) as folder:
        place, state = pathlib.Path(folder, "result"), pathlib.Path(folder, "state")
        call = [kusabi, "patterns", file, "--mu", mu, "--output", place, "--resume", state, "--top", "1", *more]
        if not by_signal:
            call += ["--pattern-limit", patterns]
        if ranks > 1:
            call = ["mpirun", "--mca", "odls_base_sigkill_timeout", "60", "-np", str(ranks), *call]
        began = time.time()
        run = subprocess.Popen(call, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        found, peaks = [0], {}

        def watch():
            for line in run.stderr:
                row = line.split()
                if len(row) == 9 and re.fullmatch(r"[0-9.]+[kM]?", row[4]):
                    found[0] = float(row[4].rstrip("kM")) * {"k": 1e3, "M": 1e6}.get(row[4][-1], 1)
        threading.Thread(target=watch, daemon=True).start()
        ended = None
        while run.poll() is None:
            note_memory(run.pid, peaks)
            if ended is None and by_signal and found[0] >= int(patterns):
                ended = time.time()
                run.send_signal(signal.SIGUSR2 if ranks > 1 else signal.SIGTERM)
            time.sleep(0.1)
        over = time.time()
        if not place.exists():
            sys.exit(f"writing.py: exit code {run.returncode}, and no result")
        ended = ended or os.stat(f"{state}.status").st_mtime
        saved = sum(path.stat().st_size for path in pathlib.Path(folder).glob("state*"))
        with place.open("rb") as file:
            count = int(re.search(rb'"count": ?(\d+)', file.read(10_000_000))[1])
        print(f"{count} patterns: {ended - began:.1f} s, then {over - ended:.2f} s to write {place.stat().st_size / 1e6:.0f} MB; "
              f"state {saved / 1e6:.1f} MB; peak MB {' '.join(f'{peaks[pid]:.0f}' for pid in sorted(peaks))}")


if __name__ == "__main__":
    main()
