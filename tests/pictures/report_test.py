"""Tests of the page of kusabi report: well-formed, self-contained, labelled, and with the numbers of the result file.

    python3 report_test.py KUSABI SOURCES
"""
import html.parser
import json
import math
import pathlib
import re
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
from kusabi_case import EXAMPLES, KusabiCase, main, nested, with_ends, without  # noqa: E402: beside the folder of this file

VOID = {"meta", "input", "option", "link", "br", "img"}  # the end of an option may be left out
EVIL = '<a> & "b" \'c\' </script><script>alert(1)</script>'


class Element:
    def __init__(self, tag, attributes, parent):
        self.tag, self.attributes, self.parent = tag, dict(attributes), parent
        self.children, self.inside = [], []  # elements; elements and words

    def all(self, tag=None):
        for child in self.children:
            if tag in (None, child.tag):
                yield child
            yield from child.all(tag)

    def kinds(self):
        return (self.attributes.get("class") or "").split()

    def text(self):
        return "".join(each if isinstance(each, str) else each.text() for each in self.inside)

    def add(self, element):
        self.children.append(element)
        self.inside.append(element)
        return element


class Page(html.parser.HTMLParser):
    """A tree of elements; an element not closed in order is an error."""

    def __init__(self, text):
        super().__init__()
        self.root = self.inner = Element("", [], None)
        self.errors, self.named = [], {}
        self.feed(text)
        self.close()
        if self.inner is not self.root:
            self.errors.append(f"<{self.inner.tag}> is left open")

    def handle_starttag(self, tag, attrs):
        names = [name for name, _ in attrs]
        if len(set(names)) != len(names):
            self.errors.append(f"<{tag}> has an attribute twice")
        element = self.inner.add(Element(tag, attrs, self.inner))
        self.named.setdefault(element.attributes.get("id"), element)
        # The next option closes an option, or it has a text and an end tag.
        if tag not in VOID or (tag == "option" and self.inner.tag == "select"):
            self.inner = element

    def handle_startendtag(self, tag, attrs):
        self.inner.add(Element(tag, attrs, self.inner))

    def handle_endtag(self, tag):
        if tag != self.inner.tag:
            self.errors.append(f"{self.getpos()}: </{tag}> within <{self.inner.tag}>")
            return
        self.inner = self.inner.parent

    def handle_data(self, data):
        self.inner.inside.append(data)

    def with_id(self, name):
        return self.named[name]  # `check` shows that no two have one name

    def with_class(self, kind):
        return [element for element in self.root.all() if kind in element.kinds()]


class Report(KusabiCase):
    def page(self):
        place = self.folder / "page.html"
        run = self.kusabi("report", self.result, "--output", place)
        self.assertEqual(run.returncode, 0, run.stderr)
        text = place.read_text()
        page = Page(text)
        self.check(page, text)
        return page

    def check(self, page, text):
        """Expectations common to all pages."""
        self.assertEqual(page.errors, [])
        self.assertTrue(text.startswith("<!DOCTYPE html>"))
        everything = list(page.root.all())
        ids = [element.attributes["id"] for element in everything if "id" in element.attributes]
        self.assertEqual(len(ids), len(set(ids)))

        # The page loads nothing from elsewhere, and its policy forbids it.
        for element in everything:
            self.assertNotIn(element.tag, ("link", "img", "iframe", "object", "embed", "base"))
            for name, value in element.attributes.items():
                self.assertNotIn(name, ("src", "href", "xlink:href", "srcset", "action", "style"))
                self.assertFalse(name.startswith("on"), name)
        styles = "".join(element.text() for element in everything if element.tag == "style")
        self.assertNotRegex(styles, r"url\(|@import")
        self.assertEqual(len(list(page.root.all("script"))), 1)
        policy = next(each for each in everything if each.attributes.get("http-equiv") == "Content-Security-Policy")
        self.assertIn("default-src 'none'", policy.attributes["content"])

        # One style for all pictures, restricted to them.
        self.assertEqual(sum(element.tag == "style" for element in everything), 1)
        drawn = styles[styles.index("svg.picture text"):]
        for selectors in re.findall(r"^([^@}\n][^{]*)\{", drawn, re.MULTILINE):
            for selector in selectors.split(","):
                self.assertTrue(selector.strip().startswith("svg.picture "), selector)
        for query in ("prefers-color-scheme: dark", "@media print"):
            self.assertIn(query, styles)

        # Pictures and controls have names.
        for svg in page.root.all("svg"):
            self.assertEqual(svg.attributes["role"], "img")
            title, description = (page.with_id(name) for name in svg.attributes["aria-labelledby"].split())
            self.assertEqual((title.tag, description.tag), ("title", "desc"))
            self.assertTrue(title.text() and description.text())
            self.assertIn("picture", svg.kinds())
        labelled = {label.attributes["for"] for label in page.root.all("label")}
        for tag in ("input", "select"):
            for control in page.root.all(tag):
                self.assertIn(control.attributes["id"], labelled)
        for table in page.root.all("table"):
            self.assertEqual(table.children[0].tag, "caption")

    def numbers(self, element):
        return [json.loads(each.attributes["value"]) for each in element.all("data")]

    def verdict(self, page):
        return page.with_id("verdict").text()

    def details(self, page):
        return " ".join(each.text() for each in page.with_class("detail"))

    def test_shows_patterns(self):
        result = self.solve("patterns", "space-truss.toml", "--mu", 0.65)
        page = self.page()
        self.assertEqual(self.verdict(page),
                         f"It can stick in {result['result']['count']} ways at friction coefficient 0.65.")
        cards = sorted(page.with_class("answer"), key=lambda card: int(card.attributes["data-number"]))
        patterns = result["result"]["patterns"]
        self.assertEqual(len(cards), len(patterns))
        # Ranks are those of the margins; the first ten are printed.
        ranked = sorted(cards, key=lambda card: int(card.attributes["data-rank"]))
        margins = [float(card.attributes["data-order"]) for card in ranked]
        self.assertEqual(margins, sorted(margins, reverse=True))
        self.assertEqual([card for card in ranked if "large" in card.kinds()], ranked[:10])
        names = [each["node"] for each in result["problem"]["contact"]]
        for number, (card, pattern) in enumerate(zip(cards, patterns), 1):
            self.assertEqual(card.attributes["data-number"], str(number))
            self.assertEqual(json.loads(card.attributes["data-contact"]), pattern["contact"])
            self.assertEqual(float(card.attributes["data-order"]), pattern["margin"])
            self.assertEqual(int(card.attributes["data-size"]), len(pattern["contact"]))
            margin = next(each for each in card.all("dd") if "margin" in each.kinds())
            self.assertEqual(self.numbers(margin), [pattern["margin"]])
            # The displayed number is the same, with six digits.
            self.assertAlmostEqual(float(margin.text()) / pattern["margin"], 1, delta=1e-5)
            shown_terms = {term.text(): definition.text() for term, definition in zip(card.all("dt"), card.all("dd"))}
            self.assertEqual(self.named(shown_terms["in contact"], names), set(pattern["contact"]))
            self.assertEqual(self.named(shown_terms["separated"], names), set(pattern["separated"]))
            needed = max(math.hypot(*force[1:]) / force[0] for force in pattern["reaction"] if force[0] > 0)
            self.assertAlmostEqual(float(shown_terms["reactions need μ"]) / needed, 1, delta=1e-5)
            self.assertNotIn("remark", shown_terms)
            rows = {next(row.all("th")).text(): self.numbers(row) for row in next(card.all("tbody")).all("tr")}
            self.assertEqual(rows, {name: force for name, force in zip(names, pattern["reaction"]) if any(force)})
            self.assertEqual([each.attributes["id"] for each in card.all("svg")], [f"picture-{number}", f"legend-{number}"])
            picture = next(card.all("svg"))
            marks = [mark for mark in picture.all("circle") if "contact" in mark.kinds()]
            self.assertEqual(len(marks), len(pattern["contact"]))
        # Each may be chosen for the large view, whose data then have its states.
        self.assertIn("hidden", page.with_id("choice").attributes)
        self.assertEqual([each.attributes["value"] for each in page.with_id("chosen").all("option")],
                         [card.attributes["id"] for card in ranked])
        scene = json.loads(next(page.root.all("figure")).attributes["data-scene"])
        for card, pattern in zip(cards, patterns):
            view = next(each.attributes["data-view"] for each in card.all("div") if "data-view" in each.attributes)
            drawn = {**scene, **json.loads(view)}
            self.assertEqual({each["name"] for each in drawn["candidates"] if each["state"] == "in contact"},
                             set(pattern["contact"]))
            self.assertEqual(len(drawn["places"]), len(drawn["motions"]))
            self.assertNotIn("faces", json.loads(view))
        problem = page.with_id("problem").text()
        for known in (result["problem"]["units"]["force"], "space truss",
                      f"{len(result['problem']['structure']['fixed']['x'])} nodes along x"):
            self.assertIn(known, problem)
        origin = page.with_id("origin").text()
        for known in (result["problem"]["fingerprint"], result["version"], result["result"]["tree"]["fingerprint"], str(result["result"]["tree"]["opened"])):
            self.assertIn(known, origin)
        # Without a script the page is a list, and its controls are hidden.
        self.assertIn("hidden", page.with_id("controls").attributes)
        self.assertFalse(any("hidden" in card.attributes for card in cards))

    def named(self, text, names):
        """The candidates of a short text, by an own reading of its ranges."""
        if text == "none":
            return set()
        if text.startswith("all"):
            return set(names) - self.named(text.removeprefix("all but "), names) if " but " in text else set(names)
        found = set()
        for word in text.split():
            ends = re.fullmatch(r"(.*?)(\d+)…(\d+)(.*)", word)
            found |= {f"{ends[1]}{i}{ends[4]}" for i in range(int(ends[2]), int(ends[3]) + 1)} if ends else {word}
        self.assertLessEqual(found, set(names))
        return found

    def test_begins_with_the_answer_in_a_sentence(self):
        # A wedge of 15 degrees to either side needs tan 15 degrees, and its sides slip at once.
        self.solve("critical", "wedge-in-groove.toml")
        page = self.page()
        self.assertEqual(self.verdict(page), "It cannot stick below friction coefficient 0.26794; at 0.26795 it can.")
        self.assertEqual(self.details(page),
                         "One way is pattern 1, with contact at all 10 candidates; with less friction all of them slip at once. "
                         "The angle of friction there is about 15°.")
        self.assertEqual(len(page.with_class("gallery")), 0)  # one pattern is large, and no card
        self.assertIn("viewBox=\"0 0 720", (self.folder / "page.html").read_text())
        # Two bars under one obstacle: the reaction is along a bar.
        result = self.solve("patterns", "space-truss.toml", "--mu", 0.65)
        patterns = result["result"]["patterns"]
        leading = max(range(len(patterns)), key=lambda i: patterns[i]["margin"])
        self.assertIn(f"Pattern {leading + 1} has the largest margin, ", self.details(self.page()))

    def test_names_factors_and_open_brackets_as_such(self):
        # Two bars of which both have 0.15 of the friction: they stick from 2 / 0.15 = 13.333… on.
        bars = self.folder / "bars.toml"
        bars.write_text((EXAMPLES / "two-bars.toml").read_text() + "friction_factor = 0.15\n")
        self.solve("critical", bars)
        page = self.page()
        self.assertIn("at 13.334 times it can.", self.verdict(page))
        self.assertEqual(self.details(page), "One way is pattern 1, with contact at tip; with less friction tip slips.")
        self.solve("patterns", bars, "--mu", 20)
        self.assertIn("needs 13.334 times the friction given in the file; with less, tip slips", self.details(self.page()))
        # Two patterns of 27, and a bracket that is open below.
        self.solve("patterns", "space-truss.toml", "--mu", 0.65, "--node-limit", 60)
        self.assertIn("Of those known, pattern ", self.details(self.page()))
        self.solve("patterns", "space-truss.toml", "--mu", 0.65, "--exists")
        page = self.page()
        self.assertEqual(self.verdict(page), "Yes, it can stick at friction coefficient 0.65.")
        self.assertIn("One way is contact at ", self.details(page))

    def test_shows_states_under_load(self):
        # A ladder that leans against a smooth wall: foot and top, and the coefficient at which it slips.
        result = self.solve("hold", "ladder.toml")
        holding = result["result"]["holding_friction"]
        page = self.page()
        self.assertIn(f"at {math.ceil(1e5 * holding['upper']['value']) / 1e5} it can.", self.verdict(page))
        self.assertIn("One state has contact at both candidates; with less friction both slip at once. "
                      f"The angle of friction there is about {math.degrees(math.atan(holding['upper']['value'])):.4g}°.", self.details(page))
        self.assertEqual(next(page.root.all("figure")).children[0].tag, "svg")
        self.assertIn("history of loading", next(page.root.all("header")).text())
        dead = [line for line in page.root.all("line") if "dead" in line.kinds()]
        # Of the state and of the motion that excludes less friction; each legend has one.
        self.assertEqual(len(dead), 2 * len(result["problem"]["structure"]["dead_loads"]) + 2)
        result = self.solve("hold", "peg-under-load.toml", "--mu", 0.5)
        self.page()

    def test_has_no_internal_terms(self):
        for command, name, *words in (("patterns", "space-truss.toml", "--mu", 0.65), ("limit", "truss-bridge.toml", "--alpha", 1),
                                      ("critical", "wedge-in-groove.toml"), ("sweep", "plane-truss.toml", "--mu", "0.5:0.8:0.1"),
                                      ("rays", "plane-truss.toml", "--mu", 0.65)):
            with self.subTest(command):
                self.solve(command, name, *words)
                text = " ".join(element.text() for element in self.page().root.all("body")).lower()
                text = text[:text.index("details of the run")]
                for word in ("feasible", "entries", "dead load limit", "leaf", "null", "nan"):
                    self.assertNotRegex(text, rf"\b{word}\b")

    def test_shows_a_body_in_space_that_can_be_rotated(self):
        result = self.solve("critical", "morse-taper.toml")
        page = self.page()
        figure = next(page.root.all("figure"))
        scene = json.loads(figure.attributes["data-scene"])
        structure, pattern = result["problem"]["structure"], result["result"]["patterns"][0]
        self.assertEqual([each["name"] for each in scene["candidates"]], [each["node"] for each in result["problem"]["contact"]])
        places = [scene["places"][3 * i:3 * i + 3] for i in range(len(scene["places"]) // 3)]
        # One scale and one shift for all: distances between candidates.
        nodes = structure["candidates"]
        drawn = [math.dist(places[scene["candidates"][0]["node"]], places[each["node"]]) for each in scene["candidates"]]
        true = [math.dist(structure["positions"][nodes[0]], structure["positions"][node]) for node in nodes]
        for one, other in zip(drawn, true):
            self.assertAlmostEqual(one / max(drawn), other / max(true), delta=1e-3)
        for each, force in zip(scene["candidates"], pattern["reaction"]):
            self.assertAlmostEqual(each["use"], math.hypot(*force[1:]) / (pattern["upper"] * force[0]), delta=1e-3)
        # Faces look outwards: the volume that they enclose is that of the frustum, roughly.
        volume = 0
        for face in scene["faces"]:
            corners = [places[i] for i in face]
            for b, c in zip(corners[1:], corners[2:]):
                a = corners[0]
                volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6
        scale = max(drawn) / max(true)
        radii = [math.hypot(*structure["positions"][node][:2]) for node in nodes]
        heights = [structure["positions"][node][2] for node in nodes]
        a, b, h = min(radii), max(radii), max(heights) - min(heights)
        exact = math.pi * h * (a * a + a * b + b * b) / 3
        self.assertGreater(volume / scale ** 3, 0.8 * exact)
        self.assertLess(volume / scale ** 3, 1.2 * exact)

    def test_lists_more_than_sixty_patterns_in_rows(self):
        result = self.solve("patterns", "plane-truss.toml", "--mu", 0.8)
        patterns = result["result"]["patterns"]
        count = 302
        result["result"]["patterns"] = [patterns[i % len(patterns)] for i in range(count)]
        self.result.write_text(json.dumps(result))
        page = self.page()
        answers = page.with_class("answer")
        self.assertEqual({each.attributes["data-number"] for each in answers}, {str(i) for i in range(1, count + 1)})
        self.assertEqual([each.tag for each in answers], ["li"] * 60 + ["tr"] * (count - 60))
        self.assertIn(f"Pictures show 60 of {count} patterns", page.with_id("answers").text())
        for row in answers[60:]:
            self.assertIn(result["result"]["patterns"][int(row.attributes["data-number"]) - 1]["margin"], self.numbers(row))
        # On paper: ten pictures, and a hundred rows.
        self.assertEqual(len([each for each in answers if "large" in each.kinds()]), 10)
        printed = page.with_class("on-paper") + [each for each in answers[60:] if "late" not in each.kinds()]
        self.assertEqual(len(printed), 100)

    def test_shows_that_nothing_sticks(self):
        result = self.solve("rays", "two-bars.toml", "--mu", 0.5)
        self.assertEqual(result["result"]["count"], 0)
        page = self.page()
        self.assertEqual(self.verdict(page), "It cannot stick at friction coefficient 0.5.")
        self.assertEqual(page.with_class("answer"), [])

    def test_has_the_sentences_of_the_file_and_no_others(self):
        for command, name, *words in (("patterns", "plane-truss.toml", "--mu", 0.8), ("critical", "ladder.toml"),
                                      ("rays", "plane-truss.toml", "--mu", 0.65), ("limit", "gust.toml", "--alpha", 0.5),
                                      ("patterns", "space-truss.toml", "--mu", 0.65, "--node-limit", 40),
                                      ("hold", "ladder.toml", "--mu", 0.4, "--grip")):
            with self.subTest(command, words=words):
                result = self.solve(command, name, *words)
                verdict = result["verdict"]
                header = next(self.page().root.all("header"))
                said = [each.text() for each in header.all() if each.tag in ("p", "li")]
                self.assertEqual(said, [verdict["sentence"], *verdict["details"], *verdict["reservations"],
                                        *("Warning: " + each for each in result["warnings"])])

    def test_shows_rays(self):
        result = self.solve("rays", "plane-truss.toml", "--mu", 0.6)["result"]
        page = self.page()
        self.assertIn(f"{result['count']} extremal ray", self.verdict(page))
        names = [each["node"] for each in json.loads(self.result.read_text())["problem"]["contact"]]
        for card, ray in zip(page.with_class("answer"), result["rays"]):
            touching = [name for name, state in zip(names, ray["state"]) if state not in ("separates", "idle")]
            self.assertEqual(json.loads(card.attributes["data-contact"]), touching)

    def test_shows_a_critical_coefficient(self):
        ends = self.solve("critical", "plane-truss.toml")["result"]["critical_friction"]
        bracket = {end: ends[end]["value"] for end in ends}
        page = self.page()
        lower, upper = map(float, re.findall(r"\d+\.\d+", self.verdict(page)))
        # Rounded outwards to five digits, so that it is still an enclosure.
        self.assertLessEqual(lower, bracket["lower"])
        self.assertGreaterEqual(upper, bracket["upper"])
        self.assertLess(upper - lower, bracket["upper"] - bracket["lower"] + 2.1e-5)
        self.assertEqual(self.numbers(page.with_id("bracket")), [bracket["lower"], bracket["upper"]])
        self.assertEqual(page.with_id("bracket").text().count("proved"), 2)
        # Both bounds are distinguished on the page, too.
        shown = [each.text() for each in page.with_id("bracket").all("data")]
        self.assertEqual(len(set(shown)), 2)
        self.assertEqual(len(page.with_class("answer")), 1)

    def test_marks_a_bound_that_is_not_proved(self):
        result = self.solve("critical", "plane-truss.toml")
        bracket = result["result"]["critical_friction"]
        bracket["lower"].update(standing="computed")
        bracket.update(upper=None)
        result["result"]["patterns"] = []
        self.result.write_text(json.dumps(result))
        text = self.page().with_id("bracket").text()
        self.assertIn("cannot stick at (computed)", text)
        self.assertNotIn("proved", text)

    def test_shows_loads_held_at_several_coefficients(self):
        points = self.solve("hold", "peg-under-load.toml", "--mu", "0.3,0.4,1.4")["result"]["points"]
        rows = [[each for each in (point["friction"], interval["low"], interval["high"]) if each is not None]
                for point in points for interval in map(with_ends, point["intervals"])]
        page = self.page()
        self.assertEqual(page.with_id("held").tag, "svg")
        self.assertEqual(self.rows(page, "Factors of the reference load that can be held"), rows)
        self.assertEqual(page.with_id("loads").text().count("proved"), 5)
        # Nothing is drawn between the coefficients of the call.
        self.assertEqual([each for each in page.with_id("held").all("polygon") if "area" in each.kinds()], [])
        self.assertEqual(page.with_id("loads").text().count("no end"), 7)  # six cells and the legend

    def test_shows_a_state_within_its_interval(self):
        # At exactly one factor, 3/7 as a double: no end may be rounded, neither of the factor nor of its state.
        text = """name = "seesaw"
dimension = 2
units = { length = "m", force = "N" }
[nodes]
a = [0, 0]
b = [0.3, 0.1]
c = [-0.7, 0.1]
[[members]]
EA = 1
between = [["a", "b"], ["b", "c"], ["a", "c"]]
[[contact]]
nodes = ["a"]
normal = [0, 1]
[[loads]]
kind = "dead"
nodes = ["b"]
force = [0, -1]
[[loads]]
kind = "reference"
nodes = ["c"]
force = [0, -1]
"""
        place = self.folder / "seesaw.toml"
        place.write_text(text)
        (interval,) = map(with_ends, self.solve("hold", place, "--mu", 0.5)["result"]["intervals"])
        self.assertEqual(interval["low"], interval["high"])
        page = self.page()
        (answer,) = page.with_class("answer")
        shown = re.findall(r"(\S+)\s+\(computed\)", answer.text())
        self.assertEqual([float(each) for each in shown], [interval["low"]] * 2)
        self.assertEqual(float(re.search(r"at factor (\S+)", answer.text())[1]), interval["low"])
        # Held up to 3.499999997…: the state is not at 3.5, and what its reactions need is not beyond the friction.
        (interval,) = map(with_ends, self.solve("hold", "ladder.toml", "--mu", 0.5)["result"]["intervals"])
        page = self.page()
        (answer,) = page.with_class("answer")
        shown = re.search(r"at factor (\S+)", answer.text())[1]
        self.assertTrue(interval["low"] <= float(shown) <= interval["high"], shown)
        (needed,) = (each.text() for each in answer.all("dd") if "needed" in each.kinds())
        self.assertEqual(float(needed), 0.5)
        self.assertEqual(answer.text().count("(proved)"), 2)

    def test_rounds_the_friction_that_reactions_need_up(self):
        result = self.solve("patterns", "space-truss.toml", "--mu", 0.65)
        page = self.page()
        exact = [max(math.hypot(*force[1:]) / force[0] for force in pattern["reaction"] if force[0] > 0) for pattern in result["result"]["patterns"]]
        for answer in page.with_class("answer"):
            (needed,) = (float(each.text()) for each in answer.all("dd") if "needed" in each.kinds())
            number = int(answer.attributes["data-number"])
            self.assertTrue(exact[number - 1] <= needed <= exact[number - 1] + 1e-5, (number, needed))

    def test_shows_a_limit_load(self):
        result = self.solve("limit", "gust.toml", "--alpha", 0.5)
        answer, worst = result["result"], result["result"]["maximum"]
        page = self.page()
        factor = float(re.search(r" to (\S+) of the reference", self.verdict(page))[1])
        self.assertLessEqual(factor, worst["lower"]["value"])
        self.assertLess(worst["lower"]["value"] - factor, 1e-3)
        factors = self.numbers(page.with_id("factors"))
        for known in (answer["nominal_bounds"]["maximum"]["lower"]["value"], worst["lower"]["value"], worst["upper"]["value"], answer["alpha"]):
            self.assertIn(known, factors)
        for known in (*answer["utilisation"], *(each["elongation"] for each in answer["collapse_mode"]["yielding"])):
            self.assertIn(known, factors)
        for name in ("collapse-nominal", "collapse-worst"):
            self.assertEqual(page.with_id(name).tag, "svg")
        answer = self.solve("limit", "gust.toml")["result"]
        page = self.page()
        self.assertNotIn("reservations", page.named)
        largest = answer["maximum"]
        for bound, name, below in ((largest["lower"], "at least", True), (largest["upper"], "at most", False)):
            shown = self.fact(page, f"nominal load factor, {name} (proved)")
            self.assertEqual(shown <= bound["value"], below or shown == bound["value"])

    def cell(self, page, name):
        """The cell in the row of this name."""
        return next(each for each in page.root.all("tr") if each.children[0].text() == name).children[1]

    def fact(self, page, name):
        """The number shown in the row of this name."""
        return float(self.cell(page, name).text())

    def test_rounds_bounds_outwards_and_gives_each_its_standing(self):
        result = self.solve("sweep", "gust.toml", "--alpha", "0.5")
        result["result"]["points"][0]["maximum"] = {"lower": {"value": 0.99999999999, "standing": "computed"},
                                                    "upper": {"value": 1.00000000001, "standing": "proved"}}
        self.result.write_text(json.dumps(result))
        page = self.page()
        table = next(each for each in page.root.all("table") if "at the given points" in each.children[0].text())
        row = next(table.all("tbody")).children[0]
        self.assertEqual([each.text() for each in row.children[1:5]], ["0.9999999999", "computed", "1.000000001", "proved"])

    def test_shows_that_the_existence_of_a_carried_factor_is_undecided(self):
        self.solve("limit", "../tests/cases/uplift.toml", "--alpha", 2)
        text = self.page().with_id("factors").text()
        self.assertIn("undecided whether there are any", text)
        self.assertIn("factors at which every admissible load is carried, at least (proved)", text)

    def rows(self, page, caption):
        """Numbers of the table with this caption, row by row."""
        table = next(each for each in page.root.all("table") if each.children[0].text() == caption)
        return [self.numbers(row) for row in next(table.all("tbody")).all("tr")]

    def test_shows_a_sweep_of_friction(self):
        answer = self.solve("sweep", "plane-truss.toml", "--mu", "0.5:0.8:0.1")["result"]
        page = self.page()
        self.assertEqual(self.verdict(page), "It cannot stick up to friction coefficient 0.48755536; at 0.8 there are 11 sign "
                                             "patterns (computed, not proved).")
        self.assertEqual(page.with_id("curve").tag, "svg")
        counted = lambda each: [each[key] for key in ("count", "known", "open")]
        self.assertEqual(self.rows(page, "Sign patterns at the given points"),
                         [[each["mu"], *counted(each)] for each in answer["points"]])
        self.assertEqual(self.rows(page, "Intervals with a constant number of sign patterns"),
                         [[each["from"], each["to"], *counted(each)] for each in answer["staircase"]])
        self.assertEqual(self.rows(page, "Friction coefficients at which patterns begin to stick"),
                         [[each["lower"], each["upper"]] for each in answer["patterns"]])
        self.assertNotIn("reservations", page.named)

    def test_marks_an_undecided_point_of_a_sweep(self):
        self.solve("sweep", "two-bars.toml", "--mu", "1,2,3")  # 2 is critical
        self.assertIn("at 1 of the requested points", self.page().with_id("reservations").text())
        self.solve("sweep", "space-truss.toml", "--mu", 0.8, "--node-limit", 3)
        page = self.page()
        self.assertIn("node-limit", page.with_id("reservations").text())
        self.assertIn("not known", self.verdict(page))
        self.assertNotIn("curve", page.named)

    def test_shows_a_sweep_of_loads(self):
        answer = self.solve("sweep", "gust.toml", "--alpha", "0:0.6:0.2")["result"]
        page = self.page()
        self.assertIn("for alpha = 0.6 the worst case is between 6.9813203 and 6.9813204, proved",
                      self.verdict(page))
        self.assertEqual(page.with_id("curve").tag, "svg")
        self.assertEqual(self.rows(page, "Worst-case load factor at the given points"),
                         [[each["alpha"], *(each["maximum"][end]["value"] for end in ("lower", "upper"))] for each in answer["points"]])
        self.assertEqual(self.rows(page, "Linear pieces of the curve"), self.pieces(answer["curve"]))
        self.check_pieces(page, "Linear pieces of the curve", ["proved"] * len(answer["curve"]))

    def pieces(self, curve):
        """The numbers of a curve in a result, piece by piece."""
        keys = ("from", "to", "factor_from", "factor_to", "error")
        return [[each[key] for key in keys if each[key] is not None] for each in curve]

    def check_pieces(self, page, caption, standings):
        """A proved distance is one from the numbers of the file, so that each is shown with all digits."""
        table = next(each for each in page.root.all("table") if each.children[0].text() == caption)
        rows = list(next(table.all("tbody")).all("tr"))
        self.assertEqual([list(row.all("td"))[5].text() for row in rows], standings)
        for row in rows:
            for number in list(row.all("data"))[:4]:
                self.assertEqual(float(number.text()), float(number.attributes["value"]))

    def test_shows_the_curves_of_a_limit_load(self):
        answer = self.solve("limit", "gust.toml", "--alpha", 0.5, "--curve")["result"]
        page = self.page()
        tables = [each for each in page.root.all("table") if each.children[0].text() == "Linear pieces of the curve"]
        found = [[self.numbers(row) for row in next(table.all("tbody")).all("tr")] for table in tables]
        self.assertEqual(found, [self.pieces(answer["curve"]), self.pieces(answer["worst_curve"])])
        self.check_pieces(page, "Linear pieces of the curve", ["computed"] * len(answer["curve"]))
        for name in ("curve", "worst_curve"):
            self.assertEqual(page.with_id(name).tag, "svg")

    def test_shows_the_factors_after_the_loss_of_members(self):
        factor = self.solve("limit", "truss-bridge.toml", "--lose", 1)["result"]["factor"]
        page = self.page()
        name = "load factor after the worst loss, at "
        self.assertEqual(self.numbers(self.cell(page, name + "least (proved)")), [factor["lower"]["value"]])
        self.assertEqual(self.numbers(self.cell(page, name + "most (proved)")), [factor["upper"]["value"]])
        factor = self.solve("limit", "truss-bridge.toml", "--lose", 2, "--node-limit", 1)["result"]["factor"]
        page = self.page()
        self.assertIsNone(factor["lower"])
        self.assertIn("not known", self.cell(page, name + "least").text())
        self.assertEqual(self.numbers(self.cell(page, name + "most (proved)")), [factor["upper"]["value"]])

    def test_says_what_is_known_after_an_early_end(self):
        result = self.solve("limit", "gust.toml")
        for key in [key for key in result["result"] if key.startswith("nominal")]:
            del result["result"][key]
        result["result"].update({"nominal": None, "maximum": {"lower": None, "upper": None}})
        self.result.write_text(json.dumps(result))
        self.assertIn("not found", self.cell(self.page(), "nominal load factor").text())
        self.solve("limit", "gust.toml", "--alpha", 0.5, "--time-limit", 1e-9)
        self.assertIn("undecided", self.cell(self.page(), "factors at which every admissible load is carried").text())
        self.solve("critical", "space-truss.toml", "--node-limit", 1)
        self.assertIn("from 0 to 1000", self.cell(self.page(), "undecided whether it can stick").text())
        self.solve("sweep", "space-truss.toml", "--mu", 0.8, "--node-limit", 3)
        self.assertIn("No count of sign patterns is known", self.page().with_id("sweep").text())
        result = self.solve("sweep", "gust.toml", "--alpha", "0.5")
        result["result"].update({"points": [], "curve": []})
        self.result.write_text(json.dumps(result))
        self.assertIn("No point was computed", self.page().with_id("sweep").text())

    def test_names_the_load_that_is_carried_at_no_factor(self):
        self.solve("limit", "gust.toml", "--alpha", 2)
        self.assertIn("at no factor, proved", self.cell(self.page(), "some admissible load is carried").text())
        self.solve("sweep", "gust.toml", "--alpha", "2,3")
        self.assertIn("some admissible load is carried at no factor", self.page().with_id("sweep").text())

    def test_escapes_names(self):
        self.solve("patterns", "plane-truss.toml", "--mu", 0.8)
        text = self.result.read_text().replace('"r1"', json.dumps(EVIL)).replace('"plane truss, 5 rows"', json.dumps(EVIL))
        text = text.replace('"kN"', json.dumps(EVIL))
        self.result.write_text(text)
        page = self.page()
        self.assertEqual(next(page.root.all("h1")).text(), EVIL)
        self.assertIn(EVIL, [each.attributes["value"] for each in page.root.all("option")])
        card = next(each for each in page.with_class("answer") if EVIL in json.loads(each.attributes["data-contact"]))
        self.assertIn(EVIL, [each.text() for each in card.all("th")])

    def test_refuses_a_file_that_is_no_result_in_one_line(self):
        result = self.solve("patterns", "plane-truss.toml", "--mu", 0.8)
        text = json.dumps(result)
        self.result.write_text(text)
        page = self.folder / "page.html"
        self.check_refusals("report", (
            ("{", "is not a JSON object"), (nested(32), "'problem' is missing"),
            (nested(33), "is nested deeper than 32;"),
            (without(result, "status"), "'status' is missing"),
            (without(result, "verdict"), "'verdict' is missing"),
            (without(result, "verdict", "sentence"), "'sentence' is missing"),
            (without(result, "version"), "'version' is missing"),
            (without(result, "problem", "structure"), "'structure' is missing"),
            (text.replace('"command": "patterns"', '"command": "mip"'), "is a result of kusabi mip"),
            (text.replace('"margin": ', '"margin": true, "old": '), "'margin' is not a number")), "--output", page)
        self.assertFalse(page.exists())
        self.refused("report", self.folder / "nowhere.json")


if __name__ == "__main__":
    main()
