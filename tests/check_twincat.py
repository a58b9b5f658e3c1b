"""Parses the files of a TwinCAT folder with blark, and a broken copy of each, which it must refuse. Called by check-twincat."""

import pathlib
import re
import sys
import tempfile

from blark import parse

FORMS = (".TcPOU", ".TcDUT", ".TcGVL")
# What breaks each form: a statement, a type, a variable.
BREAK = {
    ".TcPOU": (r"(<ST><!\[CDATA\[)", r"\1IF IF THEN;\n"),
    ".TcDUT": (r"(\nEND_TYPE)", r";) DINT\1"),
    ".TcGVL": (r"(\nEND_VAR)", r"\n) DINT\1"),
}


def items(name, text):
    """How many items a file of this name and text has; the first failure, if there is one."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / name
        path.write_bytes(text.encode("utf-8"))
        try:
            results = list(parse.parse(path))
        except Exception as failure:  # whatever the parser stumbles over is a failure of the file
            return 0, failure
        failures = [result.exception for result in results if result.exception is not None]
        trees = [result for result in results if result.tree is not None]
        return len(trees), failures[0] if failures else None


def main():
    counts = {form: [0, 0] for form in FORMS}
    for path in sorted(path for path in pathlib.Path(sys.argv[1]).rglob("*") if path.suffix in FORMS):
        text = path.read_bytes().decode("utf-8")
        count, failure = items(path.name, text)
        if failure is not None or count == 0:
            sys.exit(f"{path}: {failure or 'nothing in it'}")
        counts[path.suffix][0] += 1
        counts[path.suffix][1] += count
        # Once for each form and kind of object is enough to show that the check can fail.
        if counts[path.suffix][0] <= 3:
            broken = re.sub(*BREAK[path.suffix], text, count=1)
            if broken == text:
                sys.exit(f"{path}: there was nothing to break")
            if items(path.name, broken)[1] is None:
                sys.exit(f"{path}: blark takes it although it is broken")
    for form, (files, parsed) in counts.items():
        if files == 0:
            sys.exit(f"there is no file {form}")
        print(f"{form}: {files} files, {parsed} items, all parsed; broken ones are refused")


main()
