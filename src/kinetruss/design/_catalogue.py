"""Catalogues by name or by file."""

from __future__ import annotations

from pathlib import Path

from kinetruss.errors import Fault, ModelError
from kinetruss.io import read_catalogue
from kinetruss.model import Catalogue, nearest

__all__ = ["catalogue", "catalogue_names"]

FOLDER = Path(__file__).parent / "catalogues"


def catalogue_names() -> tuple[str, ...]:
    """Names of the catalogues that are shipped."""
    return tuple(path.stem for path in sorted(FOLDER.glob("*.yaml")))


def catalogue(chosen: Catalogue | str | Path, place: tuple[str, ...] = ()) -> Catalogue:
    """A catalogue by its name, from a YAML or JSON file, or as it is; its material is a record.

    Parameters
    ----------
    place : the place of its name in the mission, for the fault of an unknown one.

    Raises
    ------
    ModelError : neither the name of one that is shipped nor a file; all faults of the file with line and column.

    Examples
    --------
    >>> len(catalogue("aluminium_tubes_inch").tubes)
    60
    """
    if isinstance(chosen, Catalogue):
        return chosen
    shipped = FOLDER / f"{chosen}.yaml"
    if str(chosen) in catalogue_names():
        return read_catalogue(shipped)
    if Path(chosen).suffix in (".yaml", ".yml", ".json", ".toml"):
        return read_catalogue(chosen)
    raise ModelError([Fault(place, f"no catalogue called {str(chosen)!r}.", nearest(chosen, catalogue_names()))])
