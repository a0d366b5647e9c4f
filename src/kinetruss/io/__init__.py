"""Model files and tables: read, write, check; the JSON Schema; values set by path; export of stored runs."""

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.io.checking import check as check
    from kinetruss.io.exporting import export as export
    from kinetruss.io.histories import (
        NodeHistory as NodeHistory,
        StrainHistory as StrainHistory,
        read_history as read_history,
        read_measured as read_measured,
        read_strains as read_strains,
    )
    from kinetruss.io.json_schema import schema as schema, schema_file as schema_file
    from kinetruss.io.library_models import read_cell as read_cell
    from kinetruss.io.missions import read_catalogue as read_catalogue, read_mission as read_mission
    from kinetruss.io.optima import read_optimum as read_optimum
    from kinetruss.io.reading import placed as placed, read as read
    from kinetruss.io.values import set_value as set_value, set_values as set_values
    from kinetruss.io.writing import write as write
    from kinetruss.io.yaml_text import MAX_SIZE as MAX_SIZE

__getattr__, __dir__, __all__ = late(__name__)
