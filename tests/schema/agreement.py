"""Asks schema and readers the same questions: do they judge alike?"""
import copy

import jsonschema
import yaml

from maker import at, leaves
from probes import CHOOSERS, DRIVE, PROBES, REQUIRED, REQUIRED_OF, SQUARE
from readers import ROOT, load


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


class Agreement:
    """Questions, and what both are wanted to say."""

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
        for file in sorted([*(ROOT / "scenarios").glob("*.yaml"), *(ROOT / "scenarios" / "faults").glob("*.yaml")]):
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
                steps = tuple(path.split(".")) + ((0,) if path in ("drive.waypoints", "faults") else ())
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
