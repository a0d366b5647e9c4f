"""Inside members: section forces, stresses, their largest values, sizes."""
