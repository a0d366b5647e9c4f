"""How results look, defined in one place: numbers with units, colours, tables, the frame of a page."""

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.display.html import (
        POLICY as POLICY,
        Markup as Markup,
        element as element,
        html_page as html_page,
        joined as joined,
    )
    from kinetruss.display.numbers import (
        DIGIT as DIGIT,
        POINT as POINT,
        aligned as aligned,
        counted as counted,
        instant as instant,
        margin as margin,
        moment as moment,
        number as number,
        quantity as quantity,
        round_up as round_up,
        scale as scale,
        ticks as ticks,
    )
    from kinetruss.display.palettes import (
        COLOURS as COLOURS,
        DIVERGING as DIVERGING,
        DRIVEN as DRIVEN,
        ELASTIC as ELASTIC,
        KINDS as KINDS,
        LOAD as LOAD,
        MISSING as MISSING,
        OVER as OVER,
        SEQUENTIAL as SEQUENTIAL,
        SKINS as SKINS,
        THEMES as THEMES,
        colours_of as colours_of,
        contrast as contrast,
        limits_of as limits_of,
        rgb as rgb,
    )
    from kinetruss.display.tables import Column as Column, Table as Table

__getattr__, __dir__, __all__ = late(__name__)
