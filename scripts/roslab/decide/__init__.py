"""Evidence, configuration and knowledge → one decision per question, each with its reasons."""
