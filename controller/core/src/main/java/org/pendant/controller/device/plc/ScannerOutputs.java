package org.pendant.controller.device.plc;

import java.util.List;
import java.util.OptionalDouble;

/**
 * Scanner outputs: what a scanner of the cell writes to instance 112.
 *
 * @param bits boolean input registers 0 to 63, the lowest in bit 0
 * @param words integer input registers, from 0 on
 * @param speedFraction where the speed slider goes, 0 to 1; empty where its mask is not set
 */
public record ScannerOutputs(long bits, List<Integer> words, OptionalDouble speedFraction) {
  /** Copies the list. */
  public ScannerOutputs {
    words = List.copyOf(words);
  }
}
