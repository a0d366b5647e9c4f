"""Inside members and elements: section forces, stresses."""
