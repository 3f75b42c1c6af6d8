"""Repairs: what plan and log together say must change in roslab.yaml, or in an author's own Dockerfile."""
