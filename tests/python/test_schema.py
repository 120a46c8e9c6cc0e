"""Schemas by --schema: all shipped files fit them, and misspelt keys do not."""
import json
import os
import pathlib
import subprocess
import tomllib
import unittest

BIN = pathlib.Path(os.environ["CONTACT_BUILD"]) / "bin"
DATA = pathlib.Path(__file__).parents[2] / "data"
TYPES = {
    "number": (int, float), "integer": int, "array": list, "object": dict,
    "string": str,
}  # fmt: skip


def schema_of(program):
    run = subprocess.run(
        [BIN / program, "--schema"], check=True, capture_output=True, text=True
    )
    return json.loads(run.stdout)


def strangers(value, schema, root, place=""):
    """Places of a file that are not as this part of a schema says."""
    if "$ref" in schema:
        part = root
        for step in schema["$ref"].split("/")[1:]:
            part = part[step]
        schema = part
    types = schema.get("type", list(TYPES))
    types = [types] if isinstance(types, str) else types
    if not isinstance(value, tuple(TYPES[t] for t in types) + (bool,)):
        return [place]
    found = []
    if isinstance(value, dict):
        for key, inside in value.items():
            known = schema.get("properties", {}).get(key)
            if known is None:
                found.append(f"{place}.{key}")
            else:
                found += strangers(inside, known, root, f"{place}.{key}")
    elif isinstance(value, list) and "items" in schema:
        for inside in value:
            found += strangers(inside, schema["items"], root, place)
    return found


class Schema(unittest.TestCase):
    def test_shipped_files_fit(self):
        for program, folder in (
            ("hinge-joint", "joints"),
            ("hinge-separation", "cases"),
            ("hinge-study", "studies"),
        ):
            schema = schema_of(program)
            files = sorted((DATA / folder).glob("*.toml"))
            self.assertGreater(len(files), 2)
            for file in files:
                content = tomllib.loads(file.read_text())
                self.assertEqual(strangers(content, schema, schema), [], file)
                # No table has such a key.
                wrong = content | {"clearence": 1}
                self.assertEqual(
                    strangers(wrong, schema, schema), [".clearence"], file
                )

    def test_units(self):
        geometry = schema_of("hinge-joint")["properties"]["geometry"]
        keys = geometry["properties"]
        self.assertEqual(keys["radius_mm"]["description"], "in mm")
        self.assertEqual(keys["radius"]["description"], "in m")
        self.assertFalse(geometry["additionalProperties"])
        file = {"geometry": {"radius_mm": "50", "radius_ml": 1}}
        schema = schema_of("hinge-joint")
        self.assertEqual(
            strangers(file, schema, schema),
            [".geometry.radius_mm", ".geometry.radius_ml"],
        )


if __name__ == "__main__":
    unittest.main()
