"""The laboratory in which the project is tested for real where no image can be pulled; `python3 tests/lab --help`."""
