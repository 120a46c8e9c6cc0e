"""The schemas that programs print: all shipped files are valid by them,
mistakes planted in these are found, and limits are those of the readers.
python3-jsonschema checks."""

import json
import subprocess
import sys
import tomllib
from pathlib import Path

import jsonschema

programs = Path(sys.argv[1])
data = Path(sys.argv[2])


def validator(program):
    text = subprocess.run(
        [programs / program, "--schema"], check=True, capture_output=True, text=True
    ).stdout
    jsonschema.Draft7Validator.check_schema(json.loads(text))
    return jsonschema.Draft7Validator(json.loads(text))


def read(file):
    return tomllib.loads((data / file).read_text())


joint = validator("hinge-joint")
case = validator("hinge-separation")
study = validator("hinge-study")
files = 0
for schema, folder, name in (
    (joint, "joints", "joint"), (case, "cases", "case"), (study, "studies", "study")
):  # fmt: skip
    shipped = json.loads((data / f"schemas/{name}.json").read_text())
    assert shipped == schema.schema, f"data/schemas/{name}.json is not as printed"
    for file in sorted((data / folder).glob("*.toml")):
        files += 1
        first = file.read_text().partition("\n")[0]
        assert first == f"#:schema ../schemas/{name}.json", (file, first)
        for error in schema.iter_errors(tomllib.loads(file.read_text())):
            sys.exit(f"{file}: {error.json_path}: {error.message[:200]}")
assert files > 20, files


def planted(schema, file, change):
    document = read(file)
    assert schema.is_valid(document)
    change(document)
    assert not schema.is_valid(document), (file, document)


pin = "joints/pin_joint.toml"
planted(joint, pin, lambda d: d["geometry"].update(radius_mn=25))
planted(joint, pin, lambda d: d["geometry"].update(radial_clearence_um=25))
planted(joint, pin, lambda d: d["geometry"].update(length_mm="25"))
planted(joint, pin, lambda d: d["geometry"].update(length_mm=25, length_m=0.025))
planted(joint, pin, lambda d: d.update(fricton={"coefficient": 0.1}))
planted(joint, pin, lambda d: d.update(temperature=80.0))
planted(case, "cases/soyuz.toml", lambda d: d["run"].update(ouput_step_s=1))
planted(case, "cases/soyuz.toml", lambda d: d["body"][0].update(mass_lb=1))


# A key of another kind of force.
def key_of_another_kind(document):
    kinds = {force["kind"]: force for force in document["force"]}
    for key in {k for f in kinds.values() for k in f}:
        for force in document["force"]:
            has = case.is_valid(document)
            before = dict(force)
            force.setdefault(key, 1.0)
            if has and not case.is_valid(document):
                return
            force.clear()
            force.update(before)


planted(case, "cases/soyuz.toml", key_of_another_kind)

# Numbers and words that no reader takes.
planted(joint, pin, lambda d: d["geometry"].update(radius_mm=0))
planted(joint, pin, lambda d: d.update(kind="pinn"))
planted(joint, pin, lambda d: d["friction"].update(coefficient=-0.1))
planted(joint, pin, lambda d: d.update(temperature_C=-274))
planted(case, "cases/soyuz.toml", lambda d: d["body"][0].update(mass_t=0))
planted(case, "cases/soyuz.toml", lambda d: d["run"].update(integrator="euler"))
planted(case, "cases/soyuz.toml", lambda d: d["force"][0].update(thrust_kN=-1))
planted(study, "studies/soyuz.toml", lambda d: d.update(runs=0))
planted(study, "studies/soyuz.toml", lambda d: d["requirement"][0].update(success=1))


def refusal(file, key, value):
    """The message of a program that does not read the file with the setting."""
    beta = [] if read(file)["kind"] == "pin" else ["--beta", "90"]
    done = subprocess.run(
        [programs / "hinge-joint", data / file, "--load", "1kN", *beta,
         "--set", f"{key}={value}"],
        capture_output=True, text=True,
    )  # fmt: skip
    return done.stderr if done.returncode == 2 else ""


def check_limits(file, table, schema, place):
    """A millionth beyond each limit of its numbers, and on excluded ones."""
    count = 0
    for key, value in table.items():
        known = schema["properties"][key]
        if isinstance(value, dict):
            count += check_limits(file, value, known, f"{place}{key}.")
        if not isinstance(value, (int, float)):
            continue
        for word, limit in known.items():
            if not word.endswith("imum"):
                continue
            step = 1e-6 * (abs(limit) or 1)
            beyond = [limit - step if word.endswith("inimum") else limit + step]
            if word.startswith("exclusive"):
                beyond.append(limit)
            for number in beyond:
                said = refusal(file, place + key, number)
                assert "must be" in said, (file, place + key, number, said)
                count += 1
    return count


found = sum(
    check_limits(file, read(file), joint.schema, "")
    for file in (pin, "joints/hip_cup.toml", "joints/relieved_bush.toml")
)
assert found > 12, found
