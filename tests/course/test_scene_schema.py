"""The schema of scene files: the course's examples fit it, slips of the pen don't."""

import copy
import json
import pathlib
import unittest

import jsonschema

TOP = pathlib.Path(__file__).resolve().parents[2]
SCHEMA = json.loads((TOP / "docs/scene.schema.json").read_text(encoding="utf-8"))


class SceneSchema(unittest.TestCase):
    def test_examples_fit(self):
        examples = sorted((TOP / "assets/scenes").glob("*.json"))
        self.assertEqual(len(examples), 4)
        for example in examples:
            jsonschema.validate(json.loads(example.read_text(encoding="utf-8")), SCHEMA)

    def test_slips_do_not(self):
        scene = json.loads((TOP / "assets/scenes/first.json").read_text(encoding="utf-8"))

        def change(path, value):
            bad = copy.deepcopy(scene)
            at = bad
            for step in path[:-1]:
                at = at[step]
            at[path[-1]] = value
            return bad

        for path, value in [(["kamera"], {}), (["camera", "width"], 0), (["camera", "position"], [1, 2]),
                            (["objects", 0, "shape", "type"], "ball"), (["objects", 1, "shape", "radius"], -1),
                            (["materials", "gold", "roughness"], 2), (["lights", 0, "file"], "sky.exr"),
                            (["render", "method", "type"], "magic"), (["render", "passes"], 0.5)]:
            with self.assertRaises(jsonschema.ValidationError, msg=path):
                jsonschema.validate(change(path, value), SCHEMA)


if __name__ == "__main__":
    unittest.main()
