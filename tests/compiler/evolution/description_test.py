"""A program that has never seen the header: all it has is the self-description (JSON) and the schema. It writes a Sample
that the program built from the header understands, and reads what that program has stored.

  description_test.py --description FILE --schemas DIR... --capnp TOOL --program PROGRAM
"""

import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent

# These go by the names of the header; units are those that the description tells.
VALUES = {
    "weight": 2.25, "count": -5, "label": "stranger", "mode": "Fast", "period": 0.04, "values": [0.5, 1.5], "seen": 77e-9,
    "east": 12.5, "pair": [1, 2], "point": [3, 4, 5], "note": "unseen",
}
UNDERSTOOD = ("count=-5 label='stranger' values=0.5,1.5, period=40 seen=77 pair=1,2 point=3 4 5 east=12.5 weight=2.25 "
              "note='unseen' mode=Fast")

# This is what bytes/v2.bin has, in the description's terms.
STORED = {
    "weight": 3, "count": 11, "label": "second", "mode": "Off", "period": 0.03, "values": [7], "seen": 11e-9, "east": -2.5,
    "pair": [2, 3], "point": [7, 8, 9], "note": "new",
}

AXES = "xyzw"


class Description:
    def __init__(self, text):
        self.json = json.loads(text)
        self.structs = {one["name"]: one for one in self.json["structs"]}
        self.enums = {one["name"]: one for one in self.json["enums"]}

    def to_wire(self, kind, value):
        """Returns a value of this type as capnp's JSON has it."""
        what = kind["kind"]
        if what in ("list", "array"):
            bound = kind.get("capacity", kind.get("length"))
            assert len(value) <= bound, f"{value} has more than {bound} elements"
            return [self.to_wire(kind["element"], one) for one in value]
        if what == "text":
            assert len(value.encode()) <= kind["capacity"], f"{value!r} has more than {kind['capacity']} bytes"
        if what in ("duration", "time"):
            return str(round(value * 1e9))
        if what == "matrix":
            return dict(zip(AXES, value))
        if what == "enum":
            one = next(one for one in self.enums[kind["name"]]["enumerators"] if one["name"] == value)
            return one.get("wire", one["name"])
        return self.record_to_wire(kind["name"], value) if what == "struct" else value

    def record_to_wire(self, name, values):
        fields = {field["name"]: field for field in self.structs[name]["fields"]}
        return {fields[key].get("wire", key): self.to_wire(fields[key]["type"], value) for key, value in values.items()}

    def from_wire(self, kind, value):
        what = kind["kind"]
        if what in ("list", "array"):
            return [self.from_wire(kind["element"], one) for one in value]
        if what in ("duration", "time"):
            return int(value) / 1e9
        if what == "matrix":
            return [value[axis] for axis in AXES[:kind["rows"]]]
        if what == "enum":
            enumerators = self.enums[kind["name"]]["enumerators"]
            return next(one["name"] for one in enumerators if one.get("wire", one["name"]) == value)
        return self.record_from_wire(kind["name"], value) if what == "struct" else value

    def record_from_wire(self, name, values):
        fields = self.structs[name]["fields"]
        return {field["name"]: self.from_wire(field["type"], values[field.get("wire", field["name"])]) for field in fields}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--description", required=True)
    parser.add_argument("--schemas", action="append", required=True)
    parser.add_argument("--capnp", required=True)
    parser.add_argument("--program", required=True)
    options = parser.parse_args()
    description = Description(pathlib.Path(options.description).read_text(encoding="utf-8"))
    sample = description.structs["evolution::Sample"]
    schema = pathlib.Path(options.schemas[0]) / description.json["schema"]

    def convert(how, data):
        command = [options.capnp, "convert", how, *(f"-I{one}" for one in options.schemas), schema,
                   sample.get("wire", sample["name"].rsplit("::", 1)[-1])]
        return subprocess.run(command, input=data, capture_output=True, check=True).stdout

    wire = json.dumps(description.record_to_wire("evolution::Sample", VALUES))
    with tempfile.TemporaryDirectory() as folder:
        message = pathlib.Path(folder) / "message.bin"
        message.write_bytes(convert("json:binary", wire.encode()))
        done = subprocess.run([options.program, "read", message], capture_output=True, text=True, check=True)
    failures = []
    if done.stdout.strip() != UNDERSTOOD:
        failures.append(f"what was written reads as\n{done.stdout}instead of\n{UNDERSTOOD}")
    stored = json.loads(convert("binary:json", (HERE / "bytes/v2.bin").read_bytes()))
    read = description.record_from_wire("evolution::Sample", stored)
    if read != STORED:
        failures.append(f"bytes/v2.bin reads as\n{read}\ninstead of\n{STORED}")
    print("\n".join(failures) or "written and read with the description alone")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
