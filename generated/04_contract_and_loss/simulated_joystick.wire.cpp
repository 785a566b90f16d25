// Written by suturec from 04_contract_and_loss/simulated_joystick.h. Do not edit.
// It declares nothing that travels.
