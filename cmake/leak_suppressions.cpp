// CLN leaks 26 bytes in its static initialisation. Linked into every program of a sanitized build.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libcln"; }
