"""Reading what a repository says about itself: one small reader per source, each returning facts with file and line."""
