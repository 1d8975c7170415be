"""Asks the readers of the program what they expect, and tells it as JSON schema."""
import json
import pathlib
import re
import subprocess

import yaml

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent


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
