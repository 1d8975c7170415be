#!/usr/bin/env python3
"""The JSON schema of a scenario, made from what the readers themselves say, and tested against them.

    scenario_schema.py write <scenario_verdicts>    makes docs/scenario.schema.json anew
    scenario_schema.py check <scenario_verdicts>    is it what the readers say, and do both judge alike?

Types, ranges, lists of names and the keys of each kind come from the readers: each key is given an empty section, and
the message says what was expected. Descriptions come from keys.yaml beside this file; a key without one is an error.
"""
import json
import sys

try:
    import jsonschema
    import yaml  # noqa: F401, so that its absence is noticed here
except ImportError as missing:
    print(f"{missing}: skipped (Debian packages python3-jsonschema and python3-yaml)")
    sys.exit(77)

sys.dont_write_bytecode = True  # a test leaves no files behind
from agreement import Agreement  # noqa: E402
from maker import Maker, leaves  # noqa: E402
from probes import PROBES  # noqa: E402
from readers import ROOT, Readers  # noqa: E402

SCHEMA = ROOT / "docs" / "scenario.schema.json"


def check(readers):
    maker = Maker(readers)
    schema = maker.make()
    shipped = json.loads(SCHEMA.read_text())
    if schema != shipped:
        raise SystemExit("docs/scenario.schema.json is not what the readers say: ./dev schema makes it anew")
    jsonschema.Draft202012Validator.check_schema(schema)
    probes = [(probe, readers.resolved(probe)) for probe in PROBES]
    asked = Agreement(schema, readers)
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
