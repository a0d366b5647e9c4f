"""Channels that colour members: values over time, or for a large scene the worst of the whole run."""

from __future__ import annotations

__all__ = ["CHANNELS"]

CHANNELS: dict[str, dict[str, str]] = {
    "force": {"label": "Axial force", "unit": "N", "scale": "diverging", "low": "compression", "high": "tension",
              "array": "member_force"},
    "stress": {"label": "Stress", "unit": "Pa", "scale": "sequential", "low": "none", "high": "largest of the run",
               "array": "stress", "faces": "skin_stress"},
    "utilisation": {"label": "Utilisation", "unit": "%", "scale": "capacity", "low": "unused", "high": "full at 100 %",
                    "array": "utilisation"},
    "buckling": {"label": "Buckling margin", "unit": "", "scale": "margin", "low": "no compression", "high": "buckles",
                 "array": "buckling"},
    "speed": {"label": "Speed of the middle", "unit": "m/s", "scale": "sequential", "low": "at rest",
              "high": "largest of the run"},
}  # fmt: skip
"""Channels a scene may have. ``array`` is absent if the page computes it from others; ``faces`` colours faces."""
