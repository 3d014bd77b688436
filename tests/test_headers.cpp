// Has only the headers that the test programs share, precompiled.
