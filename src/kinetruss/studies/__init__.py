"""Studies: many variants of a run, sampled, computed by many processes, kept in one ledger and summarised."""

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.studies.kept_numbers import scalars as scalars
    from kinetruss.studies.study_file import Sample as Sample, Study as Study, Variable as Variable, read_study as read_study
    from kinetruss.studies.study_result import StudyResult as StudyResult, load_study as load_study
    from kinetruss.studies.working import run_study as run_study

__getattr__, __dir__, __all__ = late(__name__)
