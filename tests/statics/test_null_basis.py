"""The changes that rows allow are found also where LAPACK's divide and conquer does not converge."""

import numpy as np
import pytest
import scipy.linalg
from scipy.sparse import csr_array

from kinetruss.mechanics.rows import null_basis


@pytest.mark.parametrize("fails", [False, True])
def test_null_basis_where_divide_and_conquer_fails(monkeypatch, fails):
    whole = scipy.linalg.svd

    def svd(matrix, lapack_driver="gesdd"):
        if fails and lapack_driver == "gesdd":
            raise np.linalg.LinAlgError("SVD did not converge")
        return whole(matrix, lapack_driver=lapack_driver)

    monkeypatch.setattr(scipy.linalg, "svd", svd)
    J = np.array([[1.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, -1.0], [2.0, 2.0, 0.0, 0.0]])
    Z = null_basis(csr_array(J))
    assert Z.shape == (4, 2)
    np.testing.assert_allclose(J @ Z, 0, atol=1e-15)
    np.testing.assert_allclose(Z.T @ Z, np.eye(2), atol=1e-15)
