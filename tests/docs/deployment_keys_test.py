"""Compares the tables of docs/howto/deployment.md with the schemas that deployment files and policies are checked against.

deployment_keys_test.py ROOT
A row is a key, or several with one meaning; the heading above a table says where they stand. The column "without it" has the schema's
default, and the last one an example that the schema takes.
"""

import json
import pathlib
import re
import sys
import unittest

ROOT = pathlib.Path(sys.argv.pop(1)).resolve()
HEADING = re.compile(r"## .*?(?:`(\w+\[\][^`]*)`|top)$")
POLICY = "\n## The policy file: top\n"  # the tables behind this are about that file
TYPES = {"object": dict, "array": list, "string": str, "integer": int, "number": (int, float), "boolean": bool}


def keys_of(schema, path=""):
    """Returns each key with its schema: {"processes[].name": ...}."""
    for key, value in {**schema.get("properties", {}), "*": schema.get("additionalProperties")}.items():
        if not isinstance(value, dict):
            continue
        here = f"{path}.{key}" if path else key
        yield here, value
        yield from keys_of(value, here)
    if isinstance(schema.get("items"), dict):
        yield from keys_of(schema["items"], path + "[]")


def tables_of(text):
    """Returns (key, what is told without it, example) of each row below a heading that names a place."""
    place = None
    for line in text.split("\n"):
        if line.startswith("## "):
            found = HEADING.match(line)
            place = found and (found[1] or "")
        elif place is not None and line.startswith("| `"):
            keys, *_, without, example = line.strip("| ").split(" | ")
            for key in re.findall(r"`([^`]+)`", keys):
                yield f"{place}.{key}" if place else key, without, example.strip("`")


def takes(schema, value):
    kinds = schema.get("type", [])
    kinds = [kinds] if isinstance(kinds, str) else kinds
    if kinds and not any(isinstance(value, TYPES[kind]) and (kind == "boolean") == isinstance(value, bool) for kind in kinds):
        return False
    if "enum" in schema and value not in schema["enum"]:
        return False
    if isinstance(value, str):
        return re.search(schema.get("pattern", ""), value) is not None
    if isinstance(value, (int, float)):
        return schema.get("minimum", value) <= value <= schema.get("maximum", value)
    if isinstance(value, dict):
        known = schema.get("properties", {})
        return set(schema.get("required", [])) <= value.keys() and all(
            takes(known.get(key, schema.get("additionalProperties", {})), inner) for key, inner in value.items()
            if key in known or isinstance(schema.get("additionalProperties"), dict))
    return True


class Keys:
    """What is so of the keys of each kind of file."""

    def setUp(self):
        self.whole = json.loads((ROOT / f"schemas/{self.kind}.schema.json").read_text(encoding="utf-8"))
        # "frames.*" is no key that a deployment file has.
        self.schema = {key: value for key, value in keys_of(self.whole) if not key.endswith(".*")}
        self.page = self.part_of((ROOT / "docs/howto/deployment.md").read_text(encoding="utf-8"))
        self.rows = list(tables_of(self.page))

    def test_every_key_has_one_row(self):
        self.assertEqual(sorted(key for key, *_ in self.rows), sorted(self.schema))

    def test_defaults_are_those_of_the_schema(self):
        for key, without, _ in self.rows:
            default = self.schema[key].get("default")
            if default is not None:
                self.assertEqual(without, f"`{default if isinstance(default, str) else json.dumps(default)}`", key)

    def test_required_keys_are_said_to_be(self):
        required = {}
        for key in self.schema:
            parent, _, name = key.rpartition(".")
            owner = self.schema.get(parent.removesuffix("[]"), {}) if parent else self.whole
            owner = owner.get("items", owner) if parent.endswith("[]") else owner
            required[key] = name in owner.get("required", [])
        for key, without, _ in self.rows:
            self.assertEqual(without == "required", required[key], key)

    def test_examples_are_taken(self):
        for key, _, example in self.rows:
            self.assertTrue(takes(self.schema[key], json.loads(example)), f"{key}: {example}")

    def test_the_program_reads_every_key(self):
        sources = "".join(path.read_text(encoding="utf-8") for path in (ROOT / "runtime/suture/deploy/document").glob(self.sources))
        unread = [key for key in self.schema if f'"{key.rpartition(".")[2]}"' not in sources]
        self.assertEqual(unread, ["$schema"])


class DeploymentKeys(Keys, unittest.TestCase):
    kind, sources = "deployment", "deployment*.*"

    def part_of(self, page):
        return page.partition(POLICY)[0]


class PolicyKeys(Keys, unittest.TestCase):
    kind, sources = "policy", "policy_file.*"

    def part_of(self, page):
        return POLICY + page.partition(POLICY)[2]

    def test_each_form_of_who_is_taken_and_told(self):
        told = re.findall(r"^\| `([^`]+)` \|", self.page.partition("\n## The forms of `who`\n")[2].partition("\n## ")[0], re.M)
        pattern = self.schema["rules[].who"]["pattern"]
        self.assertEqual(pattern, "^(process:[^:/ ]+|user:(same|[0-9]{1,9})|tcp)$")
        forms = ["process:[^*]+", "process:.*[*].*", "user:same", "user:[0-9]+", "tcp"]
        self.assertEqual(len(told), len(forms))
        for one, form in zip(told, forms):
            self.assertRegex(one, f"^{form}$")
            self.assertRegex(one, pattern)


if __name__ == "__main__":
    unittest.main()
