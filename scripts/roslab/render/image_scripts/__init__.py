"""Scripts that generated Dockerfiles carry: the same in every image, complete files that run and lint as they stand."""
