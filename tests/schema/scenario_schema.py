#!/usr/bin/env python3
"""The JSON schema of a scenario, made from what the readers themselves say, and tested against them.

    scenario_schema.py write <scenario_verdicts>    makes docs/scenario.schema.json anew
    scenario_schema.py check <scenario_verdicts>    is it what the readers say, and do both judge alike?

Types, ranges, lists of names and the keys of each kind come from the readers: each key is given an empty section, and
the message says what was expected. Descriptions come from keys.yaml beside this file; a key without one is an error.
"""
import copy
import json
import pathlib
import re
import subprocess
import sys

try:
    import jsonschema
    import yaml
except ImportError as missing:
    print(f"{missing}: skipped (Debian packages python3-jsonschema and python3-yaml)")
    sys.exit(77)

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
SCHEMA = ROOT / "docs" / "scenario.schema.json"
DRIVE = {"waypoints": [{"x_m": 1, "y_m": 0}]}
SQUARE = [[-2, -2], [2, -2], [2, 2], [-2, 2]]

# Scenarios that together hold every key. Below a list, the first entry counts for all.
PROBES = [
    {"world": {"kind": kind}, "drive": DRIVE} for kind in ("simple", "cornered", "cluttered", "hallway")
] + [
    {"world": {"kind": "polygons", "walls": [{"corners_m": SQUARE}],
               "obstacles": [{"box": {"x_m": 1.5, "y_m": 1.5, "heading_deg": 0, "width_m": 0.2, "length_m": 0.2}}],
               "slip_patches": [{"x_m": 0}]}, "drive": DRIVE, "variants": [{"name": "og"}]},
    {"world": {"kind": "polygons", "walls": [{"corners_m": SQUARE}],
               "obstacles": [{"corners_m": [[1, 1], [1.5, 1], [1.2, 1.6]]}]}, "drive": DRIVE},
    {"world": {"kind": "map", "map": "maps/flat.yaml", "start": {"x_m": 1.2, "y_m": 4.3}}, "drive": DRIVE},
    {"drive": {"kind": "script", "script": [{"duration_s": 1}]}},
    {"drive": DRIVE, "sensors": {"compass": {"bias_deg": 1}, "camera": {"blackouts_s": [[1, 2]]}}},
] + [
    {"drive": {"waypoints": [dict(x_m=1, y_m=0, heading=heading, **more)]}}
    for heading, more in (("along", {}), ("keep", {}), ("face", {"heading_deg": 3}), ("turn", {"turn_rate_deg_s": 3}))
] + [
    {"drive": DRIVE, "slam": {"store": {"kind": "coefficients", "basis": "haar", "compressor": compressor,
                                        "recovery": recovery}}}
    for compressor, recovery in (("top_m", "fast_l2"), ("gaussian", "pinv"), ("gaussian", "nesta"),
                                 ("gaussian", "csekf"), ("gaussian", "csekf_p_printed"),
                                 ("gaussian", "csekf_p_gradient"), ("gaussian", "csekf_p_power"))
] + [
    {"drive": DRIVE, "slam": {"store": {"kind": "coefficients", "basis": "identity", "compressor": "selection",
                                        "recovery": "tv"}}}
]

# The key that says which others there are, and its value where it is absent.
CHOOSERS = {"world": ("kind", "simple"), "drive": ("kind", "waypoints"), "drive.waypoints": ("heading", None),
            "slam.store": ("recovery", "fast_l2")}

# What a message of the readers cannot say: keys that must be there, by kind where it matters, and shapes of lists.
REQUIRED = {"": ["drive"], "drive.waypoints": ["x_m", "y_m"], "drive.script": ["duration_s"],
            "world.walls": ["corners_m"]}
REQUIRED_OF = {("world", "polygons"): ["walls"], ("world", "map"): ["map"], ("drive", "waypoints"): ["waypoints"],
               ("drive", "script"): ["script"], ("drive.waypoints", "face"): ["heading_deg"],
               ("drive.waypoints", "turn"): ["turn_rate_deg_s"]}
NAME = {"pattern": r"^[A-Za-z0-9_-][A-Za-z0-9_.-]*$", "maxLength": 100}
SHAPES = {"name": NAME, "variants.name": NAME, "slam.cell_sizes_m": {"minItems": 1, "uniqueItems": True},
          "drive.waypoints": {"minItems": 1}, "drive.script": {"minItems": 1}, "world.walls": {"minItems": 1},
          "world.walls.corners_m": {"minItems": 3}, "world.obstacles.corners_m": {"minItems": 3}}


class Loader(yaml.SafeLoader):
    """Numbers as in YAML 1.2, which editors and our readers speak: 1e-6 is one."""


Loader.add_implicit_resolver("tag:yaml.org,2002:float",
                             re.compile(r"^[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?$"),
                             list("-+0123456789."))


def load(text):
    return yaml.load(text, Loader)


class Readers:
    """Asks the readers of the program."""

    def __init__(self, program):
        self.program = program
        self.process = subprocess.Popen([program], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        self.asked = 0

    @staticmethod
    def question(text, settings=()):
        name = str(ROOT / "scenarios" / "probe.yaml")
        return json.dumps({"name": name, "text": text, "set": list(settings)}) + "\n"

    def verdicts(self, texts):
        """Many at once."""
        self.asked += len(texts)
        said = subprocess.run([self.program], input="".join(map(self.question, texts)), capture_output=True, text=True,
                              check=True)
        return [json.loads(line) for line in said.stdout.splitlines()]

    def verdict(self, text, settings=()):
        self.asked += 1
        self.process.stdin.write(self.question(text, settings))
        self.process.stdin.flush()
        return json.loads(self.process.stdout.readline())

    def resolved(self, scenario):
        answer = self.verdict(yaml.safe_dump(scenario))
        if "error" in answer:
            raise SystemExit(f"a probe is no scenario: {answer['error']}\n{yaml.safe_dump(scenario)}")
        return load(answer["resolved"])

    def expected(self, scenario, path, value="{}"):
        """What the reader of a key expects there, in its own words; nothing where it takes any section."""
        error = self.verdict(yaml.safe_dump(scenario), [(path, value)]).get("error", "")
        found = re.search(r"expected (.*), found", error)
        return found.group(1) if found else None


def bounds(words):
    """The range in 'a number in [1, 2]', 'a number above 0', 'a number of at least 3'."""
    if found := re.search(r"in ([\[(])(\S+), (\S+)\]", words):
        low = "minimum" if found.group(1) == "[" else "exclusiveMinimum"
        return {low: json.loads(found.group(2)), "maximum": json.loads(found.group(3))}
    if found := re.search(r"above (\S+)", words):
        return {"exclusiveMinimum": json.loads(found.group(1))}
    if found := re.search(r"at least (\S+)", words):
        return {"minimum": json.loads(found.group(1))}
    if found := re.search(r"at most (\S+)", words):
        return {"maximum": json.loads(found.group(1))}
    return {}


def type_of(readers, scenario, path):
    """The schema of one value, from the message of its reader."""
    words = readers.expected(scenario, path)
    if words is None:
        raise SystemExit(f"{path}: the reader does not say what it expects")
    if words.startswith("one of "):
        return {"enum": words[len("one of "):].split(", ")}
    if words == "true or false":
        return {"type": "boolean"}
    if words in ("a text", "the name of a file"):
        return {"type": "string"}
    if words.startswith("a whole number"):
        limits = bounds(words)
        # Without a limit of its own it still has that of its type, which the message names only when it is passed.
        limits = limits or bounds(readers.expected(scenario, path, "-99999999999") or "")
        return {"type": "integer", **limits}
    if words.startswith("a number"):
        return {"type": "number", **bounds(words)}
    number = {"type": "number"}
    pair = {"type": "array", "items": number, "minItems": 2, "maxItems": 2}
    if words.startswith("two numbers"):
        number.update(bounds(readers.expected(scenario, path, "[{}, 0]") or ""))
        return pair
    if words.startswith("a list of numbers"):
        number.update(bounds(readers.expected(scenario, path, "[{}]") or ""))
        return {"type": "array", "items": number}
    if words.startswith("a list of points"):
        number.update(bounds(readers.expected(scenario, path, "[[{}, 0]]") or ""))
        return {"type": "array", "items": pair}
    raise SystemExit(f"{path}: the reader expects '{words}', which is no type known here")


class Maker:
    """Builds the schema from all probes."""

    def __init__(self, readers):
        self.readers = readers
        self.descriptions = load((HERE / "keys.yaml").read_text())
        self.described = set()
        self.keys_of = {}  # section -> value of its chooser -> keys seen with it

    def describe(self, path):
        if path not in self.descriptions:
            raise SystemExit(f"{path}: a key without a description; add one to tests/schema/keys.yaml")
        self.described.add(path)
        return {"description": self.descriptions[path]}

    def leaf(self, scenario, path, place, old):
        if old is not None:
            return old
        return {**self.describe(path), **type_of(self.readers, scenario, place), **SHAPES.get(path, {})}

    def section(self, scenario, resolved, path, place, schema):
        """Merges one section of a resolved scenario into its schema. `path` leaves out the indices of lists."""
        schema.setdefault("type", ["object", "null"])
        properties = schema.setdefault("properties", {})
        schema["additionalProperties"] = False
        chooser = CHOOSERS.get(path)
        if chooser and chooser[0] in resolved:
            seen = self.keys_of.setdefault(path, {}).setdefault(resolved[chooser[0]], set())
            seen.update(resolved)
        for key, value in resolved.items():
            below, at = f"{path}.{key}".lstrip("."), f"{place}.{key}".lstrip(".")
            if below == "variants.slam":
                properties[key] = self.describe(below)  # the readers of `slam`: made from its schema
            elif isinstance(value, dict):
                old = properties.setdefault(key, self.describe(below))
                self.section(scenario, value, below, at, old)
            elif isinstance(value, list) and all(isinstance(item, dict) for item in value):
                # An empty list may be one of sections or of numbers: its reader says which.
                words = self.readers.expected(scenario, at) if key not in properties else "a list of sections"
                if words != "a list of sections":
                    properties[key] = self.leaf(scenario, below, at, properties.get(key))
                    continue
                listed = {**self.describe(below), "type": ["array", "null"], **SHAPES.get(below, {})}
                old = properties.setdefault(key, listed)
                if value:
                    self.section(scenario, value[0], below, f"{at}.0", old.setdefault("items", {"type": "object"}))
            else:
                properties[key] = self.leaf(scenario, below, at, properties.get(key))

    def add_choices(self, schema, path, below_variants=False):
        """Keys that only some kinds have are refused for the others; some kinds need some keys."""
        chooser, usual = CHOOSERS[path]
        every = set(schema["properties"])
        rules = []
        for value, keys in sorted(self.keys_of[path].items()):
            then = {"properties": {key: False for key in sorted(every - keys)}}
            if (path, value) in REQUIRED_OF:
                then["required"] = REQUIRED_OF[path, value]
            when = {"properties": {chooser: {"const": value}}}
            # An absent key has its usual value; in a variant, that of the filter it starts from.
            if value != usual or below_variants:
                when["required"] = [chooser]
            rules.append({"if": when, "then": then})
        schema["allOf"] = [rule for rule in rules if rule["then"]["properties"] or "required" in rule["then"]]

    def make(self):
        schema = {}
        for probe in PROBES:
            self.section(probe, self.readers.resolved(probe), "", "", schema)
        schema["type"] = "object"
        for path, keys in REQUIRED.items():
            at(schema, path)["required"] = keys
        obstacle = at(schema, "world.obstacles")
        obstacle["oneOf"] = [{"required": ["box"]}, {"required": ["corners_m"]}]
        variant = at(schema, "variants")["properties"]
        for path in CHOOSERS:
            self.add_choices(at(schema, path), path)
        slam = copy.deepcopy(schema["properties"]["slam"])
        del slam["properties"]["cell_sizes_m"]
        self.add_choices(slam["properties"]["store"], "slam.store", below_variants=True)
        slam["description"] = variant["slam"]["description"]
        variant["slam"] = slam
        unused = set(self.descriptions) - self.described
        if unused:
            raise SystemExit(f"keys.yaml describes what no reader knows: {', '.join(sorted(unused))}")
        return {"$schema": "https://json-schema.org/draft/2020-12/schema", "title": "cogslam scenario",
                "description": "Every key may be left out unless it is named as required; `cogslam validate` fills in "
                               "the defaults. Units are part of the names.", **schema}


def at(schema, path):
    """The schema of a section, or of one entry of a list of sections."""
    for key in filter(None, path.split(".")):
        schema = schema["properties"][key]
        schema = schema.get("items", schema)
    return schema


def leaves(schema, path=()):
    """Every value in a schema: where it stands, and its own schema."""
    for key, value in schema.get("properties", {}).items():
        if "properties" in value:
            yield from leaves(value, path + (key,))
        elif "properties" in value.get("items", {}):
            yield from leaves(value["items"], path + (key, 0))
        else:
            yield path + (key,), value


def place_value(scenario, path, value):
    """A copy of a scenario with one value set; lists grow where they must."""
    scenario = copy.deepcopy(scenario)
    node = scenario
    for step, following in zip(path, path[1:]):
        empty = [{}] if following == 0 else {}
        if isinstance(node, list):
            node = node[step]
        else:
            if not node.get(step):
                node[step] = empty
            node = node[step]
    node[path[-1]] = value
    return scenario


def wrong_values(schema):
    """Values that a schema of one value must refuse."""
    yield {"no": "section"}
    if "enum" in schema:
        yield from ("no_such_name", 3)
        return
    kind = schema.get("type")
    if kind == "boolean":
        yield from ("maybe", 3)
    elif kind in ("number", "integer"):
        yield from ("many", "3", [1], True)
        if kind == "integer":
            yield 1.5
        if "minimum" in schema:
            yield schema["minimum"] - 1
        if "exclusiveMinimum" in schema:
            yield from (schema["exclusiveMinimum"], schema["exclusiveMinimum"] - 1)
        if "maximum" in schema:
            yield schema["maximum"] * 2 + 1
    elif kind == "array":
        yield from (3, ["a"], [[1, 2, 3]])
    elif kind == "string" and "pattern" in schema:
        yield from ("", ".x", "a/b", "x" * 101)


def probe_with(path, resolved_probes):
    """The probe that has the section in which a path lies."""
    for probe, resolved in resolved_probes:
        node = resolved
        try:
            for step in path:
                node = node[step]
        except (KeyError, IndexError, TypeError):
            continue
        return probe
    return None


class Check:
    """Asks schema and readers the same questions."""

    def __init__(self, schema, readers):
        self.validator = jsonschema.Draft202012Validator(schema)
        self.schema, self.readers = schema, readers
        self.asked = []

    def ask(self, scenario, wanted, what):
        self.asked.append((scenario if isinstance(scenario, str) else yaml.safe_dump(scenario), wanted, what))

    def failures(self):
        """Where schema, readers and what was wanted differ."""
        for (text, wanted, what), answer in zip(self.asked, self.readers.verdicts([text for text, _, _ in self.asked])):
            by_schema, by_readers = self.validator.is_valid(load(text)), "error" not in answer
            if (by_schema, by_readers) != (wanted, wanted):
                yield (f"{what}: schema {'accepts' if by_schema else 'refuses'}, readers "
                       f"{'accept' if by_readers else 'refuse'}, expected both to {'accept' if wanted else 'refuse'}"
                       f"{self.reason(text) if wanted else ''}")

    def count(self, wanted):
        return sum(1 for _, w, _ in self.asked if w == wanted)

    def reason(self, text):
        error = jsonschema.exceptions.best_match(self.validator.iter_errors(load(text)))
        return f" ({'.'.join(map(str, error.absolute_path))}: {error.message[:200]})" if error else ""

    def shipped(self):
        for file in sorted((ROOT / "scenarios").glob("*.yaml")):
            text = file.read_text()
            if "world:" not in text and "drive:" not in text:
                continue  # settings for replays, no scenario
            self.ask(text, True, file.name)
            self.ask(self.readers.verdict(text).get("resolved", "nothing: resolved"), True, f"{file.name}, resolved")

    def values(self, probes):
        for path, schema in leaves(self.schema):
            if path[:1] == ("variants",) and "slam" in path:
                continue  # the same readers as those of slam
            probe = probe_with(path, probes)
            for value in wrong_values(schema):
                self.ask(place_value(probe, path, value), False, f"{path} = {value!r}")

    def sections(self, probes):
        """An unknown key, and a section that is none, in every section."""
        for path in sorted({path[:i] for path, _ in leaves(self.schema) for i in range(len(path))}, key=str):
            if path and path[-1] == 0 or path[:1] == ("variants",) and "slam" in path:
                continue
            probe = probe_with(path, probes)
            section = path + (0,) if self.is_list(path) else path
            self.ask(place_value(probe, section + ("no_such_key",), 1), False, f"{section}: an unknown key")
            if path:
                self.ask(place_value(probe, path, 3), False, f"{path} = 3")

    def is_list(self, path):
        node = self.schema
        for step in path:
            node = node["items"] if step == 0 else node["properties"][step]
        return "items" in node

    def keys_of_kinds(self, maker, probes):
        """Keys of another kind, and kinds without the keys that they need."""
        for path, (chooser, usual) in CHOOSERS.items():
            every = set(at(self.schema, path)["properties"])
            for value, keys in maker.keys_of[path].items():
                steps = tuple(path.split(".")) + ((0,) if path == "drive.waypoints" else ())
                probe = next(p for p in PROBES if self.has(p, steps, chooser, value, usual))
                for key in sorted(every - keys):
                    there = place_value(probe, steps + (key,), self.fitting(probes, path, key))
                    self.ask(there, False, f"{path}.{key} of {value}")
                for key in REQUIRED_OF.get((path, value), []) + REQUIRED.get(path, []):
                    self.ask(self.without(probe, steps + (key,)), False, f"{path} of {value} without {key}")

    @staticmethod
    def has(probe, steps, chooser, value, usual):
        node = probe
        for step in steps:
            node = node[step] if isinstance(node, list) else node.get(step, {})
            if node == {}:
                return value == usual
        return node.get(chooser, usual) == value

    @staticmethod
    def fitting(probes, path, key):
        """A value that the key takes where it belongs."""
        for _, node in probes:
            for step in path.split("."):
                node = (node or {}).get(step, {})
                node = node[0] if isinstance(node, list) and node else node
            if isinstance(node, dict) and key in node:
                return node[key]
        return 1

    @staticmethod
    def without(probe, path):
        scenario = copy.deepcopy(probe)
        node = scenario
        for step in path[:-1]:
            node = node[step]
        node.pop(path[-1], None)
        return scenario

    def shapes(self):
        polygons = {"world": {"kind": "polygons", "walls": [{"corners_m": SQUARE}]}, "drive": DRIVE}
        for path, value in ((("world", "walls"), []), (("world", "walls", 0, "corners_m"), SQUARE[:2]),
                            (("drive", "waypoints"), []), (("slam", "cell_sizes_m"), []),
                            (("slam", "cell_sizes_m"), [0.1, 0.1]), (("world", "obstacles"), [{}]),
                            (("world", "obstacles"), [{"box": {}, "corners_m": SQUARE}])):
            self.ask(place_value(polygons, path, value), False, f"{path} = {value!r}")
        self.ask({"drive": {"kind": "script", "script": []}}, False, "an empty script")
        self.ask({"world": {"kind": "simple"}}, False, "nothing to drive")


def check(readers):
    maker = Maker(readers)
    schema = maker.make()
    shipped = json.loads(SCHEMA.read_text())
    if schema != shipped:
        raise SystemExit("docs/scenario.schema.json is not what the readers say: ./dev schema makes it anew")
    jsonschema.Draft202012Validator.check_schema(schema)
    probes = [(probe, readers.resolved(probe)) for probe in PROBES]
    asked = Check(schema, readers)
    asked.shipped()
    for probe, resolved in probes:
        asked.ask(probe, True, "a probe")
        asked.ask(resolved, True, "a probe, resolved")
    asked.values(probes)
    asked.sections(probes)
    asked.keys_of_kinds(maker, probes)
    asked.shapes()
    if failures := list(asked.failures()):
        raise SystemExit("\n".join(failures))
    print(f"{sum(1 for _ in leaves(schema))} values; {asked.count(True)} scenarios accepted and {asked.count(False)} "
          f"refused by both; {readers.asked} questions to the readers")


def main():
    if len(sys.argv) != 3 or sys.argv[1] not in ("write", "check"):
        raise SystemExit(__doc__)
    readers = Readers(sys.argv[2])
    if sys.argv[1] == "check":
        return check(readers)
    SCHEMA.write_text(json.dumps(Maker(readers).make(), indent=1) + "\n")


main()
