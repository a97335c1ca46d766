# SPDX-License-Identifier: MIT
"""A host's tree in which the program cannot be built is refused when it is configured, with what it lacks."""
import os
import shutil
import subprocess
import tempfile
import unittest

EXAMPLES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "examples")
LIBRARIES = ("Thirdparty/DBoW2/lib/libDBoW2.so", "Thirdparty/g2o/lib/libg2o.so")


@unittest.skipUnless(shutil.which("cmake"), "there is no cmake")
class HostTree(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = folder.name

    def make(self, name):
        path = os.path.join(self.root, "host", name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8"):
            pass

    def said(self, host):
        """What cmake says, its lines joined."""
        done = subprocess.run(
            ["cmake", "-S", os.path.join(EXAMPLES, host.lower()), "-B", os.path.join(self.root, "build_" + host),
             f"-D{host}_ROOT={self.root}/host"],
            capture_output=True, text=True, check=False,
        )
        self.assertNotEqual(done.returncode, 0)
        return " ".join(done.stderr.split())

    def test_what_is_lacking_is_named(self):
        for host in ("ORB_SLAM2", "ORB_SLAM3"):
            shutil.rmtree(os.path.join(self.root, "host"), ignore_errors=True)
            self.assertIn("Its root has to be a source folder with the hooks of README.md.", self.said(host))
            self.make("include/SemanticHooks.h")
            for library in (f"lib/lib{host}.so", *LIBRARIES):
                self.assertIn(f"host/{library} is not there: the host has to be built first", self.said(host))
                self.make(library)


if __name__ == "__main__":
    unittest.main()
