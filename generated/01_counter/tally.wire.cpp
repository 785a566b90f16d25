// Written by suturec from 01_counter/tally.h. Do not edit.
// It declares nothing that travels.
