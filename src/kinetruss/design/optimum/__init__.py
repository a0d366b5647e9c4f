"""Least of a function within limits, with a certificate: numbers alone, no model.

`problem` says what is asked, `evaluations` asks once and remembers, `solvers` searches, `limits_at_work` picks the limits that
matter of very many, `certificate` proves the answer to first order, `contradictions` names limits that exclude each other,
`truss_sections` proves the lightest choice of sections of a truss by branch and bound.
"""
