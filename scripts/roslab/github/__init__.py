"""The only package that deals with GitHub: events, inputs, workflow commands, and what a job decides from them."""
