"""Missions as text and data, and their tables."""

from __future__ import annotations

from kinetruss.report.missions.page import TRAIN_UNITS, mission_head, mission_record, mission_tables, mission_text

__all__ = ["TRAIN_UNITS", "mission_head", "mission_record", "mission_tables", "mission_text"]
