# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The entry script: the list of packages that each release takes, its line of progress on a terminal, and the demo.

It runs in a folder of its own, where apt-get, dpkg-query and cmake are stand-ins that note how they were called.
"""

import os
import pty
import re
import shutil
import subprocess
import tempfile
import time
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
SOURCE = os.path.join(HERE, "..", "..")

RELEASES = {  # name: ID, ID_LIKE, code name, list, whether it was tried
    "Debian 12": ("debian", "", "bookworm", "debian-12", True),
    "Debian 13": ("debian", "", "trixie", "debian-13", True),
    "Debian forky": ("debian", "", "forky", "debian-forky", True),
    "Ubuntu 22.04": ("ubuntu", "debian", "jammy", "debian-12", False),
    "Ubuntu 24.04": ("ubuntu", "debian", "noble", "debian-12", False),
    "Ubuntu 26.04": ("ubuntu", "debian", "resolute", "debian-13", False),
    "Linux Mint": ("linuxmint", "ubuntu debian", "zara", "debian-13", False),
    "Fedora": ("fedora", "", "", None, False),
}

STAND_INS = {
    "apt-get": 'echo "$*" >>"$NOTES"\n'
               'if [ "$1" = install ]; then\n'
               '  for done in 20 40 60 80; do echo "dlstatus:1:$done:file" >&3; sleep "${PACE:-0}"; done\n'
               'fi',
    "dpkg-query": "true",
    "sudo": 'while [ $# -gt 0 ] && [ "${1#-}" != "$1" ]; do shift; done; exec "$@"',
    "cmake": 'for k in 1 2 3; do echo "[$k/4] Building CXX object Common/$k.o"; sleep "${PACE:-0}"; done',
}


def words(name):
    """The names in a list of packages by its sections."""
    sections, section = {}, None
    with open(os.path.join(SOURCE, "CMake", "packages", name + ".txt"), encoding="utf-8") as file:
        for line in file:
            line = line.strip()
            if line.startswith("["):
                section = sections.setdefault(line.strip("[]"), set())
            elif line and not line.startswith("#"):
                section.add(line)
    return sections


class EntryScript(unittest.TestCase):
    """The script, copied beside its lists of packages."""

    def setUp(self):
        self.folder = tempfile.mkdtemp(prefix="littoral-entry-")
        self.addCleanup(shutil.rmtree, self.folder)
        self.script = shutil.copy(os.path.join(SOURCE, "littoral"), self.folder)
        shutil.copytree(os.path.join(SOURCE, "CMake", "packages"), self.path("CMake", "packages"))
        os.mkdir(self.path("bin"))
        for name, text in STAND_INS.items():
            with open(self.path("bin", name), "w", encoding="utf-8") as file:
                file.write("#!/bin/sh\n" + text + "\n")
            os.chmod(self.path("bin", name), 0o755)
        self.environment = dict(
            os.environ, PATH=self.path("bin") + ":" + os.environ["PATH"], NOTES=self.path("notes"),
            LITTORAL_OS_RELEASE=self.path("os-release"))

    def all_packages_are_there(self):
        """Make the script believe it, on Debian 12."""
        self.release("Debian 12")
        with open(self.path("bin", "dpkg-query"), "w", encoding="utf-8") as file:
            file.write("#!/bin/sh\n" + "".join(f"echo ii  {name}\n" for part in words("debian-12").values() for name in part))

    def write(self, name, text):
        os.makedirs(os.path.dirname(self.path(name)), exist_ok=True)
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(text)

    def path(self, *parts):
        return os.path.join(self.folder, *parts)

    def release(self, name):
        """Make the script believe that it runs there."""
        kind, like, codename = RELEASES[name][:3]
        with open(self.path("os-release"), "w", encoding="utf-8") as file:
            file.write(f'ID={kind}\nID_LIKE="{like}"\nVERSION_CODENAME={codename}\nPRETTY_NAME="{name}"\n')

    def run_script(self, *arguments):
        return subprocess.run(
            ["bash", self.script, *arguments], env=self.environment, capture_output=True, text=True, check=False)

    def run_on_terminal(self, *arguments):
        """The lines that a terminal shows, one for each time that the cursor goes back."""
        try:
            leader, follower = pty.openpty()
        except OSError as error:
            self.skipTest(f"there is no terminal: {error}")
        with subprocess.Popen(["bash", self.script, *arguments], env=dict(self.environment, COLUMNS="200"),
                              stdin=subprocess.DEVNULL, stdout=follower, stderr=follower):
            os.close(follower)
            text = b""
            try:
                while True:
                    text += os.read(leader, 4096)
            except OSError:  # the other end was closed
                os.close(leader)
        return text.decode().replace("\x1b[K", "").split("\r")

    def test_each_release_takes_its_list(self):
        uses = ("run", "build", "run-vtk", "build-vtk", "test", "documentation")
        for name, (_, _, _, wanted, _) in RELEASES.items():
            self.release(name)
            lists = words(wanted or "debian-13")  # elsewhere the names of Debian 13 serve as a description
            for asked in [uses, *((use,) for use in ("run", "test") if name == "Debian 13")]:
                with self.subTest(release=name, uses=asked):
                    printed = self.run_script("packages", *asked)
                    self.assertEqual(printed.returncode, 0, printed.stderr)
                    self.assertEqual(set(printed.stdout.split()), set().union(*(lists[use] for use in asked)))

    def test_a_release_that_was_not_tried_is_told(self):
        for name in "Debian 12", "Debian forky", "Ubuntu 26.04", "Linux Mint":
            tried = RELEASES[name][-1]
            with self.subTest(release=name):
                self.release(name)
                lines = self.run_script("setup", "test").stdout
                self.assertEqual("was not tried" in lines, not tried, lines)
                self.assertIn(name if not tried else "done", lines)

    def test_only_what_is_asked_for_is_installed(self):
        self.release("Debian 13")
        self.assertEqual(self.run_script("setup", "run", "build").returncode, 0)
        with open(self.path("notes"), encoding="utf-8") as file:
            update, install = file.read().splitlines()
        self.assertEqual(update, "update")
        asked = {word for word in install.split()[1:] if re.match("[a-z0-9]", word)} - {"APT::Status-Fd=3"}
        lists = words("debian-13")
        self.assertEqual(asked, lists["run"] | lists["build"])
        self.assertFalse(asked & {"libgtest-dev", "libbenchmark-dev"})

    def test_elsewhere_nothing_is_installed(self):
        self.release("Fedora")
        printed = self.run_script("setup", "run")
        self.assertEqual(printed.returncode, 0, printed.stderr)
        self.assertIn("Fedora is not of Debian's kind", printed.stdout)
        self.assertFalse(os.path.exists(self.path("notes")))

    def test_an_unknown_list_is_refused(self):
        self.release("Debian 12")
        printed = self.run_script("setup", "runs")
        self.assertEqual(printed.returncode, 1)
        self.assertRegex(printed.stderr, "^.littoral. setup: there is no list 'runs' in .*debian-12.txt\n$")

    def test_an_unknown_option_of_the_demo_is_refused(self):
        done = self.run_script("demo", "--film")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("there is no option --film", done.stderr)
        self.assertFalse(os.path.exists(self.path("demo-output")))

    def test_the_demo_makes_pictures_and_says_how_to_make_films(self):
        self.all_packages_are_there()
        self.write("build/build.ninja", "")
        self.write("build/bin/littoral-env", '#!/bin/sh\necho "$@"\n')
        os.chmod(self.path("build", "bin", "littoral-env"), 0o755)
        folder = self.path("out")
        for options, end in (((), f"./littoral demo --films {folder}"), (("--films",), f"Look into {folder}")):
            with self.subTest(options=options):
                printed = self.run_script("demo", *options, folder)
                self.assertEqual(printed.returncode, 0, printed.stderr)
                self.assertIn(" ".join(("ParaView/demo.py", folder, *options)) + "\n", printed.stdout)
                self.assertTrue(printed.stdout.rstrip().endswith(end), printed.stdout)

    def test_setup_tells_the_time_left(self):
        self.release("Debian 12")
        self.environment["PACE"] = "1"
        lines = [line for line in self.run_on_terminal("setup", "test") if line.startswith("setup: ")]
        gone = [int(re.match(r"setup: (\d+) s", line)[1]) for line in lines]
        self.assertGreaterEqual(len(gone), 3)  # it takes four seconds
        self.assertEqual(gone, list(range(1, len(gone) + 1)))
        self.assertTrue(all("s left" in line for line in lines[1:]), lines)

    def test_the_build_shows_the_progress_of_ninja(self):
        self.all_packages_are_there()
        self.environment["PACE"] = "1.2"
        self.write("build/build.ninja", "")
        lines = [line for line in self.run_on_terminal("build") if line.startswith("build: ")]
        self.assertGreaterEqual(len(lines), 3)
        for line in lines:
            self.assertRegex(line, r"^build: \d+ s: \[\d/4\] Building CXX object")
        self.assertIn("[3/4]", lines[-1])

    def test_the_build_of_a_copied_checkout_is_configured_anew(self):
        self.all_packages_are_there()
        for home, anew in ((self.folder, False), ("/somewhere/else", True)):
            with self.subTest(home=home):
                self.write("build/build.ninja", "")
                self.write("build/CMakeCache.txt", f"CMAKE_HOME_DIRECTORY:INTERNAL={home}\n")
                printed = self.run_script("build")
                self.assertEqual(printed.returncode, 0, printed.stderr)
                self.assertEqual("configure: done" in printed.stdout, anew, printed.stdout)
                self.assertEqual(os.path.exists(self.path("build", "CMakeCache.txt")), not anew)

    def test_a_tree_of_links_has_the_build_of_the_tree(self):
        self.all_packages_are_there()
        home = self.path("home")
        self.write("home/CMakeLists.txt", "")
        os.symlink(os.path.join(home, "CMakeLists.txt"), self.path("CMakeLists.txt"))
        self.write("build/build.ninja", "")
        self.write("build/CMakeCache.txt", f"CMAKE_HOME_DIRECTORY:INTERNAL={home}\n")
        self.assertNotIn("configure", self.run_script("build").stdout)
        self.assertTrue(os.path.exists(self.path("build", "CMakeCache.txt")))

    def test_a_copied_checkout_does_not_run_the_programs_of_the_other(self):
        self.all_packages_are_there()
        self.write("build/build.ninja", "")
        self.write("build/bin/littoral-env", "#!/bin/sh\necho of $0\n")
        os.chmod(self.path("build", "bin", "littoral-env"), 0o755)
        for home, anew in ((self.folder, False), ("/somewhere/else", True)):
            self.write("build/CMakeCache.txt", f"CMAKE_HOME_DIRECTORY:INTERNAL={home}\n")
            self.assertEqual("build: compiling" in self.run_script("run", "true").stderr, anew)

    def test_two_builds_take_turns(self):
        self.all_packages_are_there()
        self.write("bin/cmake", 'echo begin >>"$NOTES"; timeout 20 sh -c "until [ -e $NOTES.go ]; do sleep 0.05; done"; echo end >>"$NOTES"')
        self.write("build/build.ninja", "")
        command = ["bash", self.script, "build"]
        with subprocess.Popen(command, env=self.environment, stdout=subprocess.DEVNULL) as first:
            while not os.path.exists(self.path("notes")):
                time.sleep(0.05)
            with subprocess.Popen(command, env=self.environment, stdout=subprocess.PIPE, text=True) as second:
                waits = any("waiting for the end of another one" in line for line in second.stdout)
                with open(self.path("notes.go"), "w", encoding="utf-8"):
                    pass
                second.stdout.read()
                self.assertEqual((waits, first.wait(), second.wait()), (True, 0, 0))
        with open(self.path("notes"), encoding="utf-8") as file:
            self.assertEqual(file.read().split(), ["begin", "end"] * 2)

    def test_without_rights_nothing_old_is_shown(self):
        self.all_packages_are_there()
        self.write("build/build.ninja", "")
        self.write("build/logs/build.log", "an old error")
        command, user = ["bash", self.script, "build"], None
        os.chmod(self.folder, 0o755)
        if os.getuid() == 0:  # root writes everywhere
            user = 65534
        else:
            os.chmod(self.path("build", "logs"), 0o500)
            self.addCleanup(os.chmod, self.path("build", "logs"), 0o700)
        printed = subprocess.run(
            command, env=self.environment, capture_output=True, text=True, check=False, user=user)
        self.assertEqual(printed.returncode, 1)
        self.assertNotIn("an old error", printed.stdout + printed.stderr)
        self.assertRegex(printed.stderr, "needs to write into .*build, and .* cannot")

    def test_each_tier_builds_and_runs_its_tests(self):
        self.all_packages_are_there()
        self.write("build/build.ninja", "")
        self.write("build/CMakeCache.txt", f"CMAKE_HOME_DIRECTORY:INTERNAL={self.folder}\nLITTORAL_BUILD_TESTING:BOOL=ON\n"
                                           "Python3_EXECUTABLE:FILEPATH=true\n")
        self.write("build/bin/littoral-env", "")
        for name in ("build/bin/littoral-env", "bin/cmake", "bin/ctest", "bin/xvfb-run"):
            self.write(name, '#!/bin/sh\necho "$*" >>"$NOTES"\n')
            os.chmod(self.path(name), 0o755)
        for given, target, selected, rest in (
                ([], "all", " -LE ^all$", ""), (["--quick"], "quick-tests", " -L ^quick$", ""), (["--all"], "all", "", ""),
                (["-R", "Sway"], "all", "", " -R Sway"), (["--quick", "-V"], "quick-tests", " -L ^quick$", " -V"),
                (["-V"], "all", " -LE ^all$", " -V")):
            with self.subTest(given=given):
                self.write("notes", "")
                printed = self.run_script("test", *given)
                self.assertEqual(printed.returncode, 0, printed.stderr)
                with open(self.path("notes"), encoding="utf-8") as file:
                    notes = file.read()
                self.assertIn(f"--target {target}\n", notes)
                self.assertRegex(notes, f"--parallel \\d+{re.escape(selected + rest)}\n")

    def test_tests_without_a_display_say_what_is_missing(self):
        self.all_packages_are_there()
        self.write("build/build.ninja", "")
        self.write("build/CMakeCache.txt",
                   f"CMAKE_HOME_DIRECTORY:INTERNAL={self.folder}\nLITTORAL_BUILD_TESTING:BOOL=ON\n")
        for tool in ("bash", "awk", "cat", "comm", "cp", "cut", "date", "dirname", "echo", "env", "fold", "flock", "git",
                     "grep", "head", "id", "mkdir", "nproc", "readlink", "rm", "sed", "seq", "sh", "sleep", "sort",
                     "tail", "tee", "tr", "true", "wc"):
            if shutil.which(tool) and not os.path.exists(self.path("bin", tool)):  # not each system has git
                os.symlink(shutil.which(tool), self.path("bin", tool))
        self.environment["PATH"] = self.path("bin")
        printed = self.run_script("test")
        self.assertEqual(printed.returncode, 1)
        self.assertIn("xvfb-run, the display for tests, is missing", printed.stderr)


if __name__ == "__main__":
    unittest.main()
