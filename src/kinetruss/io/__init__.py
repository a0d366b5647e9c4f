"""Model files and tables: read, write, check; the JSON Schema; values set by path; export of stored runs."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.io._schema import schema, schema_file
from kinetruss.io.formats.text import MAX_SIZE
from kinetruss.io.models.catalogue import read_catalogue
from kinetruss.io.models.cells import read_cell
from kinetruss.io.models.check import check
from kinetruss.io.models.mission import read_mission
from kinetruss.io.models.read import placed, read
from kinetruss.io.models.set_value import set_value, set_values
from kinetruss.io.models.write import write
from kinetruss.io.tables.history import NodeHistory, read_history
from kinetruss.io.tables.measured import read_measured
from kinetruss.io.tables.strains import StrainHistory, read_strains
from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.io.tables.export import export

__all__ = [
    "MAX_SIZE", "NodeHistory", "StrainHistory", "check", "export", "placed", "read", "read_catalogue", "read_cell",
    "read_history", "read_measured", "read_mission", "read_strains", "schema", "schema_file", "set_value", "set_values",
    "write",
]  # fmt: skip

# reading a model needs no run store
__getattr__, __dir__ = late(__name__, {"tables.export": "export"})
