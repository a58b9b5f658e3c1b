"""Parses the files of a TwinCAT folder with blark, and a broken copy of each, which it must refuse. Called by check-twincat."""

import multiprocessing
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


def items(file):
    """How many items a file of this name and text has; the first failure, if there is one."""
    name, text = file
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / name
        path.write_bytes(text.encode("utf-8"))
        try:
            results = list(parse.parse(path))
        except Exception as failure:  # whatever the parser stumbles over is a failure of the file
            return 0, str(failure)
        failures = [result.exception for result in results if result.exception is not None]
        trees = [result for result in results if result.tree is not None]
        return len(trees), str(failures[0]) if failures else None


def broken(path, text):
    """The name and text of a broken copy of the file."""
    copy = re.sub(*BREAK[path.suffix], text, count=1)
    if copy == text:
        sys.exit(f"{path}: there was nothing to break")
    return path.name, copy


def main():
    paths = sorted(path for path in pathlib.Path(sys.argv[1]).rglob("*") if path.suffix in FORMS)
    texts = {path: path.read_bytes().decode("utf-8") for path in paths}
    # A text that several folders have is parsed once.
    paths = list({text: path for path, text in texts.items()}.values())
    of_form = {form: [path for path in paths if path.suffix == form] for form in FORMS}
    # A few short ones of each form are enough to show that the check can fail.
    to_break = [path for form in FORMS for path in sorted(of_form[form], key=lambda path: len(texts[path]))[:3]]
    # A file takes a second or two: as many side by side as there are processors.
    with multiprocessing.Pool() as pool:
        found = dict(zip(paths, pool.map(items, [(path.name, texts[path]) for path in paths], chunksize=1)))
        of_broken = pool.map(items, [broken(path, texts[path]) for path in to_break], chunksize=1)
    for path, (count, failure) in found.items():
        if failure is not None or count == 0:
            sys.exit(f"{path}: {failure or 'nothing in it'}")
    for path, (_, failure) in zip(to_break, of_broken):
        if failure is None:
            sys.exit(f"{path}: blark takes it although it is broken")
    for form, files in of_form.items():
        if not files:
            sys.exit(f"there is no file {form}")
        parsed = sum(found[path][0] for path in files)
        print(f"{form}: {len(files)} files, {parsed} items, all parsed; broken ones are refused")


# Where a process begins anew, it reads this file.
if __name__ == "__main__":
    main()
