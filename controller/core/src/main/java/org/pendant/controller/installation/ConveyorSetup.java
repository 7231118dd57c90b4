package org.pendant.controller.installation;

import java.util.List;

/**
 * Conveyor that programs can follow.
 *
 * @param number 1 or 2
 * @param encoder 0 or 1
 * @param feature along whose y axis, or about whose z axis for a circular one, it goes
 * @param circular whether it turns
 * @param ticksPerUnit of the encoder: per metre, or per turn of a circular one
 * @param rotateTool whether the tool turns with a circular one
 * @param decoder type, 0 to 4, of encoder_enable_pulse_decode (manual 15.3)
 * @param inputs of the decoder: 8 to 11 for configurable inputs 0 to 3; empty for type 0, two for
 *     type 1, otherwise one
 */
public record ConveyorSetup(
    int number,
    int encoder,
    String feature,
    boolean circular,
    double ticksPerUnit,
    boolean rotateTool,
    int decoder,
    List<Integer> inputs) {
  public ConveyorSetup {
    inputs = List.copyOf(inputs);
  }
}
