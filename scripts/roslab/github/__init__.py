"""The only room that knows GitHub: events, inputs, workflow commands, and what a job decides from them."""
