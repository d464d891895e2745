"""--resume: wherever and however often a run is killed, the same call reaches the result of an
uninterrupted run; a damaged state is refused in one line or resumed correctly; a state in use or of
another call is refused.

    python3 resume_test.py [Class.test] MPIEXEC MORTAL KUSABI SOURCES

MPIEXEC is the launcher with its option for the number of ranks, in one word; MORTAL the library of
resume/mortal.cpp.
"""
import fcntl
import json
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import unittest

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
from kusabi_case import EXAMPLES, KUSABI, SOURCES, KusabiCase, main  # noqa: E402: beside the folder of this file

MORTAL = sys.argv.pop()
MPIEXEC = sys.argv.pop().split()
KILLED = (-signal.SIGKILL, 128 + signal.SIGKILL, signal.SIGKILL)  # of a shell, Open MPI and MPICH
# More kills every night.
THOROUGH = "KUSABI_THOROUGH" in os.environ
# Seconds between two reductions of a search.
OFTEN = ("--checkpoint-interval", "1e-6")

# Calls of less than a second: one for each driver of searches.
CALLS = {
    "patterns": ("patterns", EXAMPLES / "space-truss.toml", "--mu", 0.65, "--branching", "paper", "--sort", "critical"),
    "bounds": ("patterns", EXAMPLES / "space-truss.toml", "--mu", 0.65, "--cuts", "always"),
    "descent": ("critical", EXAMPLES / "plane-truss.toml"),
    "newton": ("critical", EXAMPLES / "plane-truss.toml", "--method", "newton", "--mu-max", 1.2),
    "tree": ("rays", EXAMPLES / "plane-truss.toml", "--mu", 0.9, "--method", "tree"),
    "double description": ("rays", EXAMPLES / "plane-truss.toml", "--mu", 0.9),
    "static cuts": ("limit", EXAMPLES / "static-gap.toml", "--alpha", 0.35, "--curve"),
    "zero-one": ("limit", EXAMPLES / "static-gap.toml", "--alpha", 0.45, "--cuts", "disjunctive", "--big-m", 20,
                 "--samples", 40),
    "load cases": ("limit", EXAMPLES / "steel-mast.toml"),
    "friction": ("sweep", EXAMPLES / "plane-truss.toml", "--mu", "0.5:1:0.25"),
    "loads": ("sweep", EXAMPLES / "gust.toml", "--alpha", "0.1:0.3:0.1"),
    "program": ("mip", SOURCES / "tests/programs/warehouses.lp"),
}


# mpirun takes two seconds to end after a kill, so only some calls use it.
ON_TWO_RANKS = ("patterns", "static cuts", *(("descent", "tree") if THOROUGH else ()))


class Resumed(KusabiCase):
    def setUp(self):
        super().setUp()
        self.state = self.folder / "state"

    def run_it(self, call, *words, ranks=1, dies_at=None, rank=0, about="state"):
        environment = dict(os.environ)
        line = [KUSABI, *map(str, call), *map(str, words), "--output", str(self.result)]
        if dies_at:
            variables = {"KUSABI_MORTAL": dies_at, "KUSABI_MORTAL_RANK": rank, "KUSABI_MORTAL_FILE": about,
                         "LD_PRELOAD": MORTAL}
            line = ["env", *(f"{name}={value}" for name, value in variables.items()), *line]
        if ranks > 1:
            line = [*MPIEXEC, str(ranks), *line]
        return subprocess.run(line, capture_output=True, text=True, check=False, env=environment, timeout=250)

    def answer(self):
        """Part of the result that is the same for two runs."""
        result = json.loads(self.result.read_text())
        del result["statistics"]
        self.result.unlink()
        return json.dumps(result)

    def unbroken(self, call):
        run = self.run_it(call)
        self.assertIn(run.returncode, (0, 3), run.stderr)
        return run.returncode, self.answer()

    def resume(self, call, *words, **how):
        return self.run_it(call, "--resume", self.state, *OFTEN, *words, **how)

    def check_end(self, call, expected, **how):
        run = self.resume(call, **how)
        self.assertEqual((run.returncode, self.answer()), expected, run.stderr)
        return run

    def begin(self, call, dies_at):
        """Leaves the state of a killed run."""
        run = self.resume(call, dies_at=dies_at)
        self.assertIn(run.returncode, KILLED, run.stderr)


class Killed(Resumed):
    """Kills, each a little later, alternating between before and during a system call."""

    def check(self, name, ranks=1, kills=10 if THOROUGH else 3):
        call = CALLS[name]
        expected = self.unbroken(call)
        killed = 0
        for number in range(1, kills + 1):
            # The last of several ranks writes only the state of its search.
            run = self.resume(call, ranks=ranks, dies_at=number, rank=ranks - 1 if number == kills else 0)
            if self.result.exists():
                self.assertEqual(self.answer(), expected[1])  # files are complete before a run is
                                                              # finished
            if run.returncode in (0, 3):
                break
            self.assertIn(run.returncode, KILLED, run.stderr)
            killed += 1
        self.assertGreaterEqual(killed, 2, f"{name} was too short to be killed")
        self.check_end(call, expected, ranks=ranks)
        # The analysis is finished, and repeats its result, also on another number of ranks.
        self.check_end(call, expected)


def add_kills():
    for name in CALLS:
        def alone(self, name=name):
            self.check(name)

        def on_two(self, name=name):
            self.check(name, ranks=2, kills=4 if THOROUGH else 3)
        word = name.replace(" ", "_").replace("-", "_")
        setattr(Killed, f"test_{word}", alone)
        if name in ON_TWO_RANKS:
            setattr(Killed, f"test_{word}_on_two_ranks", on_two)


add_kills()


class State(Resumed):
    CALL = CALLS["patterns"]

    def refused_state(self, call, *words):
        run = self.resume(call, *words)
        self.assertEqual((run.returncode, run.stderr.count("\n")), (2, 1), run.stderr)
        self.assertIn(str(self.state), run.stderr)
        return run.stderr

    def test_of_a_finished_run_ignores_the_time_limit(self):
        expected = self.unbroken(self.CALL)
        self.check_end(self.CALL, expected)
        run = self.resume(self.CALL, "--time-limit", "0.000001")
        self.assertEqual((run.returncode, self.answer()), expected, run.stderr)
        self.assertIn("finished before", run.stderr)

    def test_is_resumed_after_a_limit_by_the_printed_call(self):
        expected = self.unbroken(self.CALL)
        run = self.resume(self.CALL, "--node-limit", 5)
        self.assertEqual(run.returncode, 3, run.stderr)
        line = run.stderr[run.stderr.index("resume with: ") + len("resume with: "):].splitlines()[0]
        self.assertNotIn("--node-limit", line)
        self.assertTrue(line.startswith("kusabi patterns "), line)
        path = f"{pathlib.Path(KUSABI).parent}:{os.environ['PATH']}"
        run = subprocess.run(["sh", "-c", line], capture_output=True, text=True, check=False,
                             env={**os.environ, "PATH": path})
        self.assertEqual((run.returncode, self.answer()), expected, run.stderr)

    def test_belongs_to_one_call(self):
        self.begin(self.CALL, 4)
        for words, why in ((("--mu", 0.7), "was started with --mu 0.65, and this call has --mu 0.7"),
                           (("--tolerance", 1e-7), "--tolerance"), (("--certificate", self.folder / "c"), "--certificate"),
                           (("--branching", "deepest"), "--branching paper")):
            call = [*self.CALL]
            if words[0] in call:
                at = call.index(words[0])
                del call[at:at + 2]
            with self.subTest(why):
                self.assertIn(why, self.refused_state((*call, *words)))
        other = (self.CALL[0], EXAMPLES / "plane-truss.toml", *self.CALL[2:])
        self.assertIn("the problem", self.refused_state(other))
        self.assertIn("command", self.refused_state(("rays", EXAMPLES / "plane-truss.toml", "--mu", 0.65)))
        # The same number, and options that do not change the result.
        expected = self.unbroken(self.CALL)
        call = [*self.CALL[:-1], "margin", "--top", "2", "--tolerance", "1.0e-12"]
        call[3] = "0.650"
        run = self.resume(call)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.result.unlink()
        self.check_end(self.CALL, expected)

    def test_in_use_is_refused(self):
        with open(self.state, "w", encoding="ascii") as file:
            fcntl.flock(file, fcntl.LOCK_EX)
            self.assertIn("is in use by another run", self.refused_state(self.CALL, "--resume-wait", 0))
        self.check_end(self.CALL, self.unbroken(self.CALL))

    def test_in_use_is_waited_for(self):
        expected = self.unbroken(self.CALL)
        line = [KUSABI, *map(str, self.CALL), "--resume", str(self.state), "--resume-wait", "200", "--output",
                str(self.result)]
        with open(self.state, "w", encoding="ascii") as file:
            fcntl.flock(file, fcntl.LOCK_EX)
            run = subprocess.Popen(line, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
            said = run.stderr.readline()
        # The other run closes the file when it ends.
        _, rest = run.communicate(timeout=250)
        self.assertIn(f"{self.state}: in use by another run; waiting up to 200 s", said)
        self.assertNotIn("in use", rest)
        self.assertEqual((run.returncode, self.answer()), expected, rest)

    def test_does_not_replace_another_file(self):
        self.state.write_text("what somebody wrote\n")
        self.assertIn("is not a state to resume from", self.refused_state(self.CALL))
        self.assertEqual(self.state.read_text(), "what somebody wrote\n")
        self.state.unlink()
        self.state.mkdir()
        self.assertIn("cannot be opened", self.refused_state(self.CALL))

    def check_damage(self, call, file, times, seed):
        """Each damage of a file is refused in one line, or the result is correct."""
        expected = self.unbroken(call)
        keep = self.folder / "whole"
        shutil.rmtree(keep, ignore_errors=True)
        keep.mkdir()
        for each in self.folder.glob("state*"):
            shutil.copy(each, keep)
        choice = random.Random(seed)
        content = (keep / file).read_bytes()
        refused = went_on = 0
        for time in range(times):
            broken = bytearray(content)
            if time % 3 == 0:
                del broken[choice.randrange(len(broken)):]
            else:
                broken[choice.randrange(len(broken))] ^= 1 << choice.randrange(8)
            for each in self.folder.glob("state*"):
                each.unlink()
            for each in keep.iterdir():
                shutil.copy(each, self.folder)
            (self.folder / file).write_bytes(broken)
            run = self.resume(call)
            if run.returncode == 0:
                went_on += 1
                self.assertEqual((0, self.answer()), expected)
            else:
                refused += 1
                self.assertEqual((run.returncode, run.stderr.count("\n")), (2, 1), run.stderr)
        self.assertGreater(refused + went_on, 0)
        return refused, went_on

    def test_of_a_finished_run_is_refused_or_resumed_if_damaged(self):
        self.assertEqual(self.resume(self.CALL).returncode, 0)
        _, went_on = self.check_damage(self.CALL, "state", 30, 1)
        self.assertGreater(went_on, 0)

    def test_of_a_running_search_is_refused_or_resumed_if_damaged(self):
        self.resume(self.CALL, "--node-limit", 5)
        names = sorted(each.name for each in self.folder.glob("state.search*"))
        self.assertTrue(names)
        for seed, name in enumerate(names):
            with self.subTest(name):
                refused, _ = self.check_damage(self.CALL, name, 6, seed)
                self.assertGreater(refused, 0)

    def test_keeps_the_evidence_of_a_certificate(self):
        certificate = self.folder / "certificate"
        call = (*self.CALL[:-2], "--certificate", certificate)
        expected = self.unbroken(call)
        whole = sorted(certificate.read_text().splitlines()[:-2])
        certificate.unlink()
        # Killed at any write of the state and of the certificate.
        for about in ("state", "certificate"):
            for number in range(1, 9):
                self.resume(call, dies_at=number, about=about)
            self.check_end(call, expected)
            self.assertEqual(sorted(set(certificate.read_text().splitlines()[:-2])), sorted(set(whole)))
            self.assertEqual(list(self.folder.glob("certificate.*")), [])
            self.check_end(call, expected)
            proof = self.kusabi("verify", certificate, "--problem", self.CALL[1])
            self.assertEqual(proof.returncode, 0, proof.stderr)
            certificate.unlink()
            self.assertIn("nor its parts", self.resume(call).stderr)
            for each in self.folder.glob("state*"):
                each.unlink()


class Improved(Resumed):
    def test_a_better_solution_is_saved_at_once(self):
        """With a long interval, states are kept because a better solution was found."""
        for name in ("program", "zero-one"):
            call = CALLS[name]
            saves = {}
            for word in ("interval", "improvement"):
                # Number of files written; the run is killed at the first one of a search.
                run = self.run_it(call, "--resume", self.state, "--save-on", word, dies_at=1, about="state.search")
                saves[word] = run.returncode in KILLED
                if not saves[word]:
                    self.assertIn(run.returncode, (0, 3), run.stderr)
                for each in self.folder.glob("state*"):
                    each.unlink()
            self.assertEqual(saves, {"interval": False, "improvement": True}, name)


class Verified(Resumed):
    """The result of a verification is its text."""

    QUESTIONS = {"patterns": ("patterns", EXAMPLES / "space-truss.toml", "--mu", 0.65),
                 "limit": ("limit", EXAMPLES / "static-gap.toml", "--alpha", 0.35)}

    def verify(self, name, *words, dies_at=None):
        line = [KUSABI, "verify", str(self.folder / name), "--problem", str(self.QUESTIONS[name][1]), *map(str, words)]
        if dies_at:
            line = ["env", f"LD_PRELOAD={MORTAL}", f"KUSABI_MORTAL={dies_at}", "KUSABI_MORTAL_FILE=state", *line]
        return subprocess.run(line, capture_output=True, text=True, check=False, timeout=250)

    def test_a_resumed_verification_has_the_same_result(self):
        for name, question in self.QUESTIONS.items():
            self.assertEqual(self.kusabi(*question, "--certificate", self.folder / name).returncode, 0)
            unbroken = self.verify(name)
            self.assertEqual(unbroken.returncode, 0, unbroken.stderr)
            self.assertIn("PROVED", unbroken.stdout)
            killed = 0
            for number in range(1, 9):
                run = self.verify(name, "--resume", self.state, *OFTEN, dies_at=number)
                if run.returncode == 0:
                    break
                self.assertIn(run.returncode, KILLED, run.stderr)
                if "PROVED" in run.stdout:  # printed before the run is recorded as finished
                    self.assertEqual(run.stdout, unbroken.stdout)
                killed += 1
            self.assertGreaterEqual(killed, 2, name)
            for _ in range(2):  # resumed, then finished
                run = self.verify(name, "--resume", self.state, *OFTEN)
                self.assertEqual((run.returncode, run.stdout), (0, unbroken.stdout), run.stderr)
            self.assertIn("finished before", run.stderr)
            for each in self.folder.glob("state*"):
                each.unlink()


class TimeLimit(KusabiCase):
    CALL = ("patterns", EXAMPLES / "space-truss.toml", "--mu", 0.65, "--quiet")

    def test_is_a_duration(self):
        for text in ("5400", "90s", "1h30m", "2d", "0.5h"):
            self.assertEqual(self.kusabi(*self.CALL, "--time-limit", text).returncode, 0, text)
        for text in ("0", "-1", "1m1h", "1h30", "h", "", "1x", "nan", "inf", "Slurm"):
            self.assertIn("--time-limit", self.refused(*self.CALL, f"--time-limit={text}"))

    def test_is_the_end_of_a_job(self):
        environment = {name: value for name, value in os.environ.items() if not name.startswith("SLURM_")}
        call = (*self.CALL, "--time-limit", "slurm")
        run = self.kusabi(*call, env=environment)
        self.assertEqual((run.returncode, run.stderr.count("\n")), (2, 1))
        self.assertIn("not in a Slurm job", run.stderr)
        environment["SLURM_JOB_ID"] = "1"
        environment["SLURM_JOB_END_TIME"] = "4000000000"
        self.assertEqual(self.kusabi(*call, env=environment).returncode, 0)
        environment["SLURM_JOB_END_TIME"] = "1000000000"  # in the past
        truss = self.folder / "truss.toml"
        subprocess.run([KUSABI, "example", "space-truss", "--rows", "12", "--output", truss], capture_output=True,
                       check=True)
        run = self.kusabi("patterns", truss, "--mu", 2, "--cuts", "none", "--branching", "paper", "--time-limit", "slurm",
                          env=environment)
        self.assertEqual(run.returncode, 3, run.stderr)
        self.assertIn("time-limit", run.stderr)


if __name__ == "__main__":
    main()
