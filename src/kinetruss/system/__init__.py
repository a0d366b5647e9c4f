"""A model compiled to flat arrays, and the order in which they are worked on."""

from kinetruss.kernels._plan import CABLE, ENGINEERING, GREEN, NONE
from kinetruss.system._arrange import RANK_TOLERANCE, Arrangement, arrange, jacobian, plan_of, rearrange
from kinetruss.system._continua import Continua, Patch, element_points, gradients, law_matrix
from kinetruss.system._system import DRIVEN, ELASTIC, FREE, RIGID, ByIdentity, System, compile

__all__ = [
    "CABLE", "Continua", "DRIVEN", "ELASTIC", "ENGINEERING", "FREE", "GREEN", "NONE", "RANK_TOLERANCE", "Patch", "RIGID",
    "Arrangement", "ByIdentity", "System", "arrange", "compile", "element_points", "gradients", "jacobian", "law_matrix",
    "plan_of", "rearrange",
]  # fmt: skip
