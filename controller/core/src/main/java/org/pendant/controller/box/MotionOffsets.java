package org.pendant.controller.box;

import org.pendant.controller.encoder.Encoders;
import org.pendant.motion.MotionControl;
import org.pendant.motion.offset.ConveyorTracking;
import org.pendant.motion.offset.PathOffsetting;

/**
 * Offsets that programs add to the path of their moves.
 *
 * @param encoders of conveyors
 * @param conveyor follows what an encoder measures
 * @param path displaces the path (manual 15.34 to 15.39)
 */
public record MotionOffsets(Encoders encoders, ConveyorTracking conveyor, PathOffsetting path) {

  /** Offsets that displace nothing yet. */
  static MotionOffsets of(MotionControl motion) {
    MotionOffsets offsets =
        new MotionOffsets(new Encoders(), new ConveyorTracking(), new PathOffsetting());
    motion.addOffset(offsets.conveyor);
    motion.addOffset(offsets.path);
    return offsets;
  }
}
