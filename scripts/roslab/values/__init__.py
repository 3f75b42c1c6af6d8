"""Values that every room shares; they import nothing of the program but its errors."""
