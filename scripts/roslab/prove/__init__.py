"""Running an image before it gets a tag: containers, their display, their results."""
