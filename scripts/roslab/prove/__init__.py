"""Running an image before it gets a tag: containers, their display, what they came to."""
