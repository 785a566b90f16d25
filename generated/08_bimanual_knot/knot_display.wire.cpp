// Written by suturec from 08_bimanual_knot/knot_display.h. Do not edit.
// It declares nothing that travels.
