"""Missions: all motions under all conditions and load cases, and their envelope."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.runs.missions.record import check_histories
    from kinetruss.runs.missions.stream import resume_mission, run_mission

__all__ = ["check_histories", "resume_mission", "run_mission"]

__getattr__, __dir__ = late(__name__, {"record": "check_histories", "stream": "resume_mission run_mission"})
