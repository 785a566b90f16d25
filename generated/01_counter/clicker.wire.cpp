// Written by suturec from 01_counter/clicker.h. Do not edit.
// It declares nothing that travels.
