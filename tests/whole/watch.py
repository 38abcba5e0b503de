"""`verify --watch`: what changes in the case is verified again, and what it changed is said.

    watch.py BOXBEAM
"""

import pathlib
import signal
import subprocess
import sys
import tempfile
import time


def main(boxbeam):
    with tempfile.TemporaryDirectory(prefix="boxbeam-watch-") as folder:
        case = pathlib.Path(folder) / "my.toml"
        subprocess.run([boxbeam, "init", "static", str(case)], check=True, stdout=subprocess.DEVNULL)
        heard = pathlib.Path(folder) / "heard.txt"
        with open(heard, "w", encoding="utf-8") as out:
            watching = subprocess.Popen(
                [boxbeam, "verify", "--watch", "--no-pdf", "--no-plots", str(case)],
                cwd=folder, stdout=out, stderr=subprocess.STDOUT)
        try:
            tried = []

            def change(old, new, expected):
                text = case.read_text(encoding="utf-8")
                assert not old or old in text, old
                already = len(heard.read_text(encoding="utf-8")) if tried else 0
                if old:
                    # As editors do: another file, put into its place.
                    beside = case.with_suffix(".new")
                    beside.write_text(text.replace(old, new), encoding="utf-8")
                    beside.replace(case)
                tried.append(expected)
                end = time.monotonic() + 120.0
                while time.monotonic() < end:
                    if expected in heard.read_text(encoding="utf-8")[already:]:
                        return
                    assert watching.poll() is None, "it ended"
                    time.sleep(0.05)
                raise AssertionError(f"{expected!r} did not come:\n{heard.read_text()}")

            change("", "", "Ctrl-C ends it")
            change('width = "160 mm"', 'width = "150 mm"', " -> ")
            # What is wrong is said, and the watch goes on; what was right is compared with.
            change("[strength]", "[strenght]", 'did you mean "strength"')
            change("[strenght]", "[strength]", "every criterion as before")
            change("required = 1.0", "required = 9.0", "FAIL (was pass)")
        finally:
            watching.send_signal(signal.SIGINT)
            code = watching.wait(timeout=60)
        assert code == -signal.SIGINT, code
        assert (pathlib.Path(folder) / "reports/my-jib/report.txt").exists()
    print("5 changes, each answered")
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
