"""Pages of missions."""

from __future__ import annotations

from kinetruss.report.missions.page import mission_html, mission_record, mission_text

__all__ = ["mission_html", "mission_record", "mission_text"]
