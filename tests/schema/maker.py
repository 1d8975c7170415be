"""Makes the schema from what the readers say."""
import copy

import yaml

from probes import CHOOSERS, PROBES, REQUIRED, REQUIRED_OF, SHAPES
from readers import HERE, load, type_of


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
