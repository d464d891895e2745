"""docs/result.schema.json accepts every result of every example, and refuses results with a
missing, renamed or retyped key.

    python3 schema_test.py [Schema.test_NAME] KUSABI SOURCES

Exit code 77 (skipped): jsonschema is not installed (Debian: python3-jsonschema).
"""
import json
import pathlib
import sys

try:
    from jsonschema import Draft202012Validator
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
from kusabi_case import EXAMPLES, SOURCES, KusabiCase, main  # noqa: E402: beside the folder of this file

FEW = ("--pattern-limit", 2)
# Arguments of `patterns`, `rays` and `critical` for each example; None: not applicable.
WEDGED = {
    "two-bars.toml": (("--mu", 2), ("--mu", 2, "--whole"), ()),
    "plane-truss.toml": (("--mu", 0.8), ("--mu", 0.6, "--whole"), ("--method", "newton", "--mu-max", 0.6)),
    "space-truss.toml": (("--mu", 0.65, "--method", "polyhedral"), None, ("--node-limit", 3)),
    "elastic-body.toml": (("--mu", 1), ("--mu", 0.9, "--method", "tree", "--node-limit", 5), ("--node-limit", 3)),
    "doorstop.toml": (("--mu", 0.3, *FEW), ("--mu", 0.3, "--method", "tree", "--node-limit", 5), ("--node-limit", 3)),
    "wedge-in-groove.toml": (("--mu", 0.9), ("--mu", 0.27), ("--node-limit", 3)),
    "snap-hook.toml": (("--mu", 0.9, *FEW), ("--mu", 0.9, "--method", "tree", "--node-limit", 5), ("--node-limit", 3)),
    "morse-taper.toml": (("--mu", 0.3, "--node-limit", 2), None, ("--node-limit", 1)),
    "brick-by-calculix.toml": (("--mu", 0.9, *FEW), None, ("--node-limit", 3)),
    "peg-in-hole.toml": (("--mu", 0.9, "--node-limit", 4), ("--mu", 0.9, "--method", "tree", "--node-limit", 5),
                         ("--node-limit", 2)),
    "paper/elastic-body.toml": (("--mu", 1, *FEW), ("--mu", 0.3), ("--node-limit", 3)),
    "paper/space-truss-fit.toml": (("--mu", 0.65, *FEW), None, ("--method", "global", "--node-limit", 3)),
}
# Arguments of `hold`.
HOLD = {
    "ladder.toml": ((), ("--mu", 0.4), ("--mu", 0.6), ("--mu", 1.4), ("--node-limit", 1), ("--mu", 0.4, "--grip"),
                    ("--mu", 0.3, "--grip"), ("--mu", 1.4, "--grip"), ("--mu", 0.4, "--total", 2),
                    ("--mu", "0.3,0.4,1.4", "--grip")),
    "press-fit.toml": (("--mu", 0.2, "--grip"),),
    "peg-under-two-loads.toml": (("--mu", 0.5, "--diagram"), ("--mu", 0.8, "--diagram")),
    "peg-under-load.toml": ((), ("--mu", 0.5), ("--mu", 0.5, "--node-limit", 3)),
    "statics/arch-of-six-voussoirs.toml": ((), ("--mu", 0.8)),
    "statics/block-on-an-incline.toml": ((), ("--mu", 0.5)),
    "statics/block-pulled-from-under-another.toml": (("--mu", 0.4),),
    "statics/block-pushed-low-or-high.toml": (("--mu", 0.4, "--case", "high"), ("--mu", 0.4, "--diagram")),
    "statics/bracket-on-a-pole.toml": ((), ("--mu", 0.5)),
    "statics/brake-with-a-lever.toml": (("--case", "clockwise"), ("--mu", 0.5, "--case", "anticlockwise")),
    "statics/climber-on-a-ladder.toml": ((), ("--mu", 0.5)),
    "statics/drawer.toml": ((), ("--mu", 0.55)),
    "statics/gripper.toml": (("--mu", 0.5, "--total", 25),),
    "statics/lifting-tongs.toml": ((), ("--mu", 0.45)),
    "statics/pier-under-thrust.toml": (("--mu", "0.4,0.5,0.6"),),
    "statics/tall-block-on-an-incline.toml": ((), ("--mu", 1)),
    "statics/three-logs.toml": ((), ("--mu", 0.27)),
    "statics/wedge-under-a-load.toml": ((), ("--mu", 0.25)),
}
LIMIT = {
    "gust.toml": ((), ("--alpha", 0.5, "--curve", "--samples", 10, "--cuts", "all", "--curve-to", 3)),
    "truss-bridge.toml": ((), ("--alpha", 1), ("--lose", 1, "--at-least", 0.5, "--keep", "d0")),
    "steel-mast.toml": ((), ("--case", "wind")),
    "roof-truss.toml": ((),),
    "static-gap.toml": ((), ("--alpha", 0.1)),
    "paper/limit-3x3.toml": ((), ("--alpha", 40, "--cuts", "none", "--big-m", 5, "--node-limit", 5)),
    "paper/limit-4x4.toml": ((),),
}
# Arguments of `sweep`: friction, then the uncertainty of loads.
SWEPT = (("two-bars.toml", ("--mu", "1,2,3")), ("plane-truss.toml", ("--mu", "0.5:0.8:0.1")),
         ("space-truss.toml", ("--mu-max", 0.65, "--node-limit", 3)), ("wedge-in-groove.toml", ("--mu-max", 0.9)),
         ("elastic-body.toml", ("--mu-max", 1.5)), ("gust.toml", ("--alpha", "0:0.6:0.2")),
         ("static-gap.toml", ("--alpha", "0.1")), ("paper/limit-3x3.toml", ("--alpha", "10,20", "--node-limit", 1)),
         ("../tests/cases/plane_truss_and_post.toml", ("--mu", "0.5")),
         ("../tests/cases/lambda_zero_not_carried.toml", ("--alpha", "1")))
PROGRAMS = (("assignment.mps", ()), ("knapsack.lp", ("--cuts", "disjunctive")), ("odd-cycle.lp", ()),
            ("generalised-assignment.mps", ("--node-limit", 2)), ("parity.lp", ("--branching", "look-ahead")))
# Optional keys by docs/result-files.md: empty parts, and parts not requested.
OPTIONAL = {
    "structure": {"inclined_supports", "springs", "ties", "elements", "outlines", "axial_stiffnesses", "fixed", "against",
                  "dead_loads", "materials"},
    "materials": {"thickness", "plane"},
    "fixed": {"x", "y", "z"},
    "problem": {"rigid_motions"},
    "contact": {"t2"},
}
OPTIONAL_OF = {
    "patterns": {"result": {"candidates", "example"}, "patterns": {"block", "inactive", "axial_forces"},
                 "candidates": {"block", "inactive", "margin"}},
    "rays": {"result": {"tree", "motions", "proved_cones"}, "cones": {"motions"}, "rays": {"axial_forces"}},
    "critical": {"patterns": {"block", "inactive", "axial_forces"},
                 # depending on the method
                 "statistics": {"ranks"}},
    "limit": {"member_loss": {"forces", "critical_parameters"}, "struts": {"minimum", "maximum", "factor", "fatal", "lost", "member_loss"}, "uncertain_loads": {"half_width"}, "cases": {"minimum", "maximum", "factor", "fatal"}, "statistics": {"nodes", "corners", "tree_programs", "zero_one", "member_loss"},
              "result": {"kept", "reference_action", "reference_factor", "nominal_bounds", "minimum_parameters", "member_loss", "struts", "zero_one", "case", "cases", "samples", "curve_end", "worst_curve_end", "load_curve_end"}},
    "sweep": {"result": {"curve_end"}, "patterns": {"block", "inactive"}, "open": {"block", "inactive"}},
    "mip": {"result": {"columns"}},
    "hold": {"structure": {"reference_loads"}, "result": {"excluding_motions"}},
}
# objects with counts of a search
COUNTING = {"ranks", "earlier_runs", "tree", "histories"}
# keys are names of options, or of the problem
NAMED = {"options", "support_reactions", "nominal_support_reactions", "columns", "reactions"}


def places(value, way=(), name=""):
    """Paths to all keys of an object, with the name of the object of each; first entries of lists only."""
    if isinstance(value, dict):
        for key, inner in value.items():
            if name not in NAMED:
                yield (*way, key), name
            yield from places(inner, (*way, key), key)
    elif isinstance(value, list):
        for at, inner in enumerate(value[:1]):
            yield from places(inner, (*way, at), name)


def short(value, name=""):
    """The same with three entries of each long list, and of each object whose keys are names."""
    if isinstance(value, dict):
        few = list(value.items())[:3 if name in NAMED else None]
        return {key: short(inner, key) for key, inner in few}
    if isinstance(value, list):
        return [short(inner) for inner in (value[:3] if len(value) > 20 else value)]
    return value


class Schema(KusabiCase):
    @classmethod
    def setUpClass(cls):
        schema = json.loads((SOURCES / "docs" / "result.schema.json").read_text())
        Draft202012Validator.check_schema(schema)
        cls.schema = Draft202012Validator(schema)

    def check(self, command, name, words):
        with self.subTest(command=command, name=name, words=words):
            result = self.solve(command, name, *words)
            for error in self.schema.iter_errors(result):
                self.fail(f"{list(error.absolute_path)}: {error.message[:200]}")
            manual = self.kusabi("help", command).stdout
            for option in result["options"]:
                self.assertIn(f"  --{option.replace('_', '-')} ", manual.replace("\n", " "))
            return result

    def check_wedged(self, command, which):
        for name, words in WEDGED.items():
            if words[which] is None:
                self.assertEqual(command, "rays")
                self.assertIn("expected 2", self.refused(command, EXAMPLES / name, "--mu", 1))
            else:
                self.check(command, name, words[which])

    def test_every_example_has_a_call(self):
        found = {str(path.relative_to(EXAMPLES)) for path in EXAMPLES.rglob("*.toml")}
        self.assertEqual(found, WEDGED.keys() | HOLD.keys() | LIMIT.keys())

    def test_accepts_results_of_patterns(self):
        self.check_wedged("patterns", 0)
        result = self.check("patterns", "../tests/cases/plane_truss_and_post.toml", ("--mu", 0.5))
        self.assertTrue(result["result"]["patterns"][0]["inactive"])
        result = self.check("patterns", "plane-truss.toml", ("--mu", 0.8, "--probe", 2))
        self.assertEqual(result["options"]["probe"], 2)
        self.assertGreater(result["result"]["tree"]["probed"], 0)

    def test_accepts_results_with_defaults_from_a_file(self):
        config = self.folder / "config.toml"
        config.write_text('[patterns]\nsort = "margin"\ngroup = 2\n[rays]\nmethod = "tree"\n')
        for command, words, options in (("patterns", ("--mu", 2), {"sort": "margin", "group": "2"}),
                                        ("patterns", ("--mu", 2, "--group", 1), {"sort": "margin"}),
                                        ("rays", ("--mu", 2), {"method": "tree"})):
            result = self.check(command, "two-bars.toml", (*words, "--config", config))
            self.assertEqual(result["config"], {"file": str(config), "options": options})
        result["config"]["options"] = {}
        self.assertFalse(self.schema.is_valid(result))

    def test_accepts_results_of_rays(self):
        self.check_wedged("rays", 1)
        lines = self.folder / "rays.jsonl"
        run = self.kusabi("rays", EXAMPLES / "plane-truss.toml", "--mu", 0.8, "--format", "jsonl", "--output", lines)
        self.assertEqual(run.returncode, 0, run.stderr)
        line_schema = Draft202012Validator({"$ref": "#/$defs/ray_line", "$defs": self.schema.schema["$defs"]})
        rays = [json.loads(line) for line in lines.read_text().splitlines()[1:-1]]
        self.assertEqual(len(rays), 46)  # tests/reference/plane-truss.json
        for ray in rays:
            self.assertEqual(list(line_schema.iter_errors(ray)), [])
            for key in ray:
                self.assertFalse(line_schema.is_valid({name: value for name, value in ray.items() if name != key}))

    def test_accepts_results_of_critical(self):
        self.check_wedged("critical", 2)

    def test_accepts_results_of_hold(self):
        for name, calls in HOLD.items():
            for words in calls:
                self.check("hold", name, words)
        self.check_is_documented(self.solve("hold", "ladder.toml"))
        self.check_is_documented(self.solve("hold", "peg-under-load.toml", "--mu", 0.5))
        self.check_is_documented(self.solve("hold", "ladder.toml", "--mu", "0.3,0.4"))

    def test_accepts_results_of_limit(self):
        for name, calls in LIMIT.items():
            for words in calls:
                self.check("limit", name, words)
        self.check("limit", "../tests/cases/lambda_zero_not_carried.toml", ("--alpha", 1))

    def test_accepts_results_of_sweep(self):
        for name, words in SWEPT:
            self.check("sweep", name, words)

    def test_accepts_results_of_mip(self):
        for name, words in PROGRAMS:
            self.check("mip", f"../tests/programs/{name}", words)

    def check_is_documented(self, result):
        """Each key in turn is removed, renamed, and given a value of another type."""
        result = short(result)
        self.assertTrue(self.schema.is_valid(result))
        own = OPTIONAL_OF[result["command"]]
        # optional, since searches count different things
        counts = set(self.schema.schema["$defs"]["counts"]["properties"])
        for way, owner in list(places(result)):
            inner = result
            for key in way[:-1]:
                inner = inner[key]
            key, value = way[-1], inner[way[-1]]
            del inner[key]
            optional = OPTIONAL.get(owner, set()) | own.get(owner, set()) | (counts if owner in COUNTING else set())
            with self.subTest(missing=way):
                self.assertEqual(self.schema.is_valid(result), key in optional)
            inner[key + "_"] = value
            with self.subTest(renamed=way):
                self.assertFalse(self.schema.is_valid(result))
            del inner[key + "_"]
            other = {} if value is None or isinstance(value, list) else "0" if not isinstance(value, str) else 0
            if way != ("statistics",):
                inner[key] = other
                with self.subTest(retyped=way):
                    self.assertFalse(self.schema.is_valid(result))
            inner[key] = value

    def test_refuses_wrong_results_of_patterns_and_rays(self):
        self.check_is_documented(self.solve("patterns", "space-truss.toml", "--mu", 0.65, "--method", "polyhedral",
                                         "--pattern-limit", 2))
        self.check_is_documented(self.solve("rays", "two-bars.toml", "--mu", 2, "--whole"))
        self.check_is_documented(self.solve("rays", "wedge-in-groove.toml", "--mu", 0.27))

    def test_refuses_wrong_results_of_other_subcommands(self):
        self.check_is_documented(self.solve("critical", "two-bars.toml"))
        self.check_is_documented(self.solve("critical", "elastic-body.toml", "--method", "global"))
        self.check_is_documented(self.solve("limit", "gust.toml", *LIMIT["gust.toml"][1]))
        self.check_is_documented(self.solve("sweep", "two-bars.toml", "--mu", "1,3"))
        self.check_is_documented(self.solve("sweep", "gust.toml", "--alpha", "0,0.3"))
        self.check_is_documented(self.solve("mip", "../tests/programs/knapsack.lp"))


if __name__ == "__main__":
    main()
