"""Values that all rooms share; they import nothing of the program but its errors."""
