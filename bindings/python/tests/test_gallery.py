"""The examples of the gallery run, and docs/gallery.md shows what they draw."""
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).parents[3]


def test_the_gallery_shows_what_its_examples_draw():
    run = subprocess.run([sys.executable, ROOT / "scripts/gallery", "--check"], text=True, stdout=subprocess.PIPE,
                         stderr=subprocess.STDOUT)
    assert run.returncode == 0, run.stdout
