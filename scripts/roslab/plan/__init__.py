"""The plan: all that is built, run and published, as one versioned value."""
