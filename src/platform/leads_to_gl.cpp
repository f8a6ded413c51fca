// Every symbol is libGL.so.1's, which this library needs.
