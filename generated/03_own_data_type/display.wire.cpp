// Written by suturec from 03_own_data_type/display.h. Do not edit.
// It declares nothing that travels.
