// Written by suturec from registration/registration_table.h. Do not edit.
// It declares nothing that travels.
