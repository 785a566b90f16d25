// Written by suturec from 06_one_arm/motion_display.h. Do not edit.
// It declares nothing that travels.
