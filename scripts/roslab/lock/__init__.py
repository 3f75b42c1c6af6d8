"""What an image was made of: read from it, compared with another, looked for where it came from."""
