package org.pendant.controller.device.plc;

import java.util.Optional;

/**
 * Adapter port: the built-in EtherNet/IP assemblies of the controller, as a scanner of its cell
 * reaches them in robot time. What is read is what instance 100 had at the end of the frame before.
 * Belongs to the thread of the frame loop.
 */
public interface AdapterPort {
  /**
   * Takes all that instance 112 writes.
   *
   * @param owner what others are refused with
   * @return who else has some of it; empty when it is taken
   */
  Optional<String> claim(String owner);

  /**
   * Writes instance 112.
   *
   * @param owner who has taken it
   */
  void write(String owner, ScannerOutputs outputs);

  /** A scanner has been silent for too long: what it has taken is given back. */
  void lost(String owner);

  /** A boolean output register. */
  boolean outputBit(int address);

  /** An integer output register. */
  int outputWord(int address);

  /** The mode of the robot, -1 to 8. */
  int robotMode();

  /** Bit 0 power on, 1 program running, 2 teach button. */
  int robotStatus();

  /** The safety mode, 1 to 9. */
  int safetyMode();

  /** Bit 0 normal, 1 reduced, 2 protective stop, and so on to 10, any stop. */
  int safetyStatus();
}
