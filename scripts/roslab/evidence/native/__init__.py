"""Readers of CMake files and of C++ and CUDA sources."""
