# SPDX-License-Identifier: MIT
"""Images paired with the depth images nearest in time, against trying all."""
import os
import random
import sys
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "examples", "orb_slam"))
import associate  # noqa: E402


class Associate(unittest.TestCase):
    def test_the_nearest_is_taken(self):
        numbers = random.Random(1)
        for _ in range(50):
            images = [(f"{t:.6f}", f"rgb/{t:.6f}.png") for t in sorted(numbers.uniform(0, 9) for _ in range(20))]
            depths = [(f"{t:.6f}", f"depth/{t:.6f}.png") for t in sorted(numbers.uniform(1, 8) for _ in range(15))]
            for line, (stamp, image) in zip(associate.associate(images, depths), images):
                words = line.split()
                self.assertEqual(words[:2], [stamp, image])
                self.assertIn((words[2], words[3]), depths)
                least = min(abs(float(d) - float(stamp)) for d, _ in depths)
                self.assertAlmostEqual(abs(float(words[2]) - float(stamp)), least)


if __name__ == "__main__":
    unittest.main()
