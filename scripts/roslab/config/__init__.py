"""roslab.yaml, every generation of it, as one typed model."""
