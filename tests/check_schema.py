"""The JSON schema of a set accepts what `axgen check` accepts, and refuses what the place of a value alone shows. Called by check-schema."""

import json
import pathlib
import subprocess
import sys
import tempfile
import tomllib

import jsonschema

AXGEN = sys.argv[1:]
# Every change of `schema.toml` is made in this set, which is valid.
SET = """cycle_time = '1ms'
targets = ['c']
[axis.X]
lr_param.improved_position_control.v_add_max_fact = 1
lr_param.improved_position_control.stage = [{ mode = 'DIRECT', weight_fact_num = 1, filter = [{ order = 1, fg_f0 = 53, q_factor = 10 }] }]
"""


def axgen(*arguments):
    return subprocess.run([*AXGEN, *map(str, arguments)], capture_output=True, check=False, text=True)


def mistakes(validator, text):
    """What the schema says about a set."""
    return [f"{error.json_path}: {error.message}" for error in validator.iter_errors(tomllib.loads(text))]


def accepted(validator, name, text):
    if found := mistakes(validator, text):
        sys.exit(f"{name}: the schema refuses it: {found}\n{text}")


def repository(validator):
    """Counts the sets of the repository and what `import` makes of its lists: the schema accepts them."""
    sets = [pathlib.Path("generator/cli/src/starter.toml"), *pathlib.Path("golden/cases").rglob("set.toml")]
    sets += [path for path in pathlib.Path("examples").rglob("*.toml") if path.name not in ("Cargo.toml", "case.toml")]
    for path in sets:
        accepted(validator, path, path.read_text("utf-8"))
    lists = [*pathlib.Path("examples").rglob("*.lis"), *pathlib.Path("golden/cases").rglob("*.lis")]
    for path in lists:
        accepted(validator, path, axgen("import", path, "--cycle-time", "1ms", "--name", "X").stdout)
    return len(sets), len(lists)


def changed(validator, folder):
    """Counts the changes of `schema.toml`: `check` and the schema accept those of the first list, and refuse those of the second."""
    lists = tomllib.loads(pathlib.Path("tests/schema.toml").read_text("utf-8"))
    for name, changes in lists.items():
        for before, after in changes:
            assert SET.count(before) == 1, before
            text = SET.replace(before, after)
            path = pathlib.Path(folder, "set.toml")
            path.write_text(text, "utf-8")
            if axgen("check", path).returncode != (0 if name == "accepted" else 2):
                sys.exit(f"`axgen check` says something else than {name}:\n{text}\n{axgen('check', path)}")
            if name == "accepted":
                accepted(validator, name, text)
            elif not mistakes(validator, text):
                sys.exit(f"the schema accepts what `axgen check` refuses:\n{text}")
    return [len(changes) for changes in lists.values()]


schema = json.loads(axgen("schema").stdout)
judge = jsonschema.validators.validator_for(schema)
judge.check_schema(schema)
with tempfile.TemporaryDirectory() as temporary:
    counts = *repository(judge(schema)), *changed(judge(schema), temporary)
    if min(counts) < 2:
        sys.exit(f"too little was compared: {counts}")
print("{} sets and {} lists of the repository; {} changes accepted, {} refused".format(*counts))
