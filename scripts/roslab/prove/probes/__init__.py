"""Programs that run in the containers of proofs, with the Python of the image: of the standard library alone."""
