# SPDX-License-Identifier: MIT
"""Images paired with the depth images nearest in time, against trying all."""
import os
import random
import sys
import tempfile
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

    def refused_for(self, texts):
        """What is said of a sequence with these lists, without its folder."""
        with tempfile.TemporaryDirectory() as folder:
            for name, text in texts.items():
                with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
                    file.write(text)
            with self.assertRaises(SystemExit) as ended:
                associate.main([folder])
            return str(ended.exception.code).replace(folder + os.sep, "")

    def test_lists_that_are_none_are_told(self):
        images = "# time image\n1.5 rgb/1.5.png\n"
        self.assertEqual(self.refused_for({}), "rgb.txt cannot be read: No such file or directory")
        self.assertEqual(
            self.refused_for({"rgb.txt": images}), "depth.txt cannot be read: No such file or directory"
        )
        self.assertEqual(
            self.refused_for({"rgb.txt": images, "depth.txt": "# none\n"}), "depth.txt: there are no images in it"
        )
        for line in ("1.6\n", "depth/1.6.png 1.6\n"):
            self.assertEqual(
                self.refused_for({"rgb.txt": images, "depth.txt": "# time image\n" + line}),
                "depth.txt:2: a line is the time of an image, s, and its file",
            )


if __name__ == "__main__":
    unittest.main()
