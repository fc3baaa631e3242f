"""A student's way through the toy course; ./course test --walk goes through the real one."""

import unittest

from toy_course import ToyCase
from walk import Lost, Walk


class Walks(ToyCase):
    def test_the_toy_course_can_be_walked_to_its_end(self):
        walk = Walk(self.toy, self.top / "way")
        walk.run()
        self.assertEqual(walk.done, 5)

    def test_a_course_that_gives_other_points_than_it_states_is_found_out(self):
        walk = Walk(self.toy, self.top / "lost")
        body = walk.exercises["ex-01.2"]
        walk.solve = lambda id, right=walk.solve: right(id) if id != body.id else walk.write(id, "    return values.front();\n")
        with self.assertRaisesRegex(Lost, "after 2 of 5 exercises: not as it should be: 70 points of 01_first"):
            walk.run()


if __name__ == "__main__":
    unittest.main()
