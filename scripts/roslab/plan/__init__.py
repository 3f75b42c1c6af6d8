"""The plan: everything that is built, run and published, as one versioned value."""
