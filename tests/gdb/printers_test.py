"""gdb prints slots, samples and Eigen's fixed types as a person reads them: printers_test.py GDB PRINTERS PROGRAM"""

import subprocess
import sys

EXPECTED = {
    "text": '"servo"',
    "openText": '"any length"',
    "list": "2 of at most 4 = {1.5, 2.5}",
    "openList": "1 of any number = {3.5}",
    "matrix": "2x2 [[1, 2], [3, 4]]",
    "nothing": "nothing",
    "some": "some = {value = 7}",
    "tuple": "{[0] = 4, [1] = 0.5}",
    "variant": "alternative 1 = {value = 2.25}",
    "fresh": "stamp 1.500000000 s = {value = 0.25}",
    "lost": "not to be acted on, suture::Errc::Lost, never produced",
    "vector": "[1, 2, 3]",
    "square": "2x2 [[1, 2], [3, 4]]",
    "quaternion": "w 1, x 0, y 0, z 0",
    "pose": "4x4 [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]",
}


def main():
    debugger, printers, program = sys.argv[1:]
    commands = ["set confirm off", f"source {printers}", "break stopHere", "run", "up"]
    for name in EXPECTED:
        commands += [f"echo @{name}=", f"print {name}"]
    arguments = [part for command in commands for part in ("-ex", command)]
    done = subprocess.run([debugger, "-nx", "-batch", *arguments, program], capture_output=True, text=True, timeout=300)
    printed = {}
    for part in done.stdout.split("@")[1:]:
        name, _, rest = part.partition("=")
        printed[name] = rest.partition(" = ")[2].strip().splitlines()[0] if " = " in rest else rest
    wrong = [f"{name}: expected {text}, but gdb prints {printed.get(name)}"
             for name, text in EXPECTED.items() if printed.get(name) != text]
    for line in wrong:
        print(line)
    if wrong:
        print(done.stdout, done.stderr, sep="\n")
        sys.exit(1)
    print(f"{len(EXPECTED)} values as expected")


if __name__ == "__main__":
    main()
