"""The files that a command writes are the same bytes on any number of threads."""

from harness import CHAIN, CommandLine, main


class Threads(CommandLine):
    def test_the_same_bytes(self):
        self.succeeds("generate", "clusters", "-n", "100000", "--seed", "5", "-o", "points.xyz")
        for run in CHAIN:
            written = []
            for threads in ["1", "2", "4"]:
                self.succeeds(*run, "--threads", threads)
                written.append((self.folder / run[-1]).read_bytes())
            with self.subTest(" ".join(run)):
                self.assertTrue(written[0] == written[1] == written[2])


if __name__ == "__main__":
    main()
