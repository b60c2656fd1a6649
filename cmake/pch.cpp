// Compiles cmake/pch.hpp once for all libraries.
