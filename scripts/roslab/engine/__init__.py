"""Docker, BuildKit and the registry: calls, credentials, retries, time limits."""
