"""Bodies: adding them to a model by mass properties or shapes; mass properties of shapes and surfaces; equivalent bars."""

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.library.bodies.adding import (
        box as box,
        cylinder as cylinder,
        flat as flat,
        rigid as rigid,
        sphere as sphere,
        stl as stl,
        tube as tube,
        uniform as uniform,
    )
    from kinetruss.library.bodies.masses import (
        BarMasses as BarMasses,
        MassProperties as MassProperties,
        bar_masses as bar_masses,
        combined as combined,
        mass_properties as mass_properties,
        properties_of as properties_of,
    )
    from kinetruss.library.bodies.shapes import (
        box_properties as box_properties,
        cylinder_properties as cylinder_properties,
        from_stl as from_stl,
        plate_properties as plate_properties,
        read_stl as read_stl,
        rod_properties as rod_properties,
        sphere_properties as sphere_properties,
        surface_properties as surface_properties,
        tetrahedron_properties as tetrahedron_properties,
        tube_properties as tube_properties,
    )

__getattr__, __dir__, __all__ = late(__name__)
