"""Model files and tables: read, write, check; the JSON Schema; a value set by its path."""

from kinetruss.io._check import check
from kinetruss.io._history import NodeHistory, read_history
from kinetruss.io._read import read
from kinetruss.io._schema import schema, schema_file
from kinetruss.io._set_value import set_value
from kinetruss.io._text import MAX_SIZE
from kinetruss.io._write import write

__all__ = ["MAX_SIZE", "NodeHistory", "check", "read", "read_history", "schema", "schema_file", "set_value", "write"]
