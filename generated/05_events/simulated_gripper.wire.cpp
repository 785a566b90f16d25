// Written by suturec from 05_events/simulated_gripper.h. Do not edit.
// It declares nothing that travels.
