"""The speed at which a run plays by itself."""

import json
import shutil
import subprocess
from pathlib import Path

import pytest

from kinetruss.viewer.pictures import usual_speed

SOURCES = Path(__file__).parents[2] / "viewer-src" / "src"


@pytest.mark.skipif(shutil.which("node") is None, reason="no node to run the page's functions")
def test_a_run_plays_in_five_to_eight_seconds(tmp_path):
    durations = [1e-6, 0.03, 0.6283, 1.0, 5.0, 7.99, 8.01, 12.0, 60.0, 3600.0, 1e7]
    program = tmp_path / "calls.mjs"
    program.write_text(
        f'import {{ speedsOf, usualSpeed }} from "{SOURCES.as_posix()}/timebar.js";\n'
        f"process.stdout.write(JSON.stringify({json.dumps(durations)}.map((one) => [usualSpeed(one), speedsOf(one)])));"
    )
    (tmp_path / "package.json").write_text('{"type": "module"}')
    done = subprocess.run(["node", str(program)], capture_output=True, text=True, check=True)
    for duration, (usual, speeds) in zip(durations, json.loads(done.stdout), strict=True):
        assert 5 <= duration / usual <= 8, duration
        assert usual in speeds
        assert {0.001, 0.1, 1, 10} <= set(speeds)
        assert speeds == sorted(speeds)
        assert usual_speed(duration) == usual  # a film plays as the page does
